# SPDX-License-Identifier: GPL-2.0-or-later
"""Out of the plane of a mesh: a ring about the axis, or a slab of some thickness."""

from __future__ import annotations

from math import pi
from typing import Protocol

import attrs
import numpy as np

from plastigran.declared import number


class Section(Protocol):
    """What a plane mesh stands for."""

    def thickness(self, first: np.ndarray) -> np.ndarray:
        """Out of the plane, m, at first coordinates, m."""

    def hoop(self, first: np.ndarray) -> np.ndarray:
        """Strain out of the plane over the first displacement, 1/m."""


@attrs.frozen
class Axisymmetric(Section):
    """The whole ring about the axis where the first coordinate is zero."""

    def thickness(self, first: np.ndarray) -> np.ndarray:
        return 2 * pi * first

    def hoop(self, first: np.ndarray) -> np.ndarray:
        return 1 / first


@attrs.frozen
class PlaneStrain(Section):
    """A slab that does not strain out of its plane."""

    length: float = number("length out of the plane", "m", 0)

    def thickness(self, first: np.ndarray) -> np.ndarray:
        return np.full_like(first, self.length)

    def hoop(self, first: np.ndarray) -> np.ndarray:
        return np.zeros_like(first)
