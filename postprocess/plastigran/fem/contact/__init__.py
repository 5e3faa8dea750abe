# SPDX-License-Identifier: GPL-2.0-or-later
"""Counterparts of a body in contact: a plane, a half space, a rigid circle."""
