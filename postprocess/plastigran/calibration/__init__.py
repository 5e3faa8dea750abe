# SPDX-License-Identifier: GPL-2.0-or-later
"""From what one can measure, or afford, to the constants of a deck."""
