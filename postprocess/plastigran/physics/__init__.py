# SPDX-License-Identifier: GPL-2.0-or-later
"""Closed forms and integrations the runs are held against: numpy and scipy only."""
