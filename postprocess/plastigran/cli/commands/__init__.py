# SPDX-License-Identifier: GPL-2.0-or-later
"""Subcommands of `plastigran`: one module per command, with the name of the command."""
