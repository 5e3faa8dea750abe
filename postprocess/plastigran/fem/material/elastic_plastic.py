# SPDX-License-Identifier: GPL-2.0-or-later
"""Small-strain von Mises plasticity with isotropic hardening, integrated by radial return.

Strains and stresses are columns (rr, yy, tt, ry) with engineering shear strain; t is the
circumferential direction. The return mapping is backward Euler with its consistent tangent (Simo
and Hughes, Computational Inelasticity, 1998, box 3.2).
"""

from __future__ import annotations

from math import sqrt

import attrs
import numpy as np

from plastigran.declared import number
from plastigran.fem.material.hardening import Hardening, RateFactor

IDENTITY = np.array([1.0, 1.0, 1.0, 0.0])
# Matrix from strains (rr, yy, tt, ry) to their deviator. The shear strain is halved: from
# engineering shear to a tensor component.
DEVIATOR = np.diag([1.0, 1.0, 1.0, 0.5]) - np.outer(IDENTITY, IDENTITY) / 3
TWICE_SHEAR = np.array([1.0, 1.0, 1.0, 2.0])
RETURN_ITERATIONS = 50
RETURN_TOLERANCE = 1e-13  # largest stress error of the radial return / trial stress


class NoReturnError(ArithmeticError):
    """The radial return to the yield surface does not converge."""


@attrs.frozen
class State:
    """State of n material points.

    Attributes:
        plastic_strain: Plastic strain (n, 4).
        accumulated: Accumulated plastic strain (n,).
        work: Plastic work per volume (n,), J/m3.
    """

    plastic_strain: np.ndarray
    accumulated: np.ndarray
    work: np.ndarray

    @classmethod
    def undeformed(cls, points: int) -> State:
        """Return the state of material points that have not yielded."""
        return cls(np.zeros((points, 4)), np.zeros(points), np.zeros(points))

    def split(self, first: int) -> tuple[State, State]:
        """Split the state: points before index `first`, and the remaining points."""
        halves = (np.split(column, [first]) for column in attrs.astuple(self))
        before, others = zip(*halves, strict=True)
        return State(*before), State(*others)

    def joined(self, other: State) -> State:
        """Return one state with these points, followed by the points of `other`."""
        columns = zip(attrs.astuple(self), attrs.astuple(other), strict=True)
        return State(*map(np.concatenate, columns))


@attrs.frozen
class Response:
    """Response of n material points to a strain increment.

    Attributes:
        stress: Stress (n, 4), Pa.
        state: State after the increment.
        flowing: Indices of the points that yield in the increment (k,).
        tangent: d stress / d strain of the yielding points (k, 4, 4), Pa.
    """

    stress: np.ndarray
    state: State
    flowing: np.ndarray
    tangent: np.ndarray

    def elastic(self) -> Response:
        """Return the same response with elastic tangents, to start an unloading."""
        return attrs.evolve(self, flowing=self.flowing[:0], tangent=self.tangent[:0])


