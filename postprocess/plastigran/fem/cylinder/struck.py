# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of the impact of a rigid cylinder on a body."""

from __future__ import annotations

from math import nan

import attrs
import numpy as np
import pandas as pd

from plastigran.fem.body.struck import StruckBody
from plastigran.fem.contact.circle import RigidCircle
from plastigran.fem.cylinder.case import CylinderStrike
from plastigran.fem.result_file import numbers
from plastigran.fem.stepping.flight import Flight, end_of_contact
from plastigran.fem.stepping.increment import Equilibrium
from plastigran.fem.stepping.linear import SymmetricSystem
from plastigran.fem.stepping.snapshot import YIELDED, Snapshot, energies, snapshot


@attrs.frozen
class Strike:
    """Results of the impact of a cylinder on a body.

    Attributes:
        case: Input of the computation.
        history: Table with one row per time step. Columns are time s, force N (upward on the
            cylinder), drag N (on the cylinder, along its motion) and approach m (depth of the
            lowest point of the cylinder below the undeformed surface). Columns of the motion are
            way m (travel along the surface), velocity m/s (upward) and sliding_velocity m/s.
            Further columns are half_width m of the contact, plastic_top m and plastic_bottom m
            (depths of the shallowest and deepest yielded point; NaN before yield), energies J and
            friction_work J.
        coefficient_of_restitution: Separation speed / approach speed.
        force_max: Largest force, N.
        overlap_max: Largest approach, m.
        overlap_res: Approach at the end of the contact, m.
        residual_depth: Depth of the deepest point of the surface at rest, m.
        contact_time: Duration of the contact, s.
        yield_force: Force at first yield, N; NaN without yield.
        yield_point: Point of first yield (2,), divided by the half width of the contact: its
            coordinate x from the lowest point of the circle, and its depth.
        surface: Coordinates (x, y) of the surface at rest after the impact (n_points, 2), m; x is
            measured from the point of first touch.
        start: Coordinate x of the point of first touch in the mesh, m.
        snapshots: Snapshots of the fields, by name: `yield` (at first yield, if any), `deepest`
            (at the largest approach) and `end` (at the end of contact).
        stopped: Reason for an early end of the computation; otherwise empty. After an early end,
            restitution, residual values and contact time are NaN.
    """

    case: CylinderStrike
    history: pd.DataFrame
    coefficient_of_restitution: float
    force_max: float
    overlap_max: float
    overlap_res: float
    residual_depth: float
    contact_time: float
    yield_force: float
    yield_point: np.ndarray
    surface: np.ndarray
    start: float
    snapshots: dict[str, Snapshot]
    stopped: str = ""

    def to_dict(self) -> dict:
        """Return the results that are numbers, for a JSON file."""
        result = numbers(self)
        del result["start"]
        return result | {
            "thickness": self.case.line.thickness,
            "yield_point": self.yield_point.tolist(),
            "history": self.history.to_dict("list"),
            "surface": self.surface.tolist(),
        }


class StrikeLog:
    """Recorder of the history and the field snapshots of an impact during its computation."""

    def __init__(self, flight: Flight) -> None:
        self.flight = flight
        self.body: StruckBody = flight.equations.body
        self.circle: RigidCircle = flight.equations.contact
        self.rows: list[dict[str, float]] = []
        self.yield_point = np.full(2, nan)
        self._deepest = 0.0
        self._states: dict[str, Equilibrium] = {}
        self.record()

    def record(self) -> float:
        """Append a row for the last time step to the history; return its contact force, N."""
        state = self.flight.now.state
        row = self._row(state)
        self.rows.append(row)
        if "yield" not in self._states and state.response.state.accumulated.any():
            self.yield_point = self._yield_point(state, row)
            self._states["yield"] = state
        if row["approach"] > self._deepest:
            self._deepest = row["approach"]
            self._states["deepest"] = state
        self._states["end"] = state
        return row["force"]

    def _row(self, state: Equilibrium) -> dict[str, float]:
        now, touch, center = self.flight.now, state.touch, self.body.center
        way, up = state.displacement[center]
        first, last = self.circle.ends(touch.gap)
        yielded = state.response.state.accumulated > YIELDED
        depths = -self.body.positions.reshape(-1, 2)[yielded, 1]
        before = self.rows[-1]["friction_work"] if self.rows else 0.0
        return {
            "time": now.time,
            "force": touch.force,
            "drag": touch.drag,
            "approach": -up,
            "way": way,
            "velocity": now.velocity[center[1]],
            "sliding_velocity": now.velocity[center[0]],
            "half_width": (last - first) / 2,
            "plastic_top": depths.min() if depths.size else nan,
            "plastic_bottom": depths.max() if depths.size else nan,
            "kinetic_energy": float(now.velocity @ (self.body.mass_matrix @ now.velocity)) / 2,
            **energies(self.body, state),
            "friction_work": before + touch.dissipated,
        }

    def _yield_point(self, state: Equilibrium, row: dict[str, float]) -> np.ndarray:
        first, second = self.body.positions.reshape(-1, 2)[
            state.response.state.accumulated.argmax()
        ]
        return np.array([first - (self.circle.start + row["way"]), -second]) / row["half_width"]

    def _surface_at_rest(self) -> np.ndarray:
        """Return the surface at rest (x, y) where contact is possible (n_points, 2), m.

        At the last step, waves still move the body. They are assumed to decay elastically, without
        further yield. Their displacements follow from one linear system with the internal forces of
        the last step and the stiffness of the undeformed body, and are subtracted. In finite
        strain, this is an approximation.
        """
        body, state = self.body, self.flight.now.state
        fixed = np.concatenate([body.fixed, body.center])
        factor = SymmetricSystem([body.dofs], body.size, fixed).factor([body.elastic_stiffness])
        waves = factor.solve(body.internal_force(state.displacement, state.response.stress))
        return self.circle.surface(state.displacement - waves)

    def summary(self, case: CylinderStrike, stopped: str) -> Strike:
        """Return the results of an impact; `stopped` is the reason for an early end, or empty."""
        history = pd.DataFrame(self.rows)
        force, time, approach = (history[name].to_numpy() for name in ("force", "time", "approach"))
        end = nan if stopped else end_of_contact(time, force, 1)
        restitution = float(history["velocity"].iloc[-1] / case.speed)
        surface = self._surface_at_rest()
        yielded = np.flatnonzero(history["plastic_work"] > 0)
        return Strike(
            case=case,
            history=history,
            coefficient_of_restitution=nan if stopped else restitution,
            force_max=float(force.max()),
            overlap_max=float(approach.max()),
            overlap_res=float(np.interp(end, time, approach)),
            residual_depth=nan if stopped else float(max(0.0, -surface[:, 1].min())),
            contact_time=end,
            yield_force=float(force[yielded[0]]) if yielded.size else nan,
            yield_point=self.yield_point,
            surface=surface,
            start=self.circle.start,
            snapshots={
                name: snapshot(self.body, self.circle, state)
                for name, state in self._states.items()
            },
            stopped=stopped,
        )
