# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of a compression or an impact of a sphere."""

from __future__ import annotations

import attrs
import pandas as pd

from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.result_file import numbers
from plastigran.fem.stepping.snapshot import Snapshot

# Forces with a relative difference below this value count as equal. The value is larger than the
# error of the forces from Newton's method.
ROUNDING = 1e-6


@attrs.frozen
class Pressing:
    """Compression of a sphere on a plane or a half space, with unloading from each largest force.

    Attributes:
        material: Material of the sphere.
        radius: Radius of the sphere, m.
        history: Table with one row per increment: force N, approach m, contact_radius m, energies
            J, and `branch`. The number `branch` is 0 for loading to the first force, 1 for
            unloading, 2 for loading to the second force, and so on.
        unloadings: Table with one row per largest force: force N, approach m, contact_radius m,
            residual_approach m, work_loading J, work_unloading J, coefficient_of_restitution.
        snapshots: Fields at each largest force and after each unloading.
        stopped: Reason for an early end; otherwise empty.
        plane: Material of the half space; None for a rigid plane.
    """

    material: ElasticPlastic
    radius: float
    history: pd.DataFrame
    unloadings: pd.DataFrame
    snapshots: list[Snapshot]
    stopped: str = ""
    plane: ElasticPlastic | None = None

    def to_dict(self) -> dict:
        """Return the results that are numbers, for a JSON file."""
        return numbers(self) | {
            "unloadings": self.unloadings.to_dict("records"),
            "history": self.history.to_dict("list"),
        }


def first_loading_of(history: pd.DataFrame) -> pd.DataFrame:
    """Return the rows of a history in which the force exceeds all earlier forces."""
    loading = history[history["branch"] % 2 == 0]
    reached = loading["force"].cummax().shift(fill_value=0)
    return loading[loading["force"] > (1 + ROUNDING) * reached]


@attrs.frozen
class Throw:
    """Impact of a sphere on a plane or a half space.

    Attributes:
        material: Material of the sphere.
        radius: Radius of the sphere, m.
        speed: Impact speed, m/s.
        history: Table with one row per time step: time s, force N, approach m (of the center of
            mass), velocity m/s (of the center of mass, upward), nodal_velocity m/s (mean of the
            corner nodes, upward), contact_radius m, energies J.
        coefficient_of_restitution: Momentum after the impact / momentum before the impact.
        nodal_restitution: Restitution from the mean velocity of all corner nodes at the end. This
            value includes the vibration of the sphere, mostly of the finely meshed part.
        force_max: Largest force, N.
        overlap_max: Largest approach, m.
        overlap_res: Approach at the end of contact, m.
        contact_time: Duration of the contact, s.
        snapshots: Snapshots of the fields, by time, s: `Settings.frames` snapshots per duration of
            a Hertz impact.
        stopped: Reason for an early end of the computation; otherwise empty. After an early end,
            the values at the end of the impact are NaN.
        plane: Material of the half space; None for a rigid plane.
    """

    material: ElasticPlastic
    radius: float
    speed: float
    history: pd.DataFrame
    coefficient_of_restitution: float
    nodal_restitution: float
    force_max: float
    overlap_max: float
    overlap_res: float
    contact_time: float
    snapshots: dict[float, Snapshot]
    stopped: str = ""
    plane: ElasticPlastic | None = None

    def to_dict(self) -> dict:
        """Return the results that are numbers, for a JSON file."""
        return numbers(self) | {"history": self.history.to_dict("list")}
