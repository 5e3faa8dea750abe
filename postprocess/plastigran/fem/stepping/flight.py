# SPDX-License-Identifier: GPL-2.0-or-later
"""Time steps of a body in contact: the trapezoidal rule.

The Newton iteration of a step starts from the extrapolated displacement of the last step. With
u + dt v as start, points could yield that do not yield in the solution.
"""

from __future__ import annotations

import attrs
import numpy as np

from plastigran.fem.stepping.increment import Equations, Equilibrium, Inertia, NoConvergence

FIRST_STEP = 1 / 16  # fraction of the full time step, because the contact starts stiffly
STEP_GROWTH = 1.5
CUTS = 6  # how often a step is halved before the computation stops


@attrs.frozen
class Motion:
    """Motion of a body at one time.

    Attributes:
        time: Time, s.
        state: Balance of forces.
        velocity: Velocities (size,), m/s.
        acceleration: Accelerations (size,), m/s2.
    """

    time: float
    state: Equilibrium
    velocity: np.ndarray
    acceleration: np.ndarray


class Flight:
    """Time steps of a body in contact.

    Attributes:
        equations: Balance of forces of the body.
        timestep: Full time step, s.
        now: Motion at the end of the last step.
    """

    def __init__(self, equations: Equations, velocity: np.ndarray, timestep: float) -> None:
        """Set the initial motion.

        Args:
            equations: Balance of forces of a body that just touches.
            velocity: Initial velocity (size,), m/s.
            timestep: Full time step, s.
        """
        self.equations, self.timestep = equations, timestep
        self.now = Motion(0.0, equations.at_rest(), velocity, np.zeros(velocity.size))
        self._step = FIRST_STEP * timestep
        self._change: tuple[np.ndarray, float] | None = None

    def advance(self) -> Motion:
        """Return the motion after the next step; halve the step if it does not converge.

        Raises:
            NoConvergence: The step does not converge after CUTS halvings.
        """
        for _ in range(CUTS + 1):
            try:
                self.now = self._advance(self._step)
            except NoConvergence:
                self._step /= 2
                continue
            self._step = min(self._step * STEP_GROWTH, self.timestep)
            return self.now
        raise NoConvergence(f"no step from {self.now.time:g} s after {CUTS} halvings")

    def _advance(self, step: float) -> Motion:
        now = self.now
        moved, velocity = now.state.displacement, now.velocity
        predicted = moved + step * velocity + step**2 / 4 * now.acceleration
        guess = moved
        if self._change is not None:
            guess = moved + step / self._change[1] * self._change[0]
        state = self.equations.move(now.state, guess, Inertia(predicted, step))
        acceleration = 4 / step**2 * (state.displacement - predicted)
        self._change = (state.displacement - moved, step)
        return Motion(
            now.time + step,
            state,
            velocity + step / 2 * (now.acceleration + acceleration),
            acceleration,
        )
