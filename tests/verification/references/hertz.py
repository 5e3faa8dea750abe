# SPDX-License-Identifier: GPL-2.0-or-later
"""Hertz (1881): the force is F = 4/3 E* sqrt(R*) d^1.5 at an overlap d, without loss of energy."""

from __future__ import annotations

from math import inf

from references.central_impact import CentralImpact


class Reference(CentralImpact):
    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        self.pieces = [(inf, self.hertz)]
