# SPDX-License-Identifier: GPL-2.0-or-later
"""Impacts of a sphere (Zhang & Vu-Quoc 2002): finite elements, the law of the paper, other laws."""

from __future__ import annotations

from plastigran.papers.base import declare
from plastigran.papers.zv02 import figures, pictures, tables
from plastigran.papers.zv02.computations import compute

PAPER = declare(
    name="zv02",
    title="An elastic-plastic sphere on a rigid plane",
    citation="X. Zhang & L. Vu-Quoc, Int. J. Impact Eng. 27 (2002) 317",
    compute=compute,
    tables=(
        tables.onset,
        tables.elastic,
        tables.force,
        tables.restitution,
        tables.approach,
        tables.residual,
        tables.pressed,
        tables.coefficients,
        tables.laws,
        tables.engine,
    ),
    data=(tables.duration,),
    figures=(
        figures.restitution_figure,
        figures.collisions_figure,
        figures.loops_figure,
        figures.contact_radius_figure,
        figures.pressure_figure,
        pictures.mesh_figure,
        pictures.mises_figure,
        pictures.plastic_zone_figure,
    ),
    movies=(pictures.collision_movie,),
)
