# SPDX-License-Identifier: GPL-2.0-or-later
"""Run LIGGGHTS or LAMMPS, follow the progress of a run and read its output."""
