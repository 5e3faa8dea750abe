# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of a compression or an impact of a sphere."""

from __future__ import annotations

import attrs
import pandas as pd

from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.result_file import numbers
from plastigran.fem.stepping.snapshot import Snapshot

# Forces with a relative difference below this value count as equal. The value exceeds the error of
# Newton's method.
ROUNDING = 1e-6


@attrs.frozen
class Pressing:
    """Compression of a sphere on a plane or a half space, with unloading from each largest force.

    Attributes:
        material: Material of the sphere.
        radius: Radius of the sphere, m.
        history: One row per increment: force N, approach m, contact_radius m, energies J, and
            `branch`. It is 0 for loading to the first force, 1 for unloading, 2 for loading to the
            second force, and so on.
        unloadings: One row per largest force: force, approach, contact_radius, residual_approach,
            work_loading, work_unloading, coefficient_of_restitution.
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
    """Return the rows of first loading, whose force exceeds all earlier forces."""
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
        history: One row per step: time s, force N, approach m (of the center of mass), velocity m/s
            (of the center of mass, upward), nodal_velocity m/s (mean of the corner nodes, upward),
            contact_radius m, energies J.
        coefficient_of_restitution: Momentum after the impact / momentum before the impact.
        nodal_restitution: Restitution from the mean velocity of all corner nodes at the end. This
            value includes the vibration of the sphere, mostly of the finely meshed part.
        force_max: Largest force, N.
        overlap_max: Largest approach, m.
        overlap_res: Approach at the end of contact, m.
        contact_time: Duration of the contact, s.
        snapshots: Fields by time, s: `Settings.frames` snapshots per duration of a Hertz impact.
        stopped: Reason of an early end; otherwise empty. After an early end, the values at the end
            are NaN.
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
