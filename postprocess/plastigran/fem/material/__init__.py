# SPDX-License-Identifier: GPL-2.0-or-later
"""What a material point answers to a strain, and which strain that is."""
