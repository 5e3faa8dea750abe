# SPDX-License-Identifier: GPL-2.0-or-later
"""The sphere of Zhang & Vu-Quoc 2002: finite elements, the law of the paper and others."""

from __future__ import annotations

from plastigran.papers.base import Paper
from plastigran.report.base import Findings


def compute(progress: bool, coarse: bool) -> Findings:
    """Compute every table, figure and movie."""
    # import late, because these modules are slow to load
    from plastigran.papers.zv02 import figures, pictures
    from plastigran.papers.zv02.computations import SHOWN, compute_finite_elements_and_runs
    from plastigran.papers.zv02.tables import tables

    computed = compute_finite_elements_and_runs(progress, coarse)
    pressing, shown = computed.pressing, computed.throws[SHOWN]
    forces = pressing.unloadings["force"]
    return Findings(
        tables=tables(computed),
        figures={
            "restitution": figures.restitution_figure(computed),
            "collisions": figures.collisions_figure(computed),
            "loops": figures.loops_figure(pressing),
            "contact_radius": figures.contact_radius_figure(pressing),
            "pressure": figures.pressure_figure(pressing, computed.elastic_pressing),
            "mesh": pictures.mesh_figure(computed.mesh, shown.history["contact_radius"].max()),
            "mises": pictures.mises_figure(pressing, tuple(forces.iloc[[0, 1, 3, -1]].unique())),
            "plastic_zone": pictures.plastic_zone_figure(pressing),
        },
        movies={"collision": pictures.collision_movie(shown)},
    )


PAPER = Paper(
    name="zv02",
    title="An elastic-plastic sphere on a rigid plane",
    citation="X. Zhang & L. Vu-Quoc, Int. J. Impact Eng. 27 (2002) 317",
    tables=(
        "onset",
        "elastic",
        "force",
        "restitution",
        "approach",
        "residual",
        "pressed",
        "coefficients",
        "laws",
        "engine",
    ),
    data=("duration",),
    figures=(
        "restitution",
        "collisions",
        "loops",
        "contact_radius",
        "pressure",
        "mesh",
        "mises",
        "plastic_zone",
    ),
    movies=("collision",),
    compute=compute,
)
