# SPDX-License-Identifier: GPL-2.0-or-later
"""Impact of an elastic sphere on a rigid plane, and its vibration in flight.

After an impact, the vibration has only 1e-6 to 1e-2 of the impact energy. The time steps conserve
energy to round-off, so that numerical errors do not hide the vibration.
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
from plastigran.fem.sphere.throw import LONGEST
from plastigran.fem.sphere.vibration import Vibration
from plastigran.fem.stepping.conservative import SpringPlane, Steps
from plastigran.fem.stepping.flight import end_of_contact, follow
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.progress import ProgressBar

STEPS_OF_TRANSIT = 40  # number of time steps while a compression wave crosses the sphere
TRANSITS = 200.0  # default duration of the flight / time in which a wave crosses the sphere
WIDEST = 0.5  # largest a/R of an elastic impact
MODES = 12  # number of computed vibration modes


def vibrate(
    material: ElasticPlastic,
    radius: float,
    speed: float,
    transits: float = TRANSITS,
    settings: Settings | None = None,
    progress: bool = False,
) -> Vibration:
    """Compute the impact of an elastic sphere on a rigid plane, and its vibration in flight.

    Args:
        material: Material without hardening law, which is elastic.
        radius: Radius of the sphere, m.
        speed: Impact speed, m/s.
        transits: Duration of the flight divided by 2 R/c_l. This is the time in which a compression
            wave with the speed c_l crosses the sphere of radius R. Two frequencies are resolved
            if they differ by at least 8 c_l/(2 R transits).
        settings: Settings of mesh and time steps.
        progress: Whether to show a progress bar.

    Raises:
        ValueError: The metal yields; the speed is not positive or too large for small strain;
            finite strain is chosen; or transits is not positive.
        NoConvergence: The first step does not converge. A later failure ends the computation; the
            result so far is returned, with the reason in `stopped`.
    """
    settings = settings or Settings()
    sphere = HertzSphere(material, radius)
    if material.hardening is not None:
        raise ValueError(
            "material has a hardening law, but only elastic spheres are supported. Use "
            "hardening=None"
        )
    if settings.strain != "small":
        raise ValueError(f"strain is {settings.strain!r}; vibrations need strain='small'")
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
    history = _History(steps, radius)
    with ProgressBar(total=100, shown=progress, desc="vibrate", unit="%") as bar:
        stopped = follow(
            steps, history.record, bar, duration, LONGEST, free_time=transits * transit
        )
    return _summary(sphere, speed, pd.DataFrame(history.rows), steps, stopped)


class _History:
    """Recorder of the history of an impact: one row for the start and one for each time step."""

    def __init__(self, steps: Steps, radius: float) -> None:
        self.steps, self._before = steps, steps.now
        self.rows: list[dict[str, float]] = []
        elastic = steps.elastic
        self._mass = elastic.body.mass
        self._masses = elastic.mass_matrix @ elastic.upward
        self._top = elastic.nearest((0.0, 2 * radius), vertical=True)
        self._equator = elastic.nearest((radius, radius), vertical=False)
        self.record()

    def record(self) -> float:
        """Append a row for the last time step to the history; return its contact force, N."""
        now, before = self.steps.now, self._before
        self._before = now
        rise = float(self._masses @ now.displacement) / self._mass
        velocity = float(self._masses @ now.velocity) / self._mass
        middle = (before.displacement + now.displacement) @ (
            before.elastic_force + now.elastic_force
        )
        self.rows.append(
            {
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
        )
        return now.force


def _summary(
    sphere: HertzSphere, speed: float, history: pd.DataFrame, steps: Steps, stopped: str
) -> Vibration:
    elastic, now = steps.elastic, steps.now
    frequencies, shapes = elastic.vibrations(MODES)
    modes = {
        "frequency": frequencies,
        "energy": elastic.modal_energies(frequencies, shapes, now.displacement, now.velocity),
        "contact_displacement": np.abs(shapes[elastic.nearest((0.0, 0.0), vertical=True)]),
    }
    force, time = history["force"].to_numpy(), history["time"].to_numpy()
    # Subtract half a time step, because the recorded force is the force at the middle of the step.
    contact_time = end_of_contact(time, force, 2 / 3) - steps.timestep / 2
    flight = history.iloc[np.flatnonzero(force)[-1] + 1 :]
    kinetic = history["kinetic_energy"].iloc[0]
    last = history.iloc[-1]
    internal = last["kinetic_energy"] - last["centre_kinetic_energy"] + last["elastic_energy"]
    return Vibration(
        material=sphere.material,
        radius=sphere.radius,
        speed=speed,
        timestep=steps.timestep,
        history=history,
        modes=pd.DataFrame(modes),
        coefficient_of_restitution=nan if stopped else float(last["velocity"]) / speed,
        kinetic_restitution=nan if stopped else sqrt(flight["kinetic_energy"].mean() / kinetic),
        force_max=float(force.max()),
        overlap_max=float(history["approach"].max()),
        contact_time=nan if stopped else contact_time,
        vibration_energy=nan if stopped else float(internal / kinetic),
        stopped=stopped,
    )
