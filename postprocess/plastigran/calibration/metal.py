# SPDX-License-Identifier: GPL-2.0-or-later
"""A calibrated metal: constants for the laws, and their uncertainty."""

from __future__ import annotations

from math import inf

import attrs

from plastigran import laws
from plastigran.calibration.deck_lines import deck_lines
from plastigran.calibration.drop_test import DropTest
from plastigran.calibration.expected_errors import ExpectedError
from plastigran.calibration.finite_elements import PressedSphere
from plastigran.materials import Material

#: Constants of the law `vu_quoc_zhang` that are fitted to finite elements.
FITTED = ("contact_radius_coefficient", "curvature_coefficient")
#: Constants of a body that a deck contains only if they are not zero.
OPTIONAL = ("tangent_modulus", "rate_coefficient")


@attrs.frozen
class CalibratedMetal:
    """Result of `calibrate`.

    Attributes:
        material: Metal for `plastigran.Contact`.
        yield_strength_interval: 95 % confidence interval [Pa]. If the yield strength was given,
            both ends equal this strength. The upper end is infinite if the measurement gives only
            a lower bound.
        source: Source of the yield strength and of its interval.
        law: Name of the law to use.
        expected_error: Expected error of this law.
        yield_speed: Yield speed [m/s] of the ball on the plate of the drop test. Without drop test,
            of a sphere of the metal on a rigid plane.
        notes: Remarks for the user, one sentence each.
        drops: Drop test, if the metal was calibrated from drops.
        pressed: Finite-element compression, if it was requested.
    """

    material: Material
    yield_strength_interval: tuple[float, float]
    source: str
    law: str
    expected_error: ExpectedError
    yield_speed: float
    notes: tuple[str, ...] = ()
    drops: DropTest | None = None
    pressed: PressedSphere | None = None

    @property
    def yield_strength(self) -> float:
        """Yield strength [Pa]."""
        return self.material.yield_strength

    @property
    def constants(self) -> dict[str, float]:
        """Constants C_a P_Y/a_Y and K_c P_Y of the law `vu_quoc_zhang` [-], by name.

        C_a [m/N] and K_c [1/N] are the constants in the paper of Vu-Quoc and Zhang. P_Y and a_Y are
        force and contact radius at first yield. If finite elements of this metal were computed, the
        constants are fitted to their results. Otherwise, the constants are the defaults of the law,
        which hold for perfectly plastic metals up to a force of 41 P_Y.
        """
        if self.pressed is not None:
            return {name: getattr(self.pressed.fitted, name) for name in FITTED}
        parameters = laws.LAWS["vu_quoc_zhang"].parameters()
        return {row["name"]: row["default"] for row in parameters if row["name"] in FITTED}

    def to_dict(self) -> dict:
        """Return all numbers in SI units; None for an infinite end of the interval."""
        error, interval = self.expected_error, self.yield_strength_interval
        fitted = self.constants if self.pressed is None else self.pressed.fitted.to_dict()
        return {
            "yield_strength": self.yield_strength,
            "yield_strength_interval": [None if end == inf else end for end in interval],
            "source": self.source,
            "law": self.law,
            "expected_error": error.restitution,
            "expected_error_largest": error.restitution_largest,
            "expected_force_error": error.force,
            "expected_force_error_largest": error.force_largest,
            "speed_ratio": list(error.speed_ratio),
            "yield_speed": self.yield_speed,
            "notes": list(self.notes),
        } | fitted

    def deck_lines(self) -> list[str]:
        """Return the lines of a deck in which atom type 1 is the metal."""
        names = ["youngs_modulus", "poissons_ratio", "yield_strength"]
        names += [name for name in OPTIONAL if getattr(self.material, name)]
        body = {name: getattr(self.material, name) for name in names}
        fitted = self.law == "vu_quoc_zhang" or self.pressed is not None
        pair = self.constants if fitted else {}
        return deck_lines(f"{self.law} tangential history", body, pair, "  # for vu_quoc_zhang")

    @property
    def remark(self) -> str:
        """Source of the strength as a sentence, for the header of a material file."""
        return f"Yield strength from {self.source}; 95 % interval {self._interval()} Pa."

    def __str__(self) -> str:
        """Return a summary as readable text."""
        bodies = "a sphere on a rigid plane"
        if self.drops is not None:
            bodies = f"drops of {self.drops.ball_name} on {self.drops.plate_name}"
        lines = {
            "yield strength": f"{self.yield_strength:.4g} Pa, 95 % interval {self._interval()} Pa",
            "from": self.source,
            "law": self.law,
            "expected error": self.expected_error,
            "yield speed": f"{self.yield_speed:.3g} m/s for {bodies}",
        } | {f"note {k}": note for k, note in enumerate(self.notes, start=1)}
        return "\n".join(f"{name:20s}{text}" for name, text in lines.items())

    def __repr__(self) -> str:
        return (
            f"CalibratedMetal({self.material.name!r}, yield_strength={self.yield_strength:.4g} Pa "
            f"({self._interval()}), law={self.law!r})"
        )

    def _interval(self) -> str:
        least, largest = self.yield_strength_interval
        return f"above {least:.4g}" if largest == inf else f"{least:.4g} to {largest:.4g}"
