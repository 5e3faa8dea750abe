# SPDX-License-Identifier: GPL-2.0-or-later
"""Finite-element computations of elastic-plastic bodies in contact.

The contacts are a sphere on a plane or a half space, and a rigid cylinder on a body.
"""
