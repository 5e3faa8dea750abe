# SPDX-License-Identifier: GPL-2.0-or-later
"""Closed forms: scales of steps and meshes, and reference solutions."""
