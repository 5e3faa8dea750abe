# SPDX-License-Identifier: GPL-2.0-or-later
"""What the contact laws are held against, and how far off they are."""
