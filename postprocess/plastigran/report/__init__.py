# SPDX-License-Identifier: GPL-2.0-or-later
"""Reports: computed tables and figures, and the pages that show them."""
