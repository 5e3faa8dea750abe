# SPDX-License-Identifier: GPL-2.0-or-later
"""Computed tables and figures for pages of the docs, and HTML reports on results of users."""
