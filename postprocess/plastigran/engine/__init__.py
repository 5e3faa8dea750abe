# SPDX-License-Identifier: GPL-2.0-or-later
"""Run LIGGGHTS, follow its progress and read its output."""
