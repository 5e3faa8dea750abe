# SPDX-License-Identifier: GPL-2.0-or-later
"""What a scene's positions say of its forces and energies: numpy and the laws, without the engine.

Contacts are found anew in every frame from the centres alone. A contact's history begins at its
first overlap and ends when none is left; nothing else changes it, whatever the deck does.
"""

from __future__ import annotations

from collections.abc import Iterator
from copy import copy
from dataclasses import dataclass, field

import numpy as np
from events import AXES
from frames import Frame
from scene import Scene

from plastigran import laws


@dataclass
class Memory:
    """A contact's law, with its strength at the rate of the first touch, and its history."""

    law: laws.Law
    state: object = None
    plastic_work: float = 0.0


@dataclass
class Replay:
    """Follows a scene frame by frame.

    Attributes:
        scene: What is followed.
        contacts: By the names of two particles, or of one and a wall.
        plastic_work: Of all contacts since the begin [J].
        touched: How many contacts began.
    """

    scene: Scene
    contacts: dict[tuple, Memory] = field(default_factory=dict)
    plastic_work: float = 0.0
    touched: int = 0
    _laws: dict[tuple[int, int], laws.Law] = field(default_factory=dict)

    def forces(
        self, names: np.ndarray, frame: Frame, begins: bool
    ) -> tuple[np.ndarray, float, float]:
        """Return forces [N], elastic energy and plastic work [J]; update the histories.

        The engine asks for forces in the middle of a step, when velocities are half a step old. At
        the begin of a run it asks with those of the frame, and histories stay as they are: what
        plastic work a new overlap would do is told and not kept.

        Args:
            names: Of each particle, the same in all runs.
            frame: A row for each particle.
            begins: Whether a run begins with it.
        """
        radius, kinds = frame.radius, frame.types
        velocity = frame.velocity
        if not begins:
            velocity = velocity - 0.5 * self.scene.timestep * frame.force / frame.mass[:, None]
        force, elastic, passing, seen = np.zeros_like(frame.place), 0.0, 0.0, set()
        for i, j, normal, overlap in self._meetings(frame.place, radius):
            if isinstance(j, str):
                name, other = (names[i], j), self.scene.wall_type
                radius_eff, closing = radius[i], -velocity[i] @ normal
            else:
                name, other = tuple(sorted((names[i], names[j]))), kinds[j]
                radius_eff = radius[i] * radius[j] / (radius[i] + radius[j])
                closing = -(velocity[i] - velocity[j]) @ normal
            seen.add(name)
            answer, kept = self._ask(
                name, (kinds[i], other), radius_eff, overlap, closing, not begins
            )
            force[i] += answer.force * normal
            if not isinstance(j, str):
                force[j] -= answer.force * normal
            elastic += answer.elastic_energy
            passing += answer.plastic_work - kept if begins else 0
        for name in self.contacts.keys() - seen:
            del self.contacts[name]
        return force, elastic, self.plastic_work + passing

    def _ask(self, name, kinds, radius_eff, overlap, closing, remember):
        contact = self.contacts.get(name)
        if contact is None:
            law = self._law(*sorted(kinds))
            if law.pair.rate_coefficient > 0 and closing > 0:
                law = law.at_impact(radius_eff, closing)
            contact = Memory(law, law.State())
            if remember:
                self.contacts[name] = contact
                self.touched += 1
        state = contact.state if remember else copy(contact.state)
        answer = contact.law.respond(radius_eff, overlap, state, closing)
        if remember:
            work = contact.law.respond(radius_eff, 0.0, state).plastic_work
            self.plastic_work += work - contact.plastic_work
            contact.plastic_work = work
        return answer, contact.plastic_work

    def _law(self, one: int, other: int) -> laws.Law:
        if (one, other) not in self._laws:
            self._laws[one, other] = self.scene.law(one, other)
        return self._laws[one, other]

    def _meetings(self, place, radius) -> Iterator[tuple[int, int | str, np.ndarray, float]]:
        """Pairs and walls with an overlap: i, j or the wall, unit vector towards i, overlap [m]."""
        periodic = np.array([axis not in self.scene.walled for axis in AXES])
        apart = place[:, None] - place[None]
        side = self.scene.high - self.scene.low
        apart -= np.where(periodic, side * np.round(apart / side), 0)
        distance = np.sqrt((apart**2).sum(axis=-1))
        overlap = radius[:, None] + radius[None] - distance
        for i, j in np.argwhere(np.triu(overlap > 0, k=1)):
            yield i, j, apart[i, j] / distance[i, j], overlap[i, j]
        for k, axis in enumerate(AXES):
            if periodic[k]:
                continue
            for end, inward in ((self.scene.low[k], 1.0), (self.scene.high[k], -1.0)):
                depth = radius - inward * (place[:, k] - end)
                for i in np.flatnonzero(depth > 0):
                    yield i, f"{axis}{inward}", inward * np.eye(3)[k], depth[i]
