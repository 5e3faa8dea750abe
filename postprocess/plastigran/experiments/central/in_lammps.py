# SPDX-License-Identifier: GPL-2.0-or-later
"""Central impacts of spheres in LAMMPS: the deck and its variables."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from plastigran.engine.process import inputs_folder
from plastigran.materials import law_class

if TYPE_CHECKING:
    from plastigran.experiments.central import CentralImpact

#: Geometries that the LAMMPS deck supports.
GEOMETRIES = ("sphere_wall", "two_spheres")


def deck() -> Path:
    """Return the path of the input script."""
    return inputs_folder() / "lammps" / "impact.in"


def variables(case: CentralImpact, timestep: float | None = None) -> dict[str, object]:
    """Return the variables of the input script for a case.

    Args:
        case: Impact of spheres.
        timestep: Time step [s]; by default the recommended time step.
    """
    given = case.variables()
    law = law_class(case.law, adhesive=case.surface_energy is not None)
    names = [parameter["name"] for parameter in law.parameters()]
    words = [f"{name} {given[name]}" for name in names if given.get(name) is not None]
    return given | {
        "geometry": case.geometry,
        "timestep": case.timestep if timestep is None else timestep,
        "constants": " ".join([*words, given.get("options") or ""]) or None,
        "options": None,
        "inputs": inputs_folder(),
    }
