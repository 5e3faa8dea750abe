# SPDX-License-Identifier: GPL-2.0-or-later
"""Material models, and relations between displacements and strains."""
