# SPDX-License-Identifier: GPL-2.0-or-later
"""Flow stress as a function of accumulated plastic strain, and its rate factor."""

from __future__ import annotations

from typing import Protocol

import attrs
import numpy as np

from plastigran.declared import number


class Hardening(Protocol):
    """Flow stress of a metal as a function of the accumulated plastic strain."""

    yield_strength: float

    def flow_stress(self, strain: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return flow stresses and their derivatives with respect to strain, both (n,), Pa."""


@attrs.frozen
class LinearHardening(Hardening):
    """Linear hardening sigma = sigma_Y + H eps_p; perfectly plastic for H = 0."""

    yield_strength: float = number("uniaxial yield stress", "Pa", 0)
    modulus: float = number(
        "plastic modulus: slope of flow stress over plastic strain",
        "Pa",
        0,
        lower_allowed=True,
        default=0.0,
    )

    def flow_stress(self, strain: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return self.yield_strength + self.modulus * strain, np.full_like(strain, self.modulus)


def _increasing(instance: TabulatedHardening, field: attrs.Attribute, value: tuple) -> None:
    least = 1e-15 if field.name == "strains" else 0
    if len(value) < 2 or not np.all(np.isfinite(value)) or np.any(np.diff(value) < least):
        raise ValueError(
            f"{field.name} is {value}; it must be two or more finite values that increase"
        )


@attrs.frozen
class TabulatedHardening(Hardening):
    """Flow stress that is linear between the points of a table, and constant beyond the last point.

    Attributes:
        strains: Accumulated plastic strains, starting at 0.
        stresses: Flow stresses, Pa; the first is the yield stress.
    """

    strains: tuple[float, ...] = attrs.field(converter=tuple, validator=_increasing)
    stresses: tuple[float, ...] = attrs.field(converter=tuple, validator=_increasing)

    def __attrs_post_init__(self) -> None:
        if len(self.strains) != len(self.stresses) or self.strains[0] != 0:
            raise ValueError(
                f"the hardening table has {len(self.strains)} strains from {self.strains[0]:g} and "
                f"{len(self.stresses)} stresses. Use equal numbers, and start at strain 0"
            )
        if self.stresses[0] <= 0:
            raise ValueError(f"stresses starts with {self.stresses[0]:g} Pa; it must be positive")

    @property
    def yield_strength(self) -> float:
        """Flow stress at zero plastic strain, Pa."""
        return self.stresses[0]

    def flow_stress(self, strain: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        slopes = np.append(np.diff(self.stresses) / np.diff(self.strains), 0.0)
        piece = np.searchsorted(self.strains, strain, side="right") - 1
        start, stress = np.asarray(self.strains)[piece], np.asarray(self.stresses)[piece]
        return stress + slopes[piece] * (strain - start), slopes[piece]


@attrs.frozen
class RateFactor:
    """Factor of Johnson and Cook (1983) by which the strain rate raises the flow stress.

    The factor is 1 + C ln(rate / reference) above the reference rate, and 1 below this rate. C is
    the rate coefficient.
    """

    coefficient: float = number("rate coefficient C", "-", 0, lower_allowed=True)
    reference_rate: float = number("strain rate up to which the factor is 1", "1/s", 0, default=1.0)

    def factor(self, rate: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the factor [-] on the flow stress, and its derivative by the strain rate, s."""
        above = rate > self.reference_rate
        safe = np.where(above, rate, self.reference_rate)
        factor = 1 + self.coefficient * np.log(safe / self.reference_rate)
        return factor, np.where(above, self.coefficient / safe, 0.0)
