# SPDX-License-Identifier: GPL-2.0-or-later
"""Increments and time steps, and what is read from where they end."""
