# SPDX-License-Identifier: GPL-2.0-or-later
"""Style of figures, and figures that several subpackages use."""
