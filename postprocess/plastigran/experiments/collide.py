# SPDX-License-Identifier: GPL-2.0-or-later
"""Central impacts of any shape of bodies in one call."""

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

#: The class of impact for each shape of bodies.
IMPACTS = {kind.shape: kind for kind in (CentralImpact, CylinderImpact)}


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
    """Run central impacts in the engine, every combination of laws, speeds and materials.

    Args:
        laws: One law's name or several, of laws for bodies of one shape.
        speeds: Of each body, a number or (N,) [m/s].
        materials: One or several, as such, by name or by the path of a file.
        radius: Of the bodies [m].
        geometry: The deck; a body on a rigid plane by default.
        folder: Keeps what the engine writes; by default nothing is kept.
        jobs: Engines at a time; all cores by default.
        force: Overwrite the results of an earlier sweep in `folder`.
        fields: Further fields of the case, such as a cylinder's `mass`.

    Returns:
        What was measured: `.table`, `.outcomes`, `.figure("restitution")`; printed, the table with
        what a reader of it must know.

    Raises:
        ValueError: A case cannot be run; the message says why.
        EngineError: The engine stopped with an error.

    Warns:
        RangeWarning: Impacts are beyond their law's range.
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
    if said := format_range(runs.table):
        warnings.warn(said, RangeWarning, stacklevel=2)
    return runs
