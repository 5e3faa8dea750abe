# SPDX-License-Identifier: GPL-2.0-or-later
"""Function that runs central impacts of spheres or of cylinders in LIGGGHTS."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from numpy.typing import ArrayLike

from plastigran import laws as all_laws
from plastigran.contact import RangeWarning
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.cylinder import CylinderImpact
from plastigran.experiments.runs import Runs, sweep
from plastigran.experiments.tables import format_range
from plastigran.materials import Material

#: Experiment class for each shape of bodies.
IMPACTS = {experiment.shape: experiment for experiment in (CentralImpact, CylinderImpact)}


def collide(
    laws: str | Iterable[str],
    speeds: ArrayLike,
    materials: Material | str | Path | Iterable[Material | str | Path],
    radius: float,
    geometry: str | None = None,
    folder: str | Path | None = None,
    jobs: int | None = None,
    force: bool = False,
    **fields: Any,
) -> Runs:
    """Run central impacts with LIGGGHTS, for every combination of laws, speeds and materials.

    Args:
        laws: Name of a law, or names of several laws for the same shape of bodies.
        speeds: Speed of each body, a number or (N,) [m/s].
        materials: One or several materials, names or file paths.
        radius: Radius of the bodies [m].
        geometry: Geometry of the impact, such as "two_spheres"; by default a body hits a rigid
            plane.
        folder: Folder for the files of LIGGGHTS; by default, the files are not kept.
        jobs: Number of LIGGGHTS processes that run at the same time; by default the number of
            cores.
        force: Whether to overwrite the results of an earlier sweep in `folder`.
        fields: Further fields of `CentralImpact` or `CylinderImpact`, such as `mass` of a cylinder.

    Returns:
        The results, with the attributes `table` and `outcomes` and the method
        `figure("restitution")`. `print` shows the table, followed by remarks.

    Raises:
        ValueError: An input is invalid; the message gives the reason.
        EngineError: LIGGGHTS stopped with an error.

    Warns:
        RangeWarning: Impacts exceed the range of their law.
    """
    names = [laws] if isinstance(laws, str) else list(laws)
    shape = all_laws.LAWS[names[0]].shape if names and names[0] in all_laws.LAWS else "sphere"
    if geometry is not None:
        fields["geometry"] = geometry
    cases = IMPACTS[shape].plan(
        material=materials, law=names, speed=speeds, radius=radius, **fields
    )
    with ExitStack() as stack:
        if folder is None:
            folder = stack.enter_context(TemporaryDirectory())
        runs = sweep(cases, folder, jobs, progress=False, force=force)
    if sentences := format_range(runs.table):
        warnings.warn(sentences, RangeWarning, stacklevel=2)
    return runs
