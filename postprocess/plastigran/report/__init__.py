# SPDX-License-Identifier: GPL-2.0-or-later
"""Evidence for pages of the docs, and reports: HTML pages on the user's results."""
