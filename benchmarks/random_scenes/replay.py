# SPDX-License-Identifier: GPL-2.0-or-later
"""Compute the forces and energies of a scene from the positions of its particles.

The positions of the particles alone determine the contacts of every frame. The history of a contact
begins when the overlap begins, and ends when the overlap ends. No command in the deck changes a
history.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from events import AXES
from frames import Frame
from scene import Scene

from plastigran import laws


@dataclass
class Contact:
    """Law and history of a contact.

    The law has the yield strength at the strain rate of first touch.
    """

    law: laws.Law
    state: object = None
    plastic_work: float = 0.0


@dataclass
class Replay:
    """Replay of a scene, frame by frame.

    Attributes:
        scene: Scene.
        contacts: Contacts by the names of two particles, or of a particle and a wall.
        plastic_work: Plastic work of all contacts since the start [J].
        contacts_begun: Number of contacts that began.
    """

    scene: Scene
    contacts: dict[tuple, Contact] = field(default_factory=dict)
    plastic_work: float = 0.0
    contacts_begun: int = 0
    _laws: dict[tuple[int, int], laws.Law] = field(default_factory=dict)

    def forces(
        self, names: np.ndarray, frame: Frame, begins: bool
    ) -> tuple[np.ndarray, float, float]:
        """Return forces [N], elastic energy and plastic work [J]; update the histories.

        In a step, LIGGGHTS computes the forces with velocities from half a step earlier. At the
        start of a run, LIGGGHTS uses the velocities of the frame.

        Args:
            names: Names of the particles, the same in all runs.
            frame: Frame of the dump.
            begins: Whether a run begins with the frame.
        """
        radius, types = frame.radius, frame.types
        velocity = frame.velocity
        if not begins:
            velocity = velocity - 0.5 * self.scene.timestep * frame.force / frame.mass[:, None]
        force, elastic, touching = np.zeros_like(frame.place), 0.0, set()
        for i, j, normal, overlap in self._meetings(frame.place, radius):
            if isinstance(j, str):
                name, other = (names[i], j), self.scene.wall_type
                radius_eff, closing = radius[i], -velocity[i] @ normal
            else:
                name, other = tuple(sorted((names[i], names[j]))), types[j]
                radius_eff = radius[i] * radius[j] / (radius[i] + radius[j])
                closing = -(velocity[i] - velocity[j]) @ normal
            touching.add(name)
            response = self._respond(name, (types[i], other), radius_eff, overlap, closing)
            force[i] += response.force * normal
            if not isinstance(j, str):
                force[j] -= response.force * normal
            elastic += response.elastic_energy
        for name in self.contacts.keys() - touching:
            del self.contacts[name]
        return force, elastic, self.plastic_work

    def _respond(self, name, types, radius_eff, overlap, closing):
        contact = self.contacts.get(name)
        if contact is None:
            law = self._law(*sorted(types))
            if law.pair.rate_coefficient > 0 and closing > 0:
                law = law.at_impact(radius_eff, closing)
            contact = self.contacts[name] = Contact(law, law.State())
            self.contacts_begun += 1
        response = contact.law.respond(radius_eff, overlap, contact.state, closing)
        self.plastic_work += response.plastic_work - contact.plastic_work
        contact.plastic_work = response.plastic_work
        return response

    def _law(self, one: int, other: int) -> laws.Law:
        if (one, other) not in self._laws:
            self._laws[one, other] = self.scene.law(one, other)
        return self._laws[one, other]

    def _meetings(self, place, radius) -> Iterator[tuple[int, int | str, np.ndarray, float]]:
        """Yield the contacts: particle i, particle j or a wall, unit vector to i, overlap [m]."""
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
