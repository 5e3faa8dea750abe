# SPDX-License-Identifier: GPL-2.0-or-later
"""Extent of a mesh out of its plane: a ring about the axis, or a slab."""

from __future__ import annotations

from math import pi
from typing import Protocol

import attrs
import numpy as np

from plastigran.declared import number


class Section(Protocol):
    """Extent of a plane mesh out of its plane."""

    def thickness(self, first: np.ndarray) -> np.ndarray:
        """Return the thickness out of the plane, m, at first coordinates, m."""

    def hoop(self, first: np.ndarray) -> np.ndarray:
        """Return the strain out of the plane per first displacement, 1/m."""


@attrs.frozen
class Axisymmetric(Section):
    """Full ring about the axis, where the first coordinate is zero."""

    def thickness(self, first: np.ndarray) -> np.ndarray:
        return 2 * pi * first

    def hoop(self, first: np.ndarray) -> np.ndarray:
        return 1 / first


@attrs.frozen
class PlaneStrain(Section):
    """Slab without strain out of its plane."""

    length: float = number("length out of the plane", "m", 0)

    def thickness(self, first: np.ndarray) -> np.ndarray:
        return np.full_like(first, self.length)

    def hoop(self, first: np.ndarray) -> np.ndarray:
        return np.zeros_like(first)
