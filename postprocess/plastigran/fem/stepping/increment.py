# SPDX-License-Identifier: GPL-2.0-or-later
"""One load increment or time step of a body in contact, solved by Newton's method."""

from __future__ import annotations

from collections.abc import Callable

import attrs
import numpy as np

from plastigran.fem.body.body import Body
from plastigran.fem.body.pair import Pair
from plastigran.fem.contact.circle import RigidCircle
from plastigran.fem.contact.plane import RigidPlane, Touch
from plastigran.fem.material.elastic_plastic import NoReturnError, Response, State
from plastigran.fem.material.stretch import InvertedError
from plastigran.fem.stepping.linear import SingularError, SymmetricSystem

ITERATIONS = 16
# Largest residual / largest nodal force. In `press`, only contact forces count; in `move`, all.
TOLERANCE = 1e-5
FORCE_TOLERANCE = 1e-8  # largest error of the contact force / prescribed force


class NoConvergence(ArithmeticError):
    """Newton's method did not find the equilibrium of a load increment or time step."""


@attrs.frozen
class Equilibrium:
    """Equilibrium state of a body in contact.

    Attributes:
        displacement: Nodal displacements (size,), m.
        height: Height of the plane, m.
        response: Material response.
        touch: Contact state.
    """

    displacement: np.ndarray
    height: float
    response: Response
    touch: Touch


@attrs.frozen
class Inertia:
    """Inertia in a time step dt of the trapezoidal rule.

    The accelerations at the end of the step are 4/dt^2 (u - predicted), with the displacements u.

    Attributes:
        predicted: u + dt v + dt^2 a/4 (size,), m, with the displacements u, velocities v and
            accelerations a at the start of the step.
        timestep: dt, s.
    """

    predicted: np.ndarray
    timestep: float


@attrs.frozen
class Balance:
    """Forces on a body at the displacements of one Newton iteration.

    Attributes:
        response: Material response.
        touch: Contact state.
        residual: Internal minus contact plus inertial nodal forces (size,), N; 0 at fixed degrees
            of freedom.
        scale: Largest nodal force, internal, contact or inertial, N.
    """

    response: Response
    touch: Touch
    residual: np.ndarray
    scale: float


Forces = Callable[[np.ndarray], Balance]


