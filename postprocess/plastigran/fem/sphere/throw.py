# SPDX-License-Identifier: GPL-2.0-or-later
"""Impact of a sphere on a rigid plane or a half space.

The motion is integrated implicitly by the trapezoidal rule. The computation starts at first touch,
with the impact speed.
"""

from __future__ import annotations

from math import nan

import numpy as np
import pandas as pd

from plastigran.fem.limits import check_speed, force_of_impact
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.assembly import thrown
from plastigran.fem.sphere.results import Throw
from plastigran.fem.stepping.flight import Flight, end_of_contact, follow
from plastigran.fem.stepping.snapshot import energies, snapshot
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.progress import ProgressBar

LONGEST = 10.0  # longest computed time of an impact / duration of a Hertz contact


def throw(
    material: ElasticPlastic,
    radius: float,
    speed: float,
    settings: Settings | None = None,
    progress: bool = False,
    plane: ElasticPlastic | None = None,
) -> Throw:
    """Compute the impact of a sphere on a plane until the sphere has separated from the plane.

    Args:
        material: Material of the sphere.
        radius: Radius of the sphere, m.
        speed: Impact speed, m/s.
        settings: Settings of mesh and time steps.
        progress: Whether to show a progress bar.
        plane: Material of the half space; None for a rigid plane. The half space is so deep that no
            wave returns during contact.

    Raises:
        ValueError: The speed is not positive or too large for the mesh, or finite strain is chosen
            for a half space.
        NoConvergence: The first step does not converge even after halving. A later failure ends the
            computation; the result so far is returned, with the reason in `stopped`.
    """
    settings = settings or Settings()
    sphere = HertzSphere(material, radius, plane)
    check_speed(sphere, speed, strain=settings.strain)
    reach = force_of_impact(sphere, speed)[1]
    equations = thrown(sphere, reach, speed, settings)
    body, contact = equations.body, equations.contact
    duration = sphere.duration(speed)
    flight = Flight(equations, -speed * body.upward, duration / settings.steps_of_contact)
    rows, fields = [_row(flight)], {}

    def record() -> float:
        rows.append(_row(flight))
        if settings.frames and flight.now.time >= len(fields) * duration / settings.frames:
            fields[flight.now.time] = snapshot(body, contact, flight.now.state)
        return rows[-1]["force"]

    with ProgressBar(total=100, shown=progress, desc="throw", unit="% of Hertz") as bar:
        stopped = follow(flight, record, bar, duration, LONGEST, free_steps=settings.free_steps)
    history = pd.DataFrame(rows)
    force, time, approach = (history[name].to_numpy() for name in ("force", "time", "approach"))
    restitution, nodal_restitution = (
        nan if stopped else float(history[name].iloc[-1] / speed)
        for name in ("velocity", "nodal_velocity")
    )
    end = nan if stopped else end_of_contact(time, force, 2 / 3)
    start = time[np.flatnonzero(force > 0)[0] - 1]
    return Throw(
        material=material,
        radius=sphere.radius,
        plane=plane,
        speed=speed,
        history=history,
        coefficient_of_restitution=restitution,
        nodal_restitution=nodal_restitution,
        force_max=float(force.max()),
        overlap_max=float(approach.max()),
        overlap_res=float(np.interp(end, time, approach)),
        contact_time=float(end - start),
        snapshots=fields,
        stopped=stopped,
    )


def _row(flight: Flight) -> dict[str, float]:
    body, now = flight.equations.body, flight.now
    corners = body.vertex_dofs[:, 1]
    # Use only corner nodes of the sphere, not of the half space.
    corners = corners[body.upward[corners] > 0]
    momentum = body.mass_matrix @ now.velocity
    return {
        "time": now.time,
        "force": now.state.touch.force,
        "approach": -float(body.upward @ (body.mass_matrix @ now.state.displacement)) / body.mass,
        "velocity": float(body.upward @ momentum) / body.mass,
        "nodal_velocity": float(now.velocity[corners].mean()),
        "contact_radius": now.state.touch.contact_radius,
        "kinetic_energy": float(now.velocity @ momentum) / 2,
        **energies(body, now.state),
    }
