# SPDX-License-Identifier: GPL-2.0-or-later
"""Closed forms that set the scales of steps and meshes, and are reference solutions."""
