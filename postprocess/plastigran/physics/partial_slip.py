# SPDX-License-Identifier: GPL-2.0-or-later
"""Oblique elastic impacts with partial slip (Maw, Barber & Fawcett 1976, Wear 38:101).

The contact sticks in its middle and slips at its edge. The tangential contact of Cattaneo and
Mindlin is a superposition of normal contacts. While the overlap grows from d to d + dd, the contact
area grows by a ring. The ring carries the tangential force D F'(d) dd, where F(d) is the normal
force. It shifts the surfaces by D (E*/4G*) dd, with the effective moduli E* and G*. Each ring keeps
its friction ratio D, with -mu <= D <= mu, until the ring slips; mu is the coefficient of friction.

Sources: Jaeger 1993, Arch. Appl. Mech. 63:402; Aleshin, Bou Matar & Van Den Abeele 2015, Int. J.
Solids Struct. 60 (method of memory diagrams).
"""

from __future__ import annotations

import attrs

from plastigran.physics import central
from plastigran.physics.oblique import Motion, ObliqueImpact

#: Default number of time steps per impact. The tangential restitution then has an error of 2e-5.
STEPS = 500


@attrs.define
class Rings:
    """Rings into which the contact area is divided, from the middle outward.

    Attributes:
        friction: Coefficient of friction mu, the largest friction ratio D of a ring [-].
        compliance: Tangential compliance / normal compliance, E*/(4 G*) [-].
        overlap: Present overlap, in any unit of length.
        rings: For each ring, two overlaps and the friction ratio D. At these overlaps, the edge of
            the contact was at the inner edge and at the outer edge of the ring.
    """

    friction: float
    compliance: float
    overlap: float = 0.0
    rings: list[tuple[float, float, float]] = attrs.Factory(list)

    def force(self) -> float:
        """Return the tangential force, divided by the normal force at the overlap 1 [-]."""
        return sum(share * (end**1.5 - begin**1.5) for begin, end, share in self.rings)

    def move(self, overlap: float, shift: float) -> None:
        """Move the bodies to a new overlap, and by the distance `shift` along the surface.

        Shift and overlap have the same unit. The rings deform elastically by a part of the shift.
        If the friction limit is reached in all rings, the bodies slide by the rest.
        """
        wanted = shift
        if overlap > self.overlap:
            grown = self.compliance * (overlap - self.overlap)
            share = min(max(wanted / grown, -self.friction), self.friction)
            self.rings.append((self.overlap, overlap, share))
            wanted = wanted - share * grown if abs(share) == self.friction else 0.0
        else:
            wanted += self._cut(overlap)
        self.overlap = overlap
        if wanted:
            self._slip(wanted)

    def _cut(self, overlap: float) -> float:
        """Remove the rings outside the contact area after the overlap has decreased to `overlap`.

        Returns:
            Tangential displacement of the removed rings [m].
        """
        held = 0.0
        while self.rings and self.rings[-1][1] > overlap:
            begin, end, share = self.rings.pop()
            inner = max(begin, overlap)
            held += self.compliance * share * (end - inner)
            if inner > begin:
                self.rings.append((begin, inner, share))
        return held

    def _slip(self, wanted: float) -> None:
        """Let rings slip, from the edge inward, until the bodies have moved by `wanted`."""
        full = self.friction if wanted > 0 else -self.friction
        front = self.overlap
        while self.rings and wanted * full > 0:
            begin, end, share = self.rings.pop()
            gain = self.compliance * (full - share)
            if abs(gain) * (end - begin) > abs(wanted):
                front = end - wanted / gain
                self.rings.append((begin, front, share))
                break
            wanted -= gain * (end - begin)
            front = begin
        self.rings.append((front, self.overlap, full))


def partial_slip(impact: ObliqueImpact, steps: int = STEPS) -> Motion:
    """Return the motion after an oblique impact of elastic bodies with partial slip.

    The normal motion, including the dashpot, is as in `ObliqueImpact.spring_slider`. The friction
    limit is the coefficient of friction times the elastic pressure, without the dashpot. This
    omission changes the friction impulse only in second order of the damping. The lever arm of the
    friction is the radius of the sphere.

    Args:
        impact: Impact of one sphere on a plane.
        steps: Approximate number of time steps during the impact.

    Raises:
        ValueError: Both bodies move, or the coefficient of friction is zero.
    """
    if impact.mass_eff != impact.mass or impact.coefficient_of_friction == 0:
        raise ValueError(
            f"partial slip needs a sphere on a plane with friction, but mass_other is "
            f"{impact.mass_other:g} and coefficient_of_friction is "
            f"{impact.coefficient_of_friction:g}. Use mass_other inf and a positive coefficient"
        )
    pair, speed = impact.pair, impact.before.normal
    compliance = pair.youngs_modulus_eff / (4 * pair.shear_modulus_eff)
    rings = Rings(impact.coefficient_of_friction, compliance)
    damping = float(central.damping_ratio(impact.coefficient_of_restitution))

    # Units: closing speed, largest overlap and mass, as in `oblique._SpringSlider`.
    def normal_force(overlap: float, rate: float) -> float:
        return 1.25 * overlap**1.5 + 2.5 * damping * overlap**0.25 * rate

    half = 1.5 / steps  # length of a time step; the contact lasts 2.94 in these units
    overlap, rate, friction = 0.0, 1.0, 0.0
    along, turning = impact.before.along / speed, impact.before.spin * impact.radius / speed
    while True:
        rate -= normal_force(overlap, rate) * half
        along, turning = along - friction * half, turning - 2.5 * friction * half
        following = overlap + 2 * half * rate
        if following <= 0:
            return Motion(-rate * speed, along * speed, turning * speed / impact.radius)
        rings.move(following, 2 * half * (along + turning))
        overlap, friction = following, 1.25 * rings.force()
        rate -= normal_force(overlap, rate) * half
        along, turning = along - friction * half, turning - 2.5 * friction * half
