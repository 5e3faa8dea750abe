# SPDX-License-Identifier: GPL-2.0-or-later
"""Load increments and time steps of a body in contact, and snapshots of the fields."""
