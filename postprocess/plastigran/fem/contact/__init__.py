# SPDX-License-Identifier: GPL-2.0-or-later
"""Contact of a body with a rigid plane, a half space or a rigid circle, by the penalty method."""
