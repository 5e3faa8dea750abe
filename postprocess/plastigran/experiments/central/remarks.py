# SPDX-License-Identifier: GPL-2.0-or-later
"""What is to be said of central impacts beside their table."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from plastigran import laws
from plastigran.experiments.central.arrangement import on_wall
from plastigran.experiments.runs import Runs
from plastigran.plot.style import title

if TYPE_CHECKING:
    from plastigran.experiments.central import CentralImpact

#: Least part of a number that the table shows.
VISIBLE = 5e-5


def remarks(runs: Runs) -> list[str]:
    """Sentences: what hits what, and what a reader of the table must know."""
    said = [_arrangement(runs.cases), dented(runs.cases), flattened(runs.cases)]
    if (runs.table["speed_ratio"] < 1).all():
        said.insert(
            1,
            "every impact is slower than its yield speed (v/v_Y < 1): nothing yields, and the "
            "coefficient of restitution is 1",
        )
    largest = runs.table["coefficient_of_restitution"].max()
    if largest > 1 + VISIBLE:
        said.append(
            f"a coefficient of restitution above 1, here up to {largest:.5g}, is the error of the "
            "time step (docs/timestep.md)"
        )
    return [sentence for sentence in said if sentence]


def _arrangement(impacts: Iterable[CentralImpact]) -> str:
    """What spheres hit what, where it is the same for all: the table has what varies."""
    radii = {impact.radius for impact in impacts}
    walls = {impact.wall_name for impact in impacts}
    if len(radii) > 1 or len(walls) > 1:
        return ""
    return ", ".join(filter(None, (f"spheres of radius {radii.pop():g} m", on_wall(walls.pop()))))


def flattened(impacts: Iterable[CentralImpact]) -> str:
    """Which balls flatten by a law that was told that the flat is dented."""
    names = dict.fromkeys(
        f"{title(impact.material.name)} {on_wall(impact.wall_name)}"
        for impact in impacts
        if impact.options
        and impact.law_is_of_indentation
        and impact.bodies == 1
        and not impact.wall_yields
        and impact.speed >= impact.yield_speed()
    )
    if not names:
        return ""
    return f"{', '.join(names)}: the ball flattens; --options 'yielding flat' is of a dented wall"


def dented(impacts: Iterable[CentralImpact]) -> str:
    """Which balls dent their wall by a law of balls that flatten."""
    found = [
        impact
        for impact in impacts
        if impact.wall_yields
        and laws.LAWS[impact.law].yields
        and impact.speed >= impact.yield_speed()
        and not impact.law_is_of_indentation
    ]
    if not found:
        return ""
    names = dict.fromkeys(
        f"{title(impact.material.name)} {on_wall(impact.wall_name)}" for impact in found
    )
    constant = any(impact.wall.rate_coefficient == 0 for impact in found)
    indentation = sorted(name for name, law in laws.LAWS.items() if law.indentation)
    return (
        f"{', '.join(names)}: the wall is dented, the ball does not flatten. universal with "
        f"--options 'yielding flat' is for that, {' and '.join(indentation)} are fits to "
        "indentations, the other laws are of balls that flatten"
    ) + constant * ". Give the wall its rate_coefficient (docs/rate_factor.md)"
