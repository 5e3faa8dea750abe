# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes of eight-node quadrilaterals that are finest at the contact."""
