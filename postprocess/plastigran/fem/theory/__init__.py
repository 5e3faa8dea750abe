# SPDX-License-Identifier: GPL-2.0-or-later
"""Formulas of elastic contact: reference solutions, and estimates for choosing meshes and steps."""
