# SPDX-License-Identifier: GPL-2.0-or-later
"""The subcommands of `plastigran`, one module each, found by name."""
