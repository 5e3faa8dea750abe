# SPDX-License-Identifier: GPL-2.0-or-later
"""Central impacts of all laws by their reference formulas: result rows, jumps of the force."""

from __future__ import annotations

import csv
import io
from functools import cache
from importlib import import_module
from itertools import pairwise
from pathlib import Path

from references.central_impact import CentralImpact, Outcome
from references.contact import MATERIALS

#: Laws with a reference: every module of this folder except this one and shared ones.
LAWS = sorted(
    {path.stem for path in Path(__file__).parent.glob("*.py")}
    - {"central_impact", "contact", "impacts"}
)


def reference(law: str) -> type[CentralImpact]:
    return import_module(f"references.{law}").Reference


def jumps(law: str) -> list[tuple[float, float]]:
    """Return the jumps of the force during first loading, for the first impact of the law. A jump
    consists of its overlap, divided by the overlap at yield, and the relative change of the force.
    """
    impact, places = _impact(law, rows(law)[0]), []
    for (end, before), (_, beyond) in pairwise(impact.pieces):
        size = float(beyond(end) / before(end)) - 1
        if abs(size) > 1e-9:
            places.append((end / impact.overlap_at(impact.material.yield_pressure), size))
    return places


def rows(law: str) -> list[dict[str, str | float]]:
    """Return the impacts of a law: a material, and numbers in SI units."""
    return [
        {name: text if name == "material" else float(text) for name, text in row.items()}
        for row in csv.DictReader(io.StringIO(reference(law).cases))
    ]


def _impact(law: str, row: dict[str, str | float]) -> CentralImpact:
    numbers = {name: value for name, value in row.items() if name != "material"}
    return reference(law)(MATERIALS[row["material"]], **numbers)


@cache
def outcome(law: str, index: int) -> Outcome:
    """Return the outcome of an impact; the computations from energies and from motion must agree.

    Raises:
        ValueError: Energies and motion do not agree to 1e-9, or the elastic formula does not end
            at a positive overlap at yield.
    """
    row = rows(law)[index]
    impact = _impact(law, row)
    end = impact.pieces[0][0]
    yields = type(impact).published_rebound is not CentralImpact.published_rebound
    if not end > 0 or (yields and end == float("inf")):
        raise ValueError(
            f"{law}: the first formula in `pieces`, the elastic one, ends at {end} m. "
            "It must end at the overlap at yield, beyond which published_rebound applies"
        )
    one, other = impact.two_ways()
    if not one.agrees_with(other):
        raise ValueError(
            f"{law} at {row['speed']} m/s: two computations disagree: {one} and {other}"
        )
    return one
