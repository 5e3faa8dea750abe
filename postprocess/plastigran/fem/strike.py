# SPDX-License-Identifier: GPL-2.0-or-later
"""A rigid cylinder strikes an elastic-plastic body in plane strain, head-on or sliding along."""

from __future__ import annotations

import numpy as np

from plastigran.fem.circle import RigidCircle, Rub, StruckBody
from plastigran.fem.increment import Equations, Equilibrium
from plastigran.fem.material import Response


class StrikeEquations(Equations):
    """Balance of forces of a body and of the circle on it."""

    body: StruckBody
    plane: RigidCircle

    def _touch(self, displacement: np.ndarray, start: Equilibrium | None) -> Rub:
        return self.plane.touch(displacement, start and start.touch)

    def _matrices(self, response: Response, touch: Rub, factor: float) -> list[np.ndarray]:
        elements, edges = super()._matrices(response, touch, factor)
        edges[0, -2:, -2:] += factor * self.body.centre_mass * np.identity(2)
        return [elements, edges]
