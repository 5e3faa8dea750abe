# SPDX-License-Identifier: GPL-2.0-or-later
"""A sphere on a plane or a half space: quasi-static compression, impact, vibration."""
