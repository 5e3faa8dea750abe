# SPDX-License-Identifier: GPL-2.0-or-later
"""Remarks on central impacts, printed below their results table."""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite
from typing import TYPE_CHECKING

import attrs

from plastigran import laws
from plastigran.declared import SPEED
from plastigran.experiments.central.arrangement import on_wall
from plastigran.experiments.runs import Runs
from plastigran.physics.adhesion import sticking_speed
from plastigran.plot.style import title

if TYPE_CHECKING:
    from plastigran.experiments.central import CentralImpact

#: Smallest relative difference that is visible in the printed table, which has five digits.
VISIBLE = 5e-5


def remarks(runs: Runs) -> list[str]:
    """Return sentences on the bodies, yield and adhesion, and on unsuitable laws or time steps."""
    sentences = [_arrangement(runs.cases)]
    if runs.table["surface_energy"].isna().all() and (runs.table["speed_ratio"] < 1).all():
        sentences.append(
            "every impact is slower than its yield speed (v/v_Y < 1), so nothing yields and "
            "the coefficient of restitution is 1"
        )
    sentences += [*sticking(runs.cases), dented(runs.cases), flattened(runs.cases)]
    largest = runs.table["coefficient_of_restitution"].max()
    if largest > 1 + VISIBLE:
        sentences.append(
            f"a coefficient of restitution above 1, here up to {largest:.5g}, is an error due to "
            "the time step (docs/timestep.md)"
        )
    return [sentence for sentence in sentences if sentence]


def _arrangement(impacts: Iterable[CentralImpact]) -> str:
    """Return the properties of the bodies that are the same for all impacts, in words."""
    radii = {impact.radius for impact in impacts}
    walls = {impact.wall_name for impact in impacts}
    if len(radii) > 1 or len(walls) > 1:
        return ""
    return ", ".join(filter(None, (f"spheres of radius {radii.pop():g} m", on_wall(walls.pop()))))


def sticking(impacts: Iterable[CentralImpact]) -> list[str]:
    """Return a sentence with the sticking speed for each law and pair of bodies that stick."""
    stuck = [impact for impact in impacts if isfinite(impact.work_of_adhesion)]
    stuck = [impact for impact in stuck if impact.predict().coefficient_of_restitution == 0]
    bodies = {attrs.evolve(impact, speed=SPEED.lower): impact for impact in stuck}.values()
    sentences = []
    for impact in bodies:
        where = ", ".join(filter(None, (title(impact.material.name), on_wall(impact.wall_name))))
        sentences.append(
            f"{impact.law}, {where}, {impact.work_of_adhesion:g} J/m2: the coefficient of "
            f"restitution is 0 where the bodies stick. {_fastest_sticking(impact)}"
        )
    return sentences


def _fastest_sticking(impact: CentralImpact) -> str:
    """Return a sentence with the largest closing speed at which the bodies stick."""
    try:
        closing = sticking_speed(impact.contact_law(), impact.radius_eff, impact.mass_eff)
    except ValueError as error:
        return f"The sticking speed is unknown: {error}"
    each = f" ({closing / 2:.4g} m/s for each sphere)" if impact.bodies == 2 else ""
    return f"The largest closing speed at which they stick is {closing:.4g} m/s{each}"


def flattened(impacts: Iterable[CentralImpact]) -> str:
    """Return a sentence on spheres that flatten, although the law describes a yielding flat."""
    flattening = [
        impact
        for impact in impacts
        if impact.options
        and impact.law_is_of_indentation
        and impact.bodies == 1
        and not impact.wall_yields
        and impact.speed >= impact.yield_speed()
    ]
    if not flattening:
        return ""
    return (
        f"{_names(flattening)}: the ball yields, but --options 'yielding flat' describes a "
        "yielding wall"
    )


def dented(impacts: Iterable[CentralImpact]) -> str:
    """Return a sentence on walls that yield, although the law describes a yielding sphere."""
    indented = [
        impact
        for impact in impacts
        if impact.wall_yields
        and laws.LAWS[impact.law].yields
        and impact.speed >= impact.yield_speed()
        and not impact.law_is_of_indentation
    ]
    if not indented:
        return ""
    indentation_laws = sorted(name for name, law in laws.LAWS.items() if law.indentation)
    sentence = (
        f"{_names(indented)}: the wall yields, not the ball. Use universal with --options "
        f"'yielding flat'; {' and '.join(indentation_laws)} are fits to indentations. The other "
        "laws are for balls that flatten"
    )
    if any(impact.wall.rate_coefficient == 0 for impact in indented):
        sentence += ". Give the wall its rate_coefficient (docs/rate_factor.md)"
    return sentence


def _names(impacts: Iterable[CentralImpact]) -> str:
    bodies = (f"{title(impact.material.name)} {on_wall(impact.wall_name)}" for impact in impacts)
    return ", ".join(dict.fromkeys(bodies))
