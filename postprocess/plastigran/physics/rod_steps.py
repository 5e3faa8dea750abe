# SPDX-License-Identifier: GPL-2.0-or-later
"""Impact of a rod with a tangential law, in which friction depends on the path of the tip."""

from __future__ import annotations

from typing import Any

import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.physics.rod import Rod, RodOutcome
from plastigran.physics.rod_motion import RodMotion

#: Recommended time step of the normal law / time step of the integration.
FINER = 12
#: Largest number of time steps of an impact.
MOST_STEPS = 20_000


class _RodInSteps(RodMotion):
    """Motion of a rod by velocity Verlet; `current` are the forces at the end of the last step."""

    def __init__(
        self, rod: Rod, law, speed: float, tangential: laws.PartialSlip | laws.Incremental
    ) -> None:
        super().__init__(rod, law, speed, law.pair.shear_modulus_eff)
        self.tangential = tangential
        self.tangential_state: Any = tangential.State()
        self.step = self.law.recommended_timestep(rod.tip_radius, rod.mass_eff, speed) / FINER
        self.current = (0.0, 0.0, 0.0)

    def forces(self, motion) -> tuple[float, float, float]:
        return self.current

    def tip(self, motion) -> float:
        """Return the position of the surface of the tip along the flat [m].

        The zero of the position is arbitrary, because only differences are used.
        """
        angle = self.lean + motion[2]
        return motion[0] - self.half * np.cos(angle) + self.rod.tip_radius * motion[2]

    def advance(self, motion) -> np.ndarray:
        """Return the motion after a time step, and update the contact histories."""
        after = motion.copy()
        after[3:6] += 0.5 * self.step * np.array(self.rate(0, motion)[3:6])
        after[:3] += self.step * after[3:6]
        contact = self.contact(after, self.state)
        friction = self.tangential.respond(
            contact.force,
            self.stiffness_per_radius * contact.contact_radius,
            self.tip(after) - self.tip(motion),
            state=self.tangential_state,
        )
        self.current = (contact.force, -friction.force_x, 0.0)
        after[3:6] += 0.5 * self.step * np.array(self.rate(0, after)[3:6])
        return after


def simulate_in_steps(
    rod: Rod, law, speed: float, tangential: laws.PartialSlip | laws.Incremental
) -> RodOutcome:
    """Integrate the impact of a rod by velocity Verlet, with 1/12 of the recommended time step.

    The equations of motion are those of `simulate`. The tangential law computes the friction.

    Args:
        rod: Rod, its angle and its friction.
        law: Law between rod and flat, an instance of a class of `plastigran.laws.LAWS`.
        speed: Downward speed of the rod before the impact [m/s]. The rod does not rotate before.
        tangential: Tangential law with the coefficient of friction of the rod.

    Raises:
        ValueError: As for `simulate`.
    """
    body = _RodInSteps(rod, law, speed, tangential)
    motions = [np.array(body.start, float)]
    rows = [body.history_row(0.0, motions[0])]
    while len(rows) < MOST_STEPS:
        motions.append(body.advance(motions[-1]))
        rows.append(body.history_row(len(rows) * body.step, motions[-1]))
        if rows[-1]["force"] <= 0:
            break
    else:
        raise ValueError(
            f"speed is {speed:g} m/s; at this speed, the weight of the rod keeps its tip in "
            "contact. Use a higher speed"
        )
    history, last = pd.DataFrame(rows), motions[-1]
    deepest = int(history["overlap"].idxmax())
    body.turn_back(motions[deepest])
    before, overlap_max, after = history["overlap"][deepest - 1 : deepest + 2]
    vertex = 0.5 * (before - after) / (before - 2 * overlap_max + after)
    separation = -body.closing_velocity(0, last)
    return RodOutcome(
        coefficient_of_restitution=separation / speed,
        angular_velocity=last[5],
        force_max=history["force"].max(),
        overlap_max=overlap_max,
        overlap_res=body.overlap_res,
        loading_time=(deepest + vertex) * body.step,
        contact_time=history["time"].iloc[-1] + body.left(0, last) / separation,
        history=history,
    )
