# SPDX-License-Identifier: GPL-2.0-or-later
"""A sphere pressed on a rigid plane or a half space and let go, slowly.

The lower half of the sphere is held at its equator, which does not move vertically: half of a
sphere between two planes. The approach is the plane's way towards the equator.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pandas as pd
from scipy.integrate import simpson

from plastigran.fem.limits import check_forces, contact_reach
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.assembly import pressed
from plastigran.fem.sphere.results import Pressing, virgin_loading
from plastigran.fem.stepping.increment import Equations, Equilibrium, NoConvergence
from plastigran.fem.stepping.snapshot import energies, snapshot
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.progress import ProgressBar

ELASTIC_GROWTH = 1.4  # of increments below yield, where the path does not matter
FIRST_FORCE = 0.3  # over the force at yield, or the largest force of an elastic sphere / 100
LEAST_FORCE = 1e-5  # of the largest one: where an unloading ends
CUTS = 6  # how often an increment is halved before it is given up


class Path:
    """Increments of force on a held sphere, each a row of the history."""

    def __init__(self, equations: Equations, sphere: HertzSphere) -> None:
        self.equations, self.sphere = equations, sphere
        self.rows: list[dict[str, float]] = []
        self.now: Equilibrium = equations.at_rest()
        self._before: Equilibrium | None = None

    def go(self, forces: Sequence[float], branch: int, bar: ProgressBar) -> None:
        """Increments to each force in turn; the first one turns the direction of loading."""
        self._before = None
        for force in forces:
            self._increment(force)
            self.rows.append({"branch": branch, **self._row()})
            bar.update()

    def _increment(self, force: float, cuts: int = 0) -> None:
        try:
            found = self.equations.press(self.now, self._guess(force), force)
        except NoConvergence as error:
            if cuts == CUTS:
                reached = self.now.touch.force
                raise NoConvergence(
                    f"{error} between {reached:g} N and {force:g} N, after {cuts} halvings"
                ) from None
            self._before = None
            self._increment((self.now.touch.force + force) / 2, cuts + 1)
            self._before = None
            self._increment(force, cuts + 1)
            return
        self._before, self.now = self.now, found

    def _guess(self, force: float) -> tuple[np.ndarray, float]:
        """Extrapolation of the last increment, or the elastic answer where there is none."""
        now, before = self.now, self._before
        if now.touch.force == 0:
            return now.displacement, self.sphere.approach(force)
        if before is None:
            return self.equations.predict(now, force)
        last, this, next_ = (
            f ** (2 / 3) for f in (before.touch.force, now.touch.force, force)
        )  # an elastic contact moves as the power 2/3 of the force
        share = (next_ - this) / (this - last)
        step = share * (now.displacement - before.displacement)
        return now.displacement + step, now.height + share * (now.height - before.height)

    def _row(self) -> dict[str, float]:
        return {
            "force": self.now.touch.force,
            "approach": self.now.height,
            "contact_radius": self.now.touch.contact_radius,
            **energies(self.equations.body, self.now),
            "iterations": self.now.iterations,
        }


def press(
    material: ElasticPlastic,
    radius: float,
    forces: Sequence[float],
    settings: Settings | None = None,
    progress: bool = False,
    plane: ElasticPlastic | None = None,
) -> Pressing:
    """Press a sphere to each of some forces in turn, letting it go after each.

    Args:
        material: The metal.
        radius: Of the sphere, m.
        forces: Largest forces, N, increasing.
        settings: How fine.
        progress: Show a bar.
        plane: Metal of the half space it is pressed on; rigid if None.

    Raises:
        ValueError: A force that is not positive, not larger than the one before, or too large
            for the mesh; finite strain on a half space.
        NoConvergence: The first increment has no equilibrium even after halving. A later one ends
            the pressing, which keeps what it has and says so in `stopped`.
    """
    settings = settings or Settings()
    sphere = HertzSphere(material, radius, plane)
    check_forces(sphere, forces, strain=settings.strain)
    reach = contact_reach(sphere, forces[-1])
    equations = pressed(sphere, reach, settings)
    path = Path(equations, sphere)
    ladders = loading_ladders(sphere, forces, settings)
    snapshots, stopped = [], ""
    with ProgressBar(total=sum(map(len, ladders)), shown=progress, desc="press") as bar:
        try:
            for branch, ladder in enumerate(ladders):
                path.go(ladder, branch, bar)
                snapshots.append(snapshot(equations.body, equations.contact, path.now))
        except NoConvergence as error:
            if not path.rows:
                raise
            stopped = str(error)
    history = pd.DataFrame(path.rows)
    unloadings = [unloading(history, branch) for branch in range(1, len(snapshots), 2)]
    table = pd.DataFrame(unloadings)
    return Pressing(material, radius, history, table, snapshots, stopped, plane)


def loading_ladders(
    sphere: HertzSphere, forces: Sequence[float], settings: Settings
) -> list[np.ndarray]:
    """Forces of the increments: up to each largest force and down again, in turn."""
    yield_force = min(sphere.yield_force, forces[-1])
    least = min(FIRST_FORCE * yield_force, forces[0] / 100)
    elastic = _geometric(least, yield_force, ELASTIC_GROWTH)
    growth = settings.growth if sphere.yield_force < forces[-1] else ELASTIC_GROWTH
    virgin = np.concatenate([elastic, _geometric(yield_force, forces[-1], growth)[1:]])
    virgin = np.unique(np.concatenate([virgin, forces]))
    # Cubes: equal steps of the contact radius.
    down = np.maximum(np.linspace(1, 0, settings.unloading_steps + 1)[1:] ** 3, LEAST_FORCE)
    ladders, reached = [], 0.0
    for force in forces:
        again = reached * np.append(down[-2::-1], 1.0) if reached else []
        fresh = virgin[(virgin > reached) & (virgin <= force)]
        ladders += [np.concatenate([again, fresh]), force * down]
        reached = force
    return ladders


def _geometric(start: float, end: float, growth: float) -> np.ndarray:
    count = max(1, int(np.ceil(np.log(end / start) / np.log(growth))))
    return np.geomspace(start, end, count + 1)


def unloading(history: pd.DataFrame, branch: int) -> dict[str, float]:
    """What one unloading shows. Works are of force over approach; on the way up the virgin curve is
    taken, whatever was unloaded between.
    """
    force, approach = (history[name].to_numpy() for name in ("force", "approach"))
    branches = history["branch"].to_numpy()
    top = np.flatnonzero(branches < branch)[-1]
    up = virgin_loading(history.iloc[: top + 1])[["force", "approach"]].to_numpy().T
    down = np.append(top, np.flatnonzero(branches == branch))
    work_loading = 0.4 * up[0, 0] * up[1, 0] + _work(*up)
    # The last increment is nearly free: what is left comes back as from an elastic sphere.
    last = down[-1]
    tail = (force[last] / force[top]) ** (2 / 3) * (approach[top] - approach[last])
    work_unloading = -_work(force[down], approach[down])
    return {
        "force": force[top],
        "approach": approach[top],
        "contact_radius": history["contact_radius"].to_numpy()[top],
        "residual_approach": approach[last] - tail,
        "work_loading": work_loading,
        "work_unloading": work_unloading,
        "coefficient_of_restitution": float(np.sqrt(work_unloading / work_loading)),
    }


def _work(force: np.ndarray, approach: np.ndarray) -> float:
    """Integral of force over approach with Simpson's rule in x = force^(1/3), where an approach is
    smooth: P d alpha = d(P alpha) - 3 alpha x^2 dx.
    """
    root = np.cbrt(force)
    return float(
        force[-1] * approach[-1] - force[0] * approach[0] - simpson(3 * approach * root**2, x=root)
    )
