# SPDX-License-Identifier: GPL-2.0-or-later
"""Pages made of computed tables and figures: what a report is, and how its pages are written."""
