# SPDX-License-Identifier: GPL-2.0-or-later
"""Materials that a sweep recorded."""

from __future__ import annotations

from collections.abc import Mapping

import pandas as pd

from plastigran.declared import declarations
from plastigran.experiments.record import STUDY
from plastigran.materials import Material
from plastigran.plot.quantities import words
from plastigran.report.page.sections import Table, cells


def recorded(study: dict) -> tuple[dict[str, Material], list[str]]:
    """Return the materials of a sweep by name, and a sentence for each that cannot be read.

    Args:
        study: Contents of `study.json`.
    """
    found, odd = {}, []
    said = study.get("materials")
    for name, values in said.items() if isinstance(said, dict) else ():
        try:
            found[name] = Material(name, **values)
        except (TypeError, ValueError) as error:
            odd.append(f"{STUDY} has incomplete data for material {name}: {error}.")
    return found, odd


def constants(materials: Mapping[str, Material]) -> list[Table]:
    """Return a table of the constants of the materials."""
    if not materials:
        return []
    rows = [{"material": name} | each.variables() for name, each in materials.items()]
    units = {name: said.unit for name, said in declarations(Material).items()}
    units = {name: unit for name, unit in units.items() if unit not in ("", "-")}
    table = pd.DataFrame(rows)
    heads = {name: ", ".join(filter(None, (words(name), units.get(name, "")))) for name in table}
    return [cells(table, "Constants of the materials", heads)]
