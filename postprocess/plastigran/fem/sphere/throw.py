# SPDX-License-Identifier: GPL-2.0-or-later
"""Impact of a sphere on a rigid plane or a half space: implicit dynamics, trapezoidal rule.

The sphere starts at its impact speed, just touching.
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
from plastigran.fem.stepping.flight import Flight
from plastigran.fem.stepping.increment import NoConvergence
from plastigran.fem.stepping.snapshot import Snapshot, energies, snapshot
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.progress import ProgressBar

LONGEST = 10.0  # number of Hertz' durations after which an impact is stopped


def throw(
    material: ElasticPlastic,
    radius: float,
    speed: float,
    settings: Settings | None = None,
    progress: bool = False,
    plane: ElasticPlastic | None = None,
) -> Throw:
    """Compute the impact of a sphere on a plane until it has separated.

    Args:
        material: Material of the sphere.
        radius: Radius of the sphere, m.
        speed: Impact speed, m/s.
        settings: Resolution.
        progress: Whether to show a bar.
        plane: Material of the half space, so deep that no wave returns during contact; None for a
            rigid plane.

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
    body = equations.body
    duration = sphere.duration(speed)
    timestep = duration / settings.steps_of_contact
    flight = Flight(equations, -speed * body.upward, timestep)
    rows, fields, free, stopped = [_row(flight)], {}, 0, ""
    with ProgressBar(total=100, shown=progress, desc="throw", unit="% of Hertz") as bar:
        while free < settings.free_steps and not stopped:
            try:
                flight.advance()
            except NoConvergence as error:
                stopped = str(error)
                continue
            rows.append(_row(flight))
            free = free + 1 if rows[-1]["force"] == 0 else 0
            if settings.frames and flight.now.time >= len(fields) * duration / settings.frames:
                fields[flight.now.time] = snapshot(body, equations.contact, flight.now.state)
            bar.update(100 * flight.now.time / duration - bar.n)
            if flight.now.time > LONGEST * duration:
                stopped = f"the contact has not ended after {flight.now.time:g} s"
    if len(rows) == 1:
        raise NoConvergence(stopped)
    return _summary(sphere, speed, pd.DataFrame(rows), fields, flight, stopped)


def _row(flight: Flight) -> dict[str, float]:
    body, now = flight.equations.body, flight.now
    corners = body.vertex_dofs[:, 1]
    corners = corners[body.upward[corners] > 0]  # without those of the half space
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
        "iterations": now.state.iterations,
    }


def _summary(
    sphere: HertzSphere,
    speed: float,
    history: pd.DataFrame,
    fields: dict[float, Snapshot],
    flight: Flight,
    stopped: str,
) -> Throw:
    force, time, approach = (history[name].to_numpy() for name in ("force", "time", "approach"))
    touching = np.flatnonzero(force > 0)
    last = touching[-1]
    end = end_of_contact(time[: last + 2], force[: last + 2])
    return Throw(
        material=sphere.material,
        radius=sphere.radius,
        plane=sphere.plane,
        speed=speed,
        history=history,
        coefficient_of_restitution=nan if stopped else history["velocity"].iloc[-1] / speed,
        force_max=float(force.max()),
        overlap_max=float(approach.max()),
        overlap_res=nan if stopped else float(np.interp(end, time, approach)),
        contact_time=nan if stopped else float(end - time[touching[0] - 1]),
        snapshot=snapshot(flight.equations.body, flight.equations.contact, flight.now.state),
        snapshots=fields,
        stopped=stopped,
    )


def end_of_contact(time: np.ndarray, force: np.ndarray) -> float:
    """Return the time of zero force, s: its power 2/3 is extrapolated linearly in the last step."""
    if len(force) < 3:
        return float(time[-1])
    before, last = force[-3] ** (2 / 3), force[-2] ** (2 / 3)
    if last >= before:
        return float(time[-1])
    end = time[-2] + last * (time[-2] - time[-3]) / (before - last)
    return float(min(end, time[-1]))