class Equations:
    """Balance of forces of a body in contact with a plane, a half space or a circle."""

    def __init__(self, body: Body | Pair, contact: RigidPlane | RigidCircle) -> None:
        self.body, self.contact = body, contact
        self._system = SymmetricSystem([body.dofs, contact.dofs], body.size, body.fixed)

    def at_rest(self) -> Equilibrium:
        """Return the equilibrium of the undeformed body at first touch."""
        body = self.body
        displacement = np.zeros(body.size)
        response = self._respond(displacement, State.undeformed(body.points))
        return Equilibrium(displacement, 0.0, response, self._touch(displacement, None))

    def press(
        self, start: Equilibrium, guess: tuple[np.ndarray, float], force: float
    ) -> Equilibrium:
        """Return the equilibrium of a supported body that the plane presses with a force, N.

        `start` is the last equilibrium. `guess` contains the nodal displacements and the height of
        the plane, m, from which Newton's method starts.

        Raises:
            NoConvergence: Newton's method failed.
        """
        body = self.body
        displacement, height = guess
        for _ in range(ITERATIONS):
            response = self._respond(displacement, start.response.state)
            touch = self.contact.touch(displacement, height)
            if touch.force == 0:
                raise NoConvergence("the contact opens")
            residual = body.internal_force(displacement, response.stress) - touch.nodal
            residual[self.body.fixed] = 0
            excess = force - touch.force
            balanced = np.max(np.abs(residual)) <= TOLERANCE * np.max(np.abs(touch.nodal))
            if balanced and abs(excess) <= FORCE_TOLERANCE * force:
                return Equilibrium(displacement, height, response, touch)
            change = self._bordered(
                body.stiffness(displacement, response), touch.stiffness, -residual, excess
            )
            displacement, height = displacement + change[0], height + change[1]
        raise NoConvergence(f"no equilibrium at {force:g} N in {ITERATIONS} iterations")

    def predict(self, start: Equilibrium, force: float) -> tuple[np.ndarray, float]:
        """Return the initial guess for `press` after a load reversal.

        The guess is the elastic response from the equilibrium `start` to the contact force `force`,
        N, while the same points stay in contact.
        """
        change = self._bordered(
            self.body.stiffness(start.displacement, start.response.elastic()),
            start.touch.stiffness,
            np.zeros(self.body.size),
            force - start.touch.force,
        )
        return start.displacement + change[0], start.height + change[1]

    def _bordered(
        self, stiffness: np.ndarray, edges: np.ndarray, right: np.ndarray, excess: float
    ) -> tuple[np.ndarray, float]:
        """Return the Newton changes of the displacements (size,) and of the plane's height, m.

        Args:
            stiffness: Stiffness matrices of the elements, N/m.
            edges: Stiffness matrices of the contact edges, N/m.
            right: Right side of the linear system: nodal forces (size,), N.
            excess: Prescribed contact force minus present contact force, N.
        """
        column = self.contact.spread(edges)
        factor = self._factor([stiffness, edges])
        by_force, by_height = factor.solve(np.column_stack([right, column])).T
        support = (self.body.upward * column).sum() - column @ by_height
        if not support > 0:
            raise NoConvergence("the contact opens")
        rise = (excess + column @ by_force) / support
        return by_force + rise * by_height, float(rise)

    def _respond(
        self, displacement: np.ndarray, state: State, duration: float = np.inf
    ) -> Response:
        try:
            return self.body.respond(displacement, state, duration)
        except (InvertedError, NoReturnError) as error:
            raise NoConvergence(str(error)) from None

    def _factor(self, matrices: list[np.ndarray]):
        try:
            return self._system.factor(matrices)
        except SingularError as error:
            raise NoConvergence(str(error)) from None

    def move(self, start: Equilibrium, guess: np.ndarray, inertia: Inertia) -> Equilibrium:
        """Return the dynamic equilibrium at the end of a time step.

        `start` is the equilibrium at the start of the step. `guess` contains the nodal
        displacements, m, from which Newton's method starts.

        Raises:
            NoConvergence: Newton's method failed.
        """

        def forces(displacement: np.ndarray) -> Balance:
            return self._balance(displacement, start, inertia)

        displacement, balance = guess, forces(guess)
        for _ in range(ITERATIONS):
            if np.max(np.abs(balance.residual)) <= TOLERANCE * balance.scale:
                response, touch = balance.response, balance.touch
                return Equilibrium(displacement, start.height, response, touch)
            matrices = self._matrices(displacement, balance, 4 / inertia.timestep**2)
            change = self._factor(matrices).solve(-balance.residual)
            displacement, balance = self._step(displacement, change, balance, forces)
        raise NoConvergence(f"no balance of forces in {ITERATIONS} iterations")

    def _balance(self, displacement: np.ndarray, start: Equilibrium, inertia: Inertia) -> Balance:
        body = self.body
        response = self._respond(displacement, start.response.state, inertia.timestep)
        touch = self._touch(displacement, start)
        inertial = 4 / inertia.timestep**2 * (body.mass_matrix @ (displacement - inertia.predicted))
        internal = body.internal_force(displacement, response.stress)
        residual = internal - touch.nodal + inertial
        residual[self.body.fixed] = 0
        scale = max(np.max(np.abs(part)) for part in (touch.nodal, internal, inertial))
        return Balance(response, touch, residual, scale)

    def _step(
        self, displacement: np.ndarray, change: np.ndarray, balance: Balance, forces: Forces
    ) -> tuple[np.ndarray, Balance]:
        """Return the displacements after a Newton iteration, and their balance of forces.

        Subclasses may shorten `change` by a line search.
        """
        return displacement + change, forces(displacement + change)

    def _touch(self, displacement: np.ndarray, start: Equilibrium | None) -> Touch:
        return self.contact.touch(displacement, 0.0 if start is None else start.height)

    def _matrices(
        self, displacement: np.ndarray, balance: Balance, factor: float
    ) -> list[np.ndarray]:
        """Return element and contact stiffness matrices, plus `factor` times the mass matrices."""
        body = self.body
        stiffness = body.stiffness(displacement, balance.response)
        return [stiffness + factor * body.mass_matrices, balance.touch.stiffness]
