# SPDX-License-Identifier: GPL-2.0-or-later
"""Impact of a rigid cylinder on an elastic-plastic body in plane strain, head-on or sliding.

The motion of body and cylinder is computed by implicit time integration, as in `fem.sphere.throw`.
The body is half a disc with a fixed arc. The radius of the disc is the thickness of the body in
Johnson's formula for the approach of a line contact (Contact Mechanics, 1985, sec. 5.6). The
default thickness is so large that no wave returns from the arc during the contact.
"""

from __future__ import annotations

import numpy as np

from plastigran.fem.body.struck import StruckBody
from plastigran.fem.contact.circle import RigidCircle, Rub
from plastigran.fem.cylinder.case import CylinderStrike
from plastigran.fem.cylinder.struck import Strike, StrikeLog
from plastigran.fem.limits import SMALL_STRAIN, warn_of_small_strain
from plastigran.fem.mesh.block import HalfBlock, TrackBlock
from plastigran.fem.settings import Settings
from plastigran.fem.stepping.flight import Flight, follow
from plastigran.fem.stepping.increment import Balance, Equations, Equilibrium, Forces, NoConvergence
from plastigran.progress import ProgressBar

SHARES = (1.0, 0.5, 0.25, 0.1)  # fractions of the Newton change that the line search tries
LONGEST = 4.0  # longest computed time of an impact / duration of an elastic contact
# Largest sliding distance per step / element length. With larger steps, Newton's method fails.
STRIDE = 0.3
# Path of the circle on the finely meshed track / sliding distance during an elastic contact.
TRACK_MARGIN = 1.2


class StrikeEquations(Equations):
    """Equations of motion of a body and a rigid circle on its surface."""

    body: StruckBody
    contact: RigidCircle

    def _touch(self, displacement: np.ndarray, start: Equilibrium | None) -> Rub:
        return self.contact.touch(displacement, start and start.touch)

    def _matrices(
        self, displacement: np.ndarray, balance: Balance, factor: float
    ) -> list[np.ndarray]:
        elements, edges = super()._matrices(displacement, balance, factor)
        edges = edges.copy()  # do not add the mass of the circle to the shared contact matrices
        edges[0, -2:, -2:] += factor * self.body.center_mass * np.identity(2)
        return [elements, edges]

    def _step(
        self, displacement: np.ndarray, change: np.ndarray, balance: Balance, forces: Forces
    ) -> tuple[np.ndarray, Balance]:
        """Return the displacements after a Newton iteration with line search, and their balance.

        The full Newton change often fails, because points come into contact and start to yield
        while the circle slides. The line search tries the fractions SHARES of the change. It uses
        the largest that improves the balance of forces; if there is none, the smallest.

        Raises:
            NoConvergence: Even the smallest fraction turns an element inside out.
        """
        before = np.linalg.norm(balance.residual)
        for share in SHARES:
            trial = displacement + share * change
            try:
                trial_balance = forces(trial)
            except NoConvergence:
                if share == SHARES[-1]:
                    raise
                continue
            if np.linalg.norm(trial_balance.residual) < before:
                break
        return trial, trial_balance


def equations(case: CylinderStrike, settings: Settings) -> StrikeEquations:
    """Return the equations of an impact: mesh, body and circle."""
    reach, line = case.reach, case.line
    if case.oblique:
        path = TRACK_MARGIN * case.sliding_speed * line.duration(case.mass, case.speed)
        block = TrackBlock(
            half_length=path / 2 + 2 * reach,
            element=reach / settings.divisions / settings.fineness,
            depth=2 * reach,
            size=line.thickness,
        )
        length, start = case.length, -path / 2
        track = (-block.half_length, block.half_length)
    else:
        block = HalfBlock(
            core=min(reach / 2, line.half_width(line.yield_force)),
            reach=reach,
            size=line.thickness,
            divisions=settings.divisions,
            fineness=settings.fineness,
        )
        # By symmetry, half of the body is enough. Its double length gives the full force.
        length, start = 2 * case.length, 0.0
        track = (0.0, 2 * reach)
    body = StruckBody(block.build(), case.material, length, case.mass, settings.kinematics)
    circle = RigidCircle(
        body, case.radius, track, start, case.coefficient_of_friction, settings.penalty
    )
    return StrikeEquations(body, circle)


def strike(
    case: CylinderStrike, settings: Settings | None = None, progress: bool = False
) -> Strike:
    """Compute the impact of a cylinder until the cylinder has separated from the body.

    Args:
        case: Impact.
        settings: Settings of mesh and time steps. `steps_of_contact` is the number of time steps
            during the elastic contact.
        progress: Whether to show a progress bar.

    Raises:
        NoConvergence: The first step does not converge even after halving. A later failure ends the
            computation; the result so far is returned, with the reason in `stopped`.
    """
    settings = settings or Settings()
    if settings.strain == "small" and case.reach > SMALL_STRAIN * case.radius:
        warn_of_small_strain(
            f"speed {case.speed:g} m/s gives a contact half width of about "
            f"{case.reach / case.radius:.2g} times the radius"
        )
    system = equations(case, settings)
    velocity = np.zeros(system.body.size)
    velocity[system.body.center] = case.sliding_speed, -case.speed
    duration = case.line.duration(case.mass, case.speed)
    timestep = duration / settings.steps_of_contact
    if case.oblique:
        timestep = min(timestep, STRIDE * system.contact.longest_edge / case.sliding_speed)
    log = StrikeLog(Flight(system, velocity, timestep))
    with ProgressBar(total=100, shown=progress, desc="strike", unit="% of elastic") as bar:
        stopped = follow(
            log.flight, log.record, bar, duration, LONGEST, free_steps=settings.free_steps
        )
    return log.summary(case, stopped)
