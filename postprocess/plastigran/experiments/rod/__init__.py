# SPDX-License-Identifier: GPL-2.0-or-later
"""The oblique rod: the rigid body that falls on a flat, its motion, its runs, its figures."""

from plastigran.experiments.rod.body import (
    PAPER_FRICTION,
    PAPER_RESTITUTION,
    MeasuredRun,
    Rod,
    RodImpact,
    paper_rods,
)
from plastigran.physics.rod import simulate

__all__ = [
    "PAPER_FRICTION",
    "PAPER_RESTITUTION",
    "MeasuredRun",
    "Rod",
    "RodImpact",
    "paper_rods",
    "simulate",
]
