# SPDX-License-Identifier: GPL-2.0-or-later
"""Decks of many grains: run, checked and drawn."""
