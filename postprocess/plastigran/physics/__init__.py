# SPDX-License-Identifier: GPL-2.0-or-later
"""Closed forms and numerical integrations for comparison with runs; numpy and scipy only."""
