# SPDX-License-Identifier: GPL-2.0-or-later
"""Plastigran: elasto-plastic contact laws for LIGGGHTS, and the lab that proves them."""
