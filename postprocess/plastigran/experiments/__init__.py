# SPDX-License-Identifier: GPL-2.0-or-later
"""Collision experiments: case, prediction, measurement and figures of each."""
