# SPDX-License-Identifier: GPL-2.0-or-later
"""How figures look, and figures that several rooms share."""
