# SPDX-License-Identifier: GPL-2.0-or-later
"""Theory for comparison with simulations: closed forms, and integrated equations of motion."""
