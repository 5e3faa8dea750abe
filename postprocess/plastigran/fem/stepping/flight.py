# SPDX-License-Identifier: GPL-2.0-or-later
"""Time steps of a body in contact, by the trapezoidal rule, from first touch to separation.

Newton's method starts each step from a linear extrapolation of the last step. If it started from
u + dt v, with the displacements u and velocities v, points could yield that do not yield in the
solution.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf

import attrs
import numpy as np

from plastigran.fem.stepping.increment import Equations, Equilibrium, Inertia, NoConvergence
from plastigran.progress import ProgressBar

FIRST_STEP = 1 / 16  # first time step / full time step; short, because the contact starts stiffly
STEP_GROWTH = 1.5
CUTS = 6  # largest number of halvings of a step


@attrs.frozen
class Motion:
    """Motion of a body at one time.

    Attributes:
        time: Time, s.
        state: State of the body, with its balance of forces.
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
        """Start at first touch with nodal velocities (size,), m/s; `timestep` is in s."""
        self.equations, self.timestep = equations, timestep
        self.now = Motion(0.0, equations.at_rest(), velocity, np.zeros(velocity.size))
        self._step = FIRST_STEP * timestep
        self._last_change, self._last_step = np.zeros(velocity.size), inf

    def advance(self) -> None:
        """Compute the next time step; halve the step if it does not converge.

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
            return
        raise NoConvergence(
            f"the time step at {self.now.time:g} s does not converge, even after {CUTS} halvings"
        )

    def _advance(self, step: float) -> Motion:
        now = self.now
        start = now.state.displacement
        predicted = start + step * now.velocity + step**2 / 4 * now.acceleration
        guess = start + step / self._last_step * self._last_change
        state = self.equations.move(now.state, guess, Inertia(predicted, step))
        acceleration = 4 / step**2 * (state.displacement - predicted)
        self._last_change, self._last_step = state.displacement - start, step
        velocity = now.velocity + step / 2 * (now.acceleration + acceleration)
        return Motion(now.time + step, state, velocity, acceleration)


def follow(
    steps,
    record: Callable[[], float],
    bar: ProgressBar,
    duration: float,
    longest: float,
    free_steps: int = 0,
    free_time: float = 0.0,
) -> str:
    """Compute the time steps of an impact until the body has separated from the other body.

    The impact ends when the contact force has been zero for `free_steps` steps and `free_time`.

    Args:
        steps: `Flight`, or another object with `advance()` and `now.time`.
        record: Function that is called after each step and returns the contact force, N.
        bar: Bar that shows the progress in per cent.
        duration: Expected duration of the contact, s.
        longest: Contact duration after which the computation stops, in multiples of `duration`.
        free_steps: Number of steps without contact at the end.
        free_time: Time without contact at the end, s.

    Returns:
        Reason for an early end; otherwise empty.

    Raises:
        NoConvergence: The first step does not converge.
    """
    free, contact_end = 0, 0.0
    while free < free_steps or steps.now.time - contact_end < free_time:
        try:
            steps.advance()
        except NoConvergence as error:
            if steps.now.time == 0:
                raise
            return str(error)
        if record():
            free, contact_end = 0, steps.now.time
        else:
            free += 1
        bar.update(100 * steps.now.time / (duration + free_time) - bar.n)
        if contact_end > longest * duration:
            return (
                f"the contact has not ended after {contact_end:g} s, {longest:g} times its "
                "expected duration"
            )
    return ""


def end_of_contact(time: np.ndarray, force: np.ndarray, power: float) -> float:
    """Return the time at which the contact force reaches zero, s.

    The last two steps in contact are extrapolated, with (force)^`power` linear in time. The result
    is at most the time of the next step.
    """
    last = np.flatnonzero(force > 0)[-1]
    next_time = float(time[min(last + 1, time.size - 1)])
    if last == 0:
        return next_time
    before, after = force[last - 1] ** power, force[last] ** power
    if after >= before:
        return next_time
    end = time[last] + after * (time[last] - time[last - 1]) / (before - after)
    return min(float(end), next_time)
