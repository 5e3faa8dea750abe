# SPDX-License-Identifier: GPL-2.0-or-later
"""What a body meets: a plane, a half space, a rigid circle."""
