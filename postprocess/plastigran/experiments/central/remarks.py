# SPDX-License-Identifier: GPL-2.0-or-later
"""Remarks on central impacts, printed with their table."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from plastigran import laws
from plastigran.experiments.central.arrangement import on_wall
from plastigran.experiments.runs import Runs
from plastigran.plot.style import title

if TYPE_CHECKING:
    from plastigran.experiments.central import CentralImpact

#: Smallest relative difference that the table shows.
VISIBLE = 5e-5


def remarks(runs: Runs) -> list[str]:
    """Return sentences on the bodies, and on what a reader of the table must know."""
    said = [_arrangement(runs.cases), dented(runs.cases), flattened(runs.cases)]
    if (runs.table["speed_ratio"] < 1).all():
        said.insert(
            1,
            "every impact is slower than its yield speed (v/v_Y < 1), so nothing yields and "
            "the coefficient of restitution is 1",
        )
    largest = runs.table["coefficient_of_restitution"].max()
    if largest > 1 + VISIBLE:
        said.append(
            f"a coefficient of restitution above 1, here up to {largest:.5g}, is an error of "
            "the time step (docs/timestep.md)"
        )
    return [sentence for sentence in said if sentence]


def _arrangement(impacts: Iterable[CentralImpact]) -> str:
    """Return the bodies in words, as far as they are the same for all impacts."""
    radii = {impact.radius for impact in impacts}
    walls = {impact.wall_name for impact in impacts}
    if len(radii) > 1 or len(walls) > 1:
        return ""
    return ", ".join(filter(None, (f"spheres of radius {radii.pop():g} m", on_wall(walls.pop()))))


def flattened(impacts: Iterable[CentralImpact]) -> str:
    """Return a sentence on spheres that flatten, although the law describes a yielding flat."""
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
    return (
        f"{', '.join(names)}: the ball yields, but --options 'yielding flat' describes a "
        "yielding wall"
    )


def dented(impacts: Iterable[CentralImpact]) -> str:
    """Return a sentence on walls that yield, although the law describes a yielding sphere."""
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
        f"{', '.join(names)}: the wall yields, not the ball. Use universal with --options "
        f"'yielding flat'; {' and '.join(indentation)} are fits to indentations. The other "
        "laws are for balls that flatten"
    ) + constant * ". Give the wall its rate_coefficient (docs/rate_factor.md)"
