# SPDX-License-Identifier: GPL-2.0-or-later
"""An elastic sphere thrown at a rigid plane and followed while it vibrates in flight.

Energy is conserved to rounding, so that the vibration an impact leaves, 1e-6 to 1e-2 of its energy,
is told from what the steps would lose.
"""

from __future__ import annotations

from math import inf, nan, sqrt

import numpy as np
import pandas as pd

from plastigran.fem.body.body import Body
from plastigran.fem.body.elastic import ElasticBody
from plastigran.fem.contact.edges import contact_edge
from plastigran.fem.limits import check_speed, force_of_impact
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.throw import LONGEST, end_of_contact
from plastigran.fem.sphere.vibration import Vibration
from plastigran.fem.stepping.conservative import SpringPlane, Steps
from plastigran.fem.stepping.increment import NoConvergence
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.progress import ProgressBar

STEPS_OF_TRANSIT = 40  # time steps while a compression wave crosses the sphere
TRANSITS = 200.0
WIDEST = 0.5  # a/R up to which an elastic impact is computed
MODES = 12  # free vibrations looked for


def vibrate(
    material: ElasticPlastic,
    radius: float,
    speed: float,
    transits: float = TRANSITS,
    settings: Settings | None = None,
    progress: bool = False,
) -> Vibration:
    """Throw an elastic sphere at a rigid plane and follow its vibration in flight.

    Args:
        material: Without hardening.
        radius: Of the sphere, m.
        speed: Towards the plane, m/s.
        transits: Length of the flight over the time 2 R/c_l a compression wave takes across the
            sphere. Two frequencies are told apart where they differ by 8 c_l/(2 R transits).
        settings: How fine.
        progress: Show a bar.

    Raises:
        ValueError: A metal that yields; a speed that is not positive, or so large that small
            strain does not hold; finite strain; transits that are not positive.
        NoConvergence: The first step does not converge. A later one ends the computation, which
            keeps what it has and says so in `stopped`.
    """
    settings = settings or Settings()
    sphere = HertzSphere(material, radius)
    if material.hardening is not None:
        raise ValueError("material has a hardening law; only an elastic sphere is followed")
    if settings.strain != "small":
        raise ValueError(
            f"strain is {settings.strain!r}; vibrations are computed in 'small' strain"
        )
    if not 0 < transits < inf:
        raise ValueError(f"transits is {transits:g}; it must be positive and finite")
    check_speed(sphere, speed, WIDEST)
    transit = 2 * radius / material.wave_speed
    duration = sphere.duration(speed)
    timestep = min(duration / settings.steps_of_contact, transit / STEPS_OF_TRANSIT)
    reach = force_of_impact(sphere, speed)[1]
    body = Body(settings.mesh(sphere, reach, whole=True).build(), material)
    plane = SpringPlane(body, radius, min(2 * reach, 0.9 * radius), settings.penalty)
    elastic = ElasticBody(body)
    steps = Steps(elastic, plane, -speed * elastic.upward, timestep)
    watch = _Watch(steps, radius)
    rows, end, stopped = [watch.row()], transits * transit, ""
    with ProgressBar(total=100, shown=progress, desc="vibrate", unit="%") as bar:
        left = 0.0
        while steps.now.time - left < end and not stopped:
            try:
                steps.advance()
            except NoConvergence as error:
                stopped = str(error)
                continue
            rows.append(watch.row())
            left = steps.now.time if rows[-1]["force"] else left
            bar.update(100 * steps.now.time / (duration + end) - bar.n)
            if left > LONGEST * duration:
                stopped = f"the contact has not ended after {left:g} s"
    if len(rows) == 1:
        raise NoConvergence(stopped)
    return _summary(material, radius, speed, pd.DataFrame(rows), steps, stopped)


class _Watch:
    """Reads a row of the history after each step."""

    def __init__(self, steps: Steps, radius: float) -> None:
        self.steps, self._before = steps, steps.now
        elastic = steps.elastic
        self._mass = elastic.body.mass
        self._masses = elastic.mass_matrix @ elastic.upward
        self._top = elastic.nearest((0.0, 2 * radius), vertical=True)
        self._equator = elastic.nearest((radius, radius), vertical=False)

    def row(self) -> dict[str, float]:
        now, before = self.steps.now, self._before
        self._before = now
        rise = float(self._masses @ now.displacement) / self._mass
        velocity = float(self._masses @ now.velocity) / self._mass
        middle = (before.displacement + now.displacement) @ (
            before.elastic_force + now.elastic_force
        )
        return {
            "time": now.time,
            "force": now.force,
            "approach": -rise,
            "velocity": velocity,
            "contact_radius": contact_edge(self.steps.plane.radii, now.gap),
            "kinetic_energy": now.kinetic_energy,
            "centre_kinetic_energy": self._mass * velocity**2 / 2,
            "elastic_energy": now.elastic_energy,
            "middle_elastic_energy": float(middle) / 8,
            "penalty_energy": self.steps.plane.energy(now.gap),
            "top_displacement": float(now.displacement[self._top]) - rise,
            "equator_displacement": float(now.displacement[self._equator]),
        }


def _summary(
    material: ElasticPlastic,
    radius: float,
    speed: float,
    history: pd.DataFrame,
    steps: Steps,
    stopped: str,
) -> Vibration:
    elastic, now = steps.elastic, steps.now
    frequencies, shapes = elastic.vibrations(MODES)
    energies = elastic.modal_energies(frequencies, shapes, now.displacement, now.velocity)
    contact = elastic.nearest((0.0, 0.0), vertical=True)
    force, time = history["force"].to_numpy(), history["time"].to_numpy()
    touching = np.flatnonzero(force)
    flight = history.iloc[touching[-1] + 1 :]
    kinetic = history["kinetic_energy"].iloc[0]
    last = history.iloc[-1]
    internal = last["kinetic_energy"] - last["centre_kinetic_energy"] + last["elastic_energy"]
    # The force of a step is that of its middle.
    end = end_of_contact(time[: touching[-1] + 2], force[: touching[-1] + 2]) - steps.timestep / 2
    return Vibration(
        material=material,
        radius=radius,
        speed=speed,
        timestep=steps.timestep,
        history=history,
        modes=pd.DataFrame(
            {
                "frequency": frequencies,
                "energy": energies,
                "contact_displacement": np.abs(shapes[contact]),
            }
        ),
        coefficient_of_restitution=nan if stopped else float(last["velocity"]) / speed,
        kinetic_restitution=nan if stopped else sqrt(flight["kinetic_energy"].mean() / kinetic),
        force_max=float(force.max()),
        overlap_max=float(history["approach"].max()),
        contact_time=nan if stopped else float(end),
        vibration_energy=nan if stopped else float(internal / kinetic),
        stopped=stopped,
    )
