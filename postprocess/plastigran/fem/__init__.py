# SPDX-License-Identifier: GPL-2.0-or-later
"""Finite elements of one elastic-plastic sphere on a rigid plane: pressed, or thrown at it."""
