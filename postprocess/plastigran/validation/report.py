# SPDX-License-Identifier: GPL-2.0-or-later
"""Validation of every law: the tables, figures and pages of the docs that it produces."""

from __future__ import annotations

from pathlib import Path

import plastigran
from plastigran.report.base import Evidence, Findings
from plastigran.validation import (
    choice,
    dented_steel,
    figures,
    laws_on_spheres,
    oblique,
    offset,
    paper_sphere,
    rod,
    steel,
)

#: Incident angles [degrees] of the few LIGGGHTS runs with `coarse`, one for each quantity.
FEW_ANGLES = (20.01, 21.25, 20.57)
#: File with the errors of each law in each regime, which other subpackages read.
ERRORS = Path(plastigran.__file__).parent / "data" / "errors.csv"


def compute(progress: bool, coarse: bool) -> Findings:
    """Compute all tables and figures of the validation.

    With `coarse`, LIGGGHTS computes the oblique impacts only at `FEW_ANGLES`. `progress` has no
    effect.
    """
    compared = laws_on_spheres.compare()
    unfitted = laws_on_spheres.without_fitted_metals(compared)
    rebounds, rated = steel.rebounds(), steel.rebounds(**offset.RATE)
    leeb = steel.summary(rebounds)
    means = leeb.set_index("law")["mean (%)"]
    nearest = leeb["law"][0]
    parts = offset.budget(nearest)
    moved = oblique.computed(FEW_ANGLES if coarse else None)
    rods = rod.summary(rod.impacts())
    singles, sphere = steel.single_impacts(), paper_sphere.compare()
    return Findings(
        tables={
            "regimes": choice.by_regime(unfitted, rebounds, rated),
            "restitution": choice.by_law(compared, rebounds, "restitution"),
            "force": choice.by_law(compared, rebounds, "force"),
            "paper_sphere": sphere,
            "leeb": leeb,
            "leeb_rate": offset.with_rate(rebounds, rated),
            "leeb_offset": parts,
            "leeb_finite_elements": dented_steel.comparison(nearest),
            "single_impacts": singles,
            "craters": steel.craters(),
            "oblique": oblique.summary(moved),
            **{f"oblique_{name}": oblique.comparison(moved, name) for name in oblique.QUANTITIES},
            "rod": rods,
            "rod_tangential": rod.tangential_models(),
            "errors": laws_on_spheres.errors(unfitted),
        },
        figures={
            "spheres_restitution": figures.spheres_figure(unfitted, "coefficient_of_restitution"),
            "spheres_force": figures.spheres_figure(unfitted, "force_max"),
            "paper_sphere": figures.errors_figure(sphere, "the sphere of Zhang and Vu-Quoc"),
            "leeb": figures.rebound_figure(rebounds),
            "leeb_offset": figures.budget_figure(parts, nearest, means[nearest]),
            "single_impacts": figures.errors_figure(singles, "single impacts on steel"),
            "oblique": figures.oblique_figure(moved),
            "rod": figures.errors_figure(rods, "the oblique rod"),
        },
    )


EVIDENCE = Evidence(
    name="validation",
    title="Errors of every law",
    tables=(
        "regimes",
        "restitution",
        "force",
        "paper_sphere",
        "leeb",
        "leeb_rate",
        "leeb_offset",
        "leeb_finite_elements",
        "single_impacts",
        "craters",
        "oblique",
        "oblique_restitution",
        "oblique_spin",
        "oblique_rebound_angle",
        "rod",
        "rod_tangential",
    ),
    data=("errors",),
    figures=(
        "spheres_restitution",
        "spheres_force",
        "paper_sphere",
        "leeb",
        "leeb_offset",
        "single_impacts",
        "oblique",
        "rod",
    ),
    pages=(
        "validation_spheres.md",
        "validation_steel.md",
        "validation_oblique.md",
    ),
    pictures="figures/validation",
    compute=compute,
)
