# SPDX-License-Identifier: GPL-2.0-or-later
"""Impact of a rigid cylinder on an elastic-plastic body in plane strain, head-on or sliding.

Implicit dynamics of body and cylinder, as for the sphere. The body is half a disc with a fixed arc.
Its radius is the thickness in Johnson's approach of a line contact (Contact Mechanics, 1985,
sec. 5.6), or so large that no wave returns from the arc during the contact.
"""

from __future__ import annotations

import warnings
from math import inf

import numpy as np

from plastigran.fem.body.section import PlaneStrain
from plastigran.fem.body.struck import StruckBody
from plastigran.fem.contact.circle import RigidCircle, Rub
from plastigran.fem.cylinder.case import CylinderStrike
from plastigran.fem.cylinder.struck import Strike, StrikeLog, summary
from plastigran.fem.limits import SMALL_STRAIN, SmallStrainWarning
from plastigran.fem.mesh.block import HalfBlock, TrackBlock
from plastigran.fem.settings import Settings
from plastigran.fem.stepping.flight import Flight
from plastigran.fem.stepping.increment import Balance, Equations, Equilibrium, Forces, NoConvergence
from plastigran.progress import ProgressBar

SHARES = (1.0, 0.5, 0.25, 0.1)  # fractions of a Newton change
LONGEST = 4.0  # number of elastic contact durations after which an impact is stopped
# Largest sliding distance in a step, in elements; Newton's method fails for larger ones.
STRIDE = 0.3
TRACK_MARGIN = 1.2  # factor on the sliding distance during an elastic contact


class StrikeEquations(Equations):
    """Balance of forces of a body and a circle on it."""

    body: StruckBody
    contact: RigidCircle

    def _touch(self, displacement: np.ndarray, start: Equilibrium | None) -> Rub:
        return self.contact.touch(displacement, start and start.touch)

    def _matrices(
        self, displacement: np.ndarray, balance: Balance, factor: float
    ) -> list[np.ndarray]:
        elements, edges = super()._matrices(displacement, balance, factor)
        edges = edges.copy()  # contact matrices, without the mass of the circle
        edges[0, -2:, -2:] += factor * self.body.centre_mass * np.identity(2)
        return [elements, edges]

    def _step(self, displacement: np.ndarray, change: np.ndarray, balance: Balance, forces: Forces):
        """Return the largest of some fractions of the change that improves the balance of forces.

        Points come into contact and start to flow as the circle slides. The smallest fraction is
        taken
        even without improvement.

        Raises:
            NoConvergence: Even the smallest fraction turns an element inside out.
        """
        before = np.linalg.norm(balance.residual)
        for share in SHARES:
            tried = displacement + share * change
            try:
                found = forces(tried)
            except NoConvergence:
                if share == SHARES[-1]:
                    raise
                continue
            if np.linalg.norm(found.residual) < before:
                break
        return tried, found


def equations(case: CylinderStrike, settings: Settings) -> StrikeEquations:
    """Return the equations of an impact: mesh, body and circle."""
    reach, line = case.reach, case.line
    if not case.oblique:
        core = reach / 2
        if line.yield_force < inf:
            core = min(core, line.half_width(line.yield_force))
        block = HalfBlock(
            core=core,
            reach=reach,
            size=line.thickness,
            divisions=settings.divisions,
            fineness=settings.fineness,
        )
        section = PlaneStrain(2 * case.length)  # half of the body represents the whole
        track, start = (0.0, 2 * reach), 0.0
    else:
        way = TRACK_MARGIN * case.sliding_speed * line.duration(case.mass, case.speed)
        block = TrackBlock(
            half_length=way / 2 + 2 * reach,
            element=reach / settings.divisions / settings.fineness,
            depth=2 * reach,
            size=line.thickness,
        )
        section = PlaneStrain(case.length)
        track = (-block.half_length, block.half_length)
        start = -way / 2
    body = StruckBody(block.build(), case.material, section, case.mass, settings.kinematics)
    circle = RigidCircle(
        body, case.radius, track, start, case.coefficient_of_friction, settings.penalty
    )
    return StrikeEquations(body, circle)


def strike(
    case: CylinderStrike, settings: Settings | None = None, progress: bool = False
) -> Strike:
    """Compute the impact of a cylinder until it has separated.

    Args:
        case: Impact.
        settings: Resolution, as for the sphere; `steps_of_contact` refers to the elastic duration.
        progress: Whether to show a bar.

    Raises:
        NoConvergence: The first step does not converge even after halving. A later failure ends the
            computation; the result so far is returned, with the reason in `stopped`.
    """
    settings = settings or Settings()
    if settings.strain == "small" and case.reach > SMALL_STRAIN * case.radius:
        warnings.warn(
            f"speed {case.speed:g} m/s gives a contact half width of about "
            f"{case.reach / case.radius:.2g} times the radius; small strain is accurate up to "
            f"{SMALL_STRAIN:g}",
            SmallStrainWarning,
            stacklevel=2,
        )
    balance = equations(case, settings)
    velocity = np.zeros(balance.body.size)
    velocity[balance.body.centre] = case.sliding_speed, -case.speed
    duration = case.line.duration(case.mass, case.speed)
    timestep = duration / settings.steps_of_contact
    if case.oblique:
        timestep = min(timestep, STRIDE * balance.contact.longest_edge / case.sliding_speed)
    flight = Flight(balance, velocity, timestep)
    log = StrikeLog(flight)
    stopped = ""
    with ProgressBar(total=100, shown=progress, desc="strike", unit="% of elastic") as bar:
        while log.free < settings.free_steps and not stopped:
            try:
                flight.advance()
            except NoConvergence as error:
                stopped = str(error)
                continue
            log.note()
            bar.update(100 * flight.now.time / duration - bar.n)
            if flight.now.time > LONGEST * duration:
                stopped = f"the contact has not ended after {flight.now.time:g} s"
    if len(log.rows) == 1:
        raise NoConvergence(stopped)
    return summary(case, log, stopped)
