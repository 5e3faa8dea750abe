# SPDX-License-Identifier: GPL-2.0-or-later
"""What is read from an equilibrium, and the tables it is kept in."""

from __future__ import annotations

import attrs
import numpy as np
import pandas as pd

from plastigran.fem.body import Body
from plastigran.fem.contact import RigidPlane
from plastigran.fem.increment import Equilibrium
from plastigran.fem.material import ElasticPlastic

ROUNDING = 1e-6  # of a force, beyond what Newton's method leaves


@attrs.frozen
class Snapshot:
    """Fields at one moment.

    Attributes:
        force: N.
        radii: Mean of each edge of the surface (n,), m.
        pressure: Mean there, Pa.
        positions: (r, y) of the Gauss points (points, 2), m.
        mises: Von Mises stress there, Pa; in finite strain that of the stress conjugate to the
            logarithmic strain.
        plastic_strain: Accumulated plastic strain there.
    """

    force: float
    radii: np.ndarray
    pressure: np.ndarray
    positions: np.ndarray
    mises: np.ndarray
    plastic_strain: np.ndarray


def energies(body: Body, state: Equilibrium) -> dict[str, float]:
    """Elastic energy, work of plastic flow and energy in the penalty, J."""
    return {
        "elastic_energy": body.elastic_energy(state.displacement, state.response),
        "plastic_work": float(state.response.state.work @ body.volumes.ravel()),
        "penalty_energy": state.touch.stored,
    }


def snapshot(body: Body, plane: RigidPlane, state: Equilibrium) -> Snapshot:
    """The fields of an equilibrium."""
    return Snapshot(
        state.touch.force,
        *plane.profile(state.touch),
        body.positions.reshape(-1, 2),
        mises_stress(state.response.stress),
        state.response.state.accumulated,
    )


def mises_stress(stress: np.ndarray) -> np.ndarray:
    """Von Mises stress (n,) of stresses (rr, yy, tt, ry) (n, 4), Pa."""
    radial, axial, hoop, shear = stress.T
    differences = (radial - axial) ** 2 + (axial - hoop) ** 2 + (hoop - radial) ** 2
    return np.sqrt(differences / 2 + 3 * shear**2)


@attrs.frozen
class Pressing:
    """A sphere pressed on a plane and let go, once for each largest force.

    Attributes:
        material: The metal.
        radius: m.
        history: One row for each increment: force N, approach m, contact_radius m, energies J,
            and `branch`, 2k while it is pressed to the k-th force and 2k + 1 while it is let go.
        unloadings: One row for each largest force: force, approach, contact_radius,
            residual_approach, work_loading, work_unloading, coefficient_of_restitution.
        snapshots: At each largest force and after each unloading.
        stopped: Why it ended before its end; empty if it did not.
    """

    material: ElasticPlastic
    radius: float
    history: pd.DataFrame
    unloadings: pd.DataFrame
    snapshots: list[Snapshot]
    stopped: str = ""

    def to_dict(self) -> dict:
        """Numbers only, for a file."""
        return {
            "radius": self.radius,
            "stopped": self.stopped,
            "unloadings": self.unloadings.to_dict("records"),
            "history": self.history.to_dict("list"),
        }


def virgin_loading(history: pd.DataFrame) -> pd.DataFrame:
    """Rows of a pressing's history whose force had not been reached before, but for rounding."""
    loading = history[history["branch"] % 2 == 0]
    reached = loading["force"].cummax().shift(fill_value=0)
    return loading[loading["force"] > (1 + ROUNDING) * reached]


@attrs.frozen
class Throw:
    """A sphere thrown at a plane.

    Attributes:
        material: The metal.
        radius: m.
        speed: m/s.
        history: One row for each step: time s, force N, approach m (of the centre of mass),
            velocity m/s (of the centre of mass, upward), contact_radius m, energies J.
        coefficient_of_restitution: Momentum after over before.
        force_max: N.
        overlap_max: Largest approach, m.
        overlap_res: Approach when contact ends, m.
        contact_time: s.
        snapshot: When contact has ended.
        stopped: Why it ended before its end, where restitution and residual are not known; empty
            if it did not.
    """

    material: ElasticPlastic
    radius: float
    speed: float
    history: pd.DataFrame
    coefficient_of_restitution: float
    force_max: float
    overlap_max: float
    overlap_res: float
    contact_time: float
    snapshot: Snapshot
    stopped: str = ""

    def to_dict(self) -> dict:
        """Numbers only, for a file."""
        names = (
            "radius",
            "speed",
            "stopped",
            "coefficient_of_restitution",
            "force_max",
            "overlap_max",
            "overlap_res",
            "contact_time",
        )
        numbers = {name: getattr(self, name) for name in names}
        return numbers | {"history": self.history.to_dict("list")}
