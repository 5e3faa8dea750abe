# SPDX-License-Identifier: GPL-2.0-or-later
"""Load increments and time steps, and snapshots of their results."""
