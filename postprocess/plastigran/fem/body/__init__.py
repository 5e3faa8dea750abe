# SPDX-License-Identifier: GPL-2.0-or-later
"""Bodies in eight-node elements: strains, forces, stiffness and mass."""
