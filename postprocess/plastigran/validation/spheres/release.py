# SPDX-License-Identifier: GPL-2.0-or-later
"""Compression of a sphere by finite elements, with unloading from many forces during one loading.

`plastigran.fem.sphere.press` reloads the sphere after each unloading. Here, loading continues from
the state before unloading. The result is the same, with half as many increments.
"""

from __future__ import annotations

from collections.abc import Sequence

import pandas as pd

from plastigran.fem.limits import check_forces, contact_reach
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.assembly import pressed
from plastigran.fem.sphere.press import ForceControl, loading_ladders, unloading
from plastigran.fem.sphere.results import Pressing
from plastigran.fem.stepping.increment import NoConvergence
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.progress import ProgressBar


def press_and_release(
    material: ElasticPlastic,
    radius: float,
    forces: Sequence[float],
    settings: Settings | None = None,
    progress: bool = False,
) -> Pressing:
    """Press a sphere on a rigid plane and unload the sphere from each of several forces.

    Arguments and errors are those of `plastigran.fem.sphere.press.press`.

    Returns:
        Result of `press`, without snapshots. If an unloading finds no equilibrium, the result
        contains the earlier unloadings, and the reason in `stopped`.
    """
    settings = settings or Settings()
    sphere = HertzSphere(material, radius)
    check_forces(sphere, forces, strain=settings.strain)
    equations = pressed(sphere, contact_reach(sphere, forces[-1]), settings)
    control = ForceControl(equations, sphere)
    ladders = loading_ladders(sphere, forces, settings)
    reached, stopped, whole = 0.0, "", 0
    with ProgressBar(shown=progress, desc=f"press to {forces[-1]:.4g} N") as bar:
        try:
            for branch in range(0, len(ladders), 2):
                up, down = ladders[branch : branch + 2]
                control.apply(up[up > reached], branch, bar)
                top, reached = control.now, up[-1]
                control.apply(down, branch + 1, bar)
                control.now, whole = top, branch + 2
        except NoConvergence as error:
            stopped = str(error)
    history = pd.DataFrame(control.rows)
    releases = [unloading(history, branch) for branch in range(1, whole, 2)]
    return Pressing(material, radius, history, pd.DataFrame(releases), [], stopped)
