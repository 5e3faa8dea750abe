# SPDX-License-Identifier: GPL-2.0-or-later
"""What comes of pressing or throwing a sphere."""

from __future__ import annotations

from math import nan

import attrs
import pandas as pd

from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.stepping.snapshot import Snapshot

ROUNDING = 1e-6  # of a force, beyond what Newton's method leaves


@attrs.frozen
class Pressing:
    """A sphere pressed on a plane or a half space and let go, once for each largest force.

    Attributes:
        material: The metal.
        radius: m.
        history: One row for each increment: force N, approach m, contact_radius m, energies J,
            and `branch`, 2k while it is pressed to the k-th force and 2k + 1 while it is let go.
        unloadings: One row for each largest force: force, approach, contact_radius,
            residual_approach, work_loading, work_unloading, coefficient_of_restitution.
        snapshots: At each largest force and after each unloading.
        stopped: Why it ended before its end; empty if it did not.
        plane: Metal of the half space; rigid if None.
    """

    material: ElasticPlastic
    radius: float
    history: pd.DataFrame
    unloadings: pd.DataFrame
    snapshots: list[Snapshot]
    stopped: str = ""
    plane: ElasticPlastic | None = None

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
    """A sphere thrown at a plane or a half space.

    Attributes:
        material: The metal.
        radius: m.
        speed: m/s.
        history: One row for each step: time s, force N, approach m (of the centre of mass),
            velocity m/s (of the centre of mass, upward), nodal_velocity m/s (mean of the elements'
            corners, upward), contact_radius m, energies J.
        coefficient_of_restitution: Momentum after over before.
        force_max: N.
        overlap_max: Largest approach, m.
        overlap_res: Approach when contact ends, m.
        contact_time: s.
        snapshot: When contact has ended.
        snapshots: By time, s; `Settings.frames` of them over Hertz' duration.
        stopped: Why it ended before its end, where restitution and residual are not known; empty
            if it did not.
        plane: Metal of the half space; rigid if None.
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
    snapshots: dict[float, Snapshot]
    stopped: str = ""
    plane: ElasticPlastic | None = None

    @property
    def nodal_restitution(self) -> float:
        """Restitution by the mean velocity of the elements' corners, each alike, at the end. It
        holds the vibration left in the sphere, of its finely meshed part most of all.
        """
        return nan if self.stopped else float(self.history["nodal_velocity"].iloc[-1] / self.speed)

    def to_dict(self) -> dict:
        """Numbers only, for a file."""
        names = (
            "radius",
            "speed",
            "stopped",
            "coefficient_of_restitution",
            "nodal_restitution",
            "force_max",
            "overlap_max",
            "overlap_res",
            "contact_time",
        )
        numbers = {name: getattr(self, name) for name in names}
        return numbers | {"history": self.history.to_dict("list")}
