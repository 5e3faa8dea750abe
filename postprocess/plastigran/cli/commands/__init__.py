# SPDX-License-Identifier: GPL-2.0-or-later
"""Subcommands of `plastigran`, one module each, found by name."""
