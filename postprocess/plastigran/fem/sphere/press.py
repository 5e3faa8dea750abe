# SPDX-License-Identifier: GPL-2.0-or-later
"""Quasi-static compression and unloading of a sphere on a rigid plane or a half space.

The lower half of the sphere is fixed vertically at the equator, as for a sphere between two planes.
The approach is the motion of the plane toward the equator.
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
from plastigran.fem.sphere.results import Pressing, first_loading_of
from plastigran.fem.stepping.increment import Equations, Equilibrium, NoConvergence
from plastigran.fem.stepping.snapshot import energies, snapshot
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.progress import ProgressBar

# Ratio of consecutive forces below yield. A large ratio is accurate, because the elastic response
# does not depend on the loading path.
ELASTIC_GROWTH = 1.4
# Largest first force / yield force. The first force is also at most a hundredth of `forces[0]`.
FIRST_FORCE = 0.3
LEAST_FORCE = 1e-5  # last force of an unloading / largest force
CUTS = 6  # largest number of halvings of an increment


class ForceControl:
    """Force control of the compression of a supported sphere.

    `apply` appends a row for each force to `rows`, the history of the compression.
    """

    def __init__(self, equations: Equations, sphere: HertzSphere) -> None:
        self.equations, self.sphere = equations, sphere
        self.rows: list[dict[str, float]] = []
        self.now: Equilibrium = equations.at_rest()
        self._before: Equilibrium | None = None

    def apply(self, forces: Sequence[float], branch: int, bar: ProgressBar) -> None:
        """Apply each force in turn; the first force reverses the direction of loading.

        Args:
            forces: Forces, N.
            branch: Number of the loading or unloading, for the history.
            bar: Progress bar.
        """
        self._before = None
        for force in forces:
            self._increment(force)
            self.rows.append(
                {
                    "branch": branch,
                    "force": self.now.touch.force,
                    "approach": self.now.height,
                    "contact_radius": self.now.touch.contact_radius,
                    **energies(self.equations.body, self.now),
                }
            )
            bar.update()

    def _increment(self, force: float, cuts: int = 0) -> None:
        start = self.now
        try:
            self.now = self.equations.press(start, self._guess(force), force)
            self._before = start
        except NoConvergence as error:
            reached = start.touch.force
            if cuts == CUTS:
                raise NoConvergence(
                    f"{error}; the increment from {reached:g} N to {force:g} N fails even after "
                    f"{cuts} halvings"
                ) from None
            for part in ((reached + force) / 2, force):
                self._before = None
                self._increment(part, cuts + 1)

    def _guess(self, force: float) -> tuple[np.ndarray, float]:
        """Return the initial guess of Newton's method: nodal displacements and height of the plane.

        The guess is extrapolated from the last two equilibria. At first touch and after a load
        reversal, it is an elastic estimate.
        """
        now, before = self.now, self._before
        if now.touch.force == 0:
            return now.displacement, self.sphere.approach(force)
        if before is None:
            return self.equations.predict(now, force)
        # Extrapolate in the power 2/3 of the force, which is proportional to the elastic approach.
        last, this, following = (f ** (2 / 3) for f in (before.touch.force, now.touch.force, force))
        share = (following - this) / (this - last)
        step = share * (now.displacement - before.displacement)
        return now.displacement + step, now.height + share * (now.height - before.height)


def press(
    material: ElasticPlastic,
    radius: float,
    forces: Sequence[float],
    settings: Settings | None = None,
    progress: bool = False,
    plane: ElasticPlastic | None = None,
) -> Pressing:
    """Press a sphere on a plane with each force in turn, and unload the sphere after each force.

    Args:
        material: Material of the sphere.
        radius: Radius of the sphere, m.
        forces: Largest forces, N, increasing.
        settings: Settings of mesh and increments.
        progress: Whether to show a progress bar.
        plane: Material of the half space; None for a rigid plane.

    Raises:
        ValueError: A force is not positive, does not exceed the previous force, or is too large for
            the mesh; or finite strain is chosen for a half space.
        NoConvergence: The first increment has no equilibrium even after halving. A later failure
            ends the computation; the result so far is returned, with the reason in `stopped`.
    """
    settings = settings or Settings()
    sphere = HertzSphere(material, radius, plane)
    check_forces(sphere, forces, strain=settings.strain)
    reach = contact_reach(sphere, forces[-1])
    equations = pressed(sphere, reach, settings)
    control = ForceControl(equations, sphere)
    ladders = loading_ladders(sphere, forces, settings)
    snapshots, stopped = [], ""
    with ProgressBar(total=sum(map(len, ladders)), shown=progress, desc="press") as bar:
        try:
            for branch, ladder in enumerate(ladders):
                control.apply(ladder, branch, bar)
                snapshots.append(snapshot(equations.body, equations.contact, control.now))
        except NoConvergence as error:
            if not control.rows:
                raise
            stopped = str(error)
    history = pd.DataFrame(control.rows)
    unloadings = pd.DataFrame(
        [unloading(history, branch) for branch in range(1, len(snapshots), 2)]
    )
    return Pressing(material, sphere.radius, history, unloadings, snapshots, stopped, plane)


def loading_ladders(
    sphere: HertzSphere, forces: Sequence[float], settings: Settings
) -> list[np.ndarray]:
    """Return the forces of all increments, N: one array for each loading and for each unloading."""
    yield_force = min(sphere.yield_force, forces[-1])
    least = min(FIRST_FORCE * yield_force, forces[0] / 100)
    elastic = _geometric(least, yield_force, ELASTIC_GROWTH)
    growth = settings.growth if sphere.yield_force < forces[-1] else ELASTIC_GROWTH
    loading = np.concatenate([elastic, _geometric(yield_force, forces[-1], growth)[1:]])
    loading = np.unique(np.concatenate([loading, forces]))
    # The elastic force grows with the cube of the contact radius. Cubes therefore give equal steps
    # of the radius.
    down = np.maximum(np.linspace(1, 0, settings.unloading_steps + 1)[1:] ** 3, LEAST_FORCE)
    ladders, reached = [], 0.0
    for force in forces:
        reloading = reached * np.append(down[-2::-1], 1.0) if reached else []
        first_loading = loading[(loading > reached) & (loading <= force)]
        ladders += [np.concatenate([reloading, first_loading]), force * down]
        reached = force
    return ladders


def _geometric(start: float, end: float, growth: float) -> np.ndarray:
    count = max(1, int(np.ceil(np.log(end / start) / np.log(growth))))
    return np.geomspace(start, end, count + 1)


def unloading(history: pd.DataFrame, branch: int) -> dict[str, float]:
    """Return the results of one unloading, as listed in `Pressing.unloadings`.

    Args:
        history: History of the compression; see `Pressing.history`.
        branch: Number of the unloading in the column `branch`.

    The works are integrals of the force with respect to the approach. The work of loading includes
    only first loading, not earlier unloading and reloading.
    """
    force, approach = (history[name].to_numpy() for name in ("force", "approach"))
    branches = history["branch"].to_numpy()
    top = np.flatnonzero(branches < branch)[-1]
    up = first_loading_of(history.iloc[: top + 1])[["force", "approach"]].to_numpy().T
    down = np.append(top, np.flatnonzero(branches == branch))
    work_loading = 0.4 * up[0, 0] * up[1, 0] + _work(*up)
    # The last force is almost zero. Extrapolate the unloading to zero force as a Hertz contact.
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
    """Return the work, J: the integral of the force P over the approach alpha.

    Simpson's rule is applied in x = P^(1/3), because the approach is a smooth function of x. The
    integrand follows from P d alpha = d(P alpha) - 3 alpha x^2 dx.
    """
    root = np.cbrt(force)
    product = force * approach
    return float(product[-1] - product[0] - simpson(3 * approach * root**2, x=root))
