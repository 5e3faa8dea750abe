# SPDX-License-Identifier: GPL-2.0-or-later
"""Bodies of eight-node elements: strains, forces, stiffness and mass."""