@attrs.frozen(kw_only=True)
class ElasticPlastic:
    """Isotropic elastic-plastic metal; purely elastic if `hardening` is None."""

    youngs_modulus: float = number("Young's modulus", "Pa", 0)
    poissons_ratio: float = number("Poisson's ratio", "-", -1, 0.5)
    density: float = number("density", "kg/m3", 0, default=1.0)
    hardening: Hardening | None = None
    rate: RateFactor | None = None

    @property
    def shear_modulus(self) -> float:
        """Shear modulus G, Pa."""
        return self.youngs_modulus / (2 * (1 + self.poissons_ratio))

    @property
    def bulk_modulus(self) -> float:
        """Bulk modulus K, Pa."""
        return self.youngs_modulus / (3 * (1 - 2 * self.poissons_ratio))

    @property
    def plane_modulus(self) -> float:
        """Plane-strain modulus E/(1 - nu^2), Pa."""
        return self.youngs_modulus / (1 - self.poissons_ratio**2)

    @property
    def wave_speed(self) -> float:
        """Speed of compression waves, m/s."""
        return sqrt((self.bulk_modulus + 4 / 3 * self.shear_modulus) / self.density)

    def pair_modulus(self, other: ElasticPlastic | None) -> float:
        """Return the effective modulus E* of a contact, Pa; `other` is None for a rigid body."""
        if other is None:
            return self.plane_modulus
        return 1 / (1 / self.plane_modulus + 1 / other.plane_modulus)

    @property
    def elastic_tangent(self) -> np.ndarray:
        """Elastic tangent (4, 4), Pa."""
        volumetric = self.bulk_modulus * np.outer(IDENTITY, IDENTITY)
        return volumetric + 2 * self.shear_modulus * DEVIATOR

    def respond(self, strain: np.ndarray, state: State, duration: float = np.inf) -> Response:
        """Return the response at the end of an increment.

        Args:
            strain: Strain at the end of the increment (n, 4).
            state: State at its start.
            duration: Duration of the increment, s.
        """
        stress = (strain - state.plastic_strain) @ self.elastic_tangent
        if self.hardening is None:
            return Response(stress, state, np.empty(0, int), np.empty((0, 4, 4)))
        deviator = stress - stress @ IDENTITY[:, None] / 3 * IDENTITY
        mises = np.sqrt(1.5 * (deviator**2 @ TWICE_SHEAR))
        yield_strength, _ = self.hardening.flow_stress(state.accumulated)
        flowing = np.flatnonzero(mises > yield_strength)
        if flowing.size == 0:
            return Response(stress, state, flowing, np.empty((0, 4, 4)))
        trial = mises[flowing]
        step, flow, slope = self._flow(trial, state.accumulated[flowing], duration)
        # Deviator / von Mises stress; the direction of plastic flow is 3/2 times this tensor.
        direction = deviator[flowing] / trial[:, None]
        stress[flowing] -= (3 * self.shear_modulus * step)[:, None] * direction
        after = State(*(column.copy() for column in attrs.astuple(state)))
        after.plastic_strain[flowing] += (1.5 * step)[:, None] * direction * TWICE_SHEAR
        after.accumulated[flowing] += step
        after.work[flowing] += flow * step
        return Response(stress, after, flowing, self._tangent(trial, step, slope, direction))

    def _tangent(
        self, trial: np.ndarray, step: np.ndarray, slope: np.ndarray, direction: np.ndarray
    ) -> np.ndarray:
        shear = self.shear_modulus
        theta = 1 - 3 * shear * step / trial
        # Simo and Hughes use the unit normal n; here, d is `direction`. The factor 1.5 follows from
        # n n^T = 3/2 d d^T.
        normal = 1.5 * (1 / (1 + slope / (3 * shear)) - (1 - theta))
        return (
            self.bulk_modulus * np.outer(IDENTITY, IDENTITY)
            + 2 * shear * theta[:, None, None] * DEVIATOR
            - 2 * shear * normal[:, None, None] * direction[:, :, None] * direction[:, None, :]
        )

    def _flow(
        self, trial: np.ndarray, accumulated: np.ndarray, duration: float
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the increments of plastic strain, the flow stresses and their derivatives.

        The increments are found by Newton's method, with bisection as a fallback.
        """
        shear = self.shear_modulus
        low, high = np.zeros_like(trial), trial / (3 * shear)
        step = np.zeros_like(trial)
        for _ in range(RETURN_ITERATIONS):
            flow, slope = self._flow_stress(accumulated, step, duration)
            excess = trial - 3 * shear * step - flow
            if np.all(np.abs(excess) <= RETURN_TOLERANCE * trial):
                return step, flow, slope
            low, high = np.where(excess > 0, step, low), np.where(excess > 0, high, step)
            newton = step + excess / (3 * shear + slope)
            step = np.where((newton >= low) & (newton <= high), newton, (low + high) / 2)
        raise NoReturnError("the radial return to the yield surface does not converge")

    def _flow_stress(
        self, accumulated: np.ndarray, step: np.ndarray, duration: float
    ) -> tuple[np.ndarray, np.ndarray]:
        flow, slope = self.hardening.flow_stress(accumulated + step)
        if self.rate is None or not np.isfinite(duration):
            return flow, slope
        factor, factor_slope = self.rate.factor(step / duration)
        return flow * factor, slope * factor + flow * factor_slope / duration
