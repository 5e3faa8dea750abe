# SPDX-License-Identifier: GPL-2.0-or-later
"""Declaration of a reproduced paper, and functions that several papers use.

The module of a paper declares the paper as follows:

    PAPER = declare(
        name="zv02",
        title="An elastic-plastic sphere on a rigid plane",
        citation="X. Zhang & L. Vu-Quoc, Int. J. Impact Eng. 27 (2002) 317",
        compute=compute,
        tables=(tables.onset, tables.force),
        figures=(figures.restitution_figure,),
    )

`compute(progress, coarse)` returns the computed data; see `Evidence.run`. Each table, figure and
movie is made by a function that takes these data. The name of this function, without `_figure` or
`_movie`, is the name of the result; see also `plastigran.report.base.Findings`.

`plastigran.papers` finds `PAPER` in each module or package. docs/papers/NAME.md is the page of the
paper.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import Any

import attrs
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure

from plastigran.contact import RangeWarning
from plastigran.experiments.collide import collide
from plastigran.experiments.runs import Runs
from plastigran.fem.stepping.snapshot import Snapshot, at_vertices
from plastigran.plot.fields import draw_field
from plastigran.plot.movie import Movie
from plastigran.plot.style import COLOURS
from plastigran.report.base import Evidence, Findings

STRESS_LEVELS = np.linspace(0, 1, 11)  # contour levels of von Mises stress / flow stress
STRESS_LABEL = "von Mises stress / flow stress"


@attrs.frozen(kw_only=True)
class Paper(Evidence):
    """Paper whose results this package computes again.

    Attributes:
        citation: Authors, journal, volume, year, page.
    """

    citation: str
    pictures: str = attrs.Factory(lambda self: f"../figures/papers/{self.name}", takes_self=True)


def declare(
    *,
    compute: Callable[[bool, bool], Any],
    tables: Sequence[Callable[[Any], pd.DataFrame]],
    figures: Sequence[Callable[[Any], Figure]],
    data: Sequence[Callable[[Any], pd.DataFrame]] = (),
    movies: Sequence[Callable[[Any], Movie]] = (),
    **description: str,
) -> Paper:
    """Return a paper whose results are functions of the computed data.

    Args:
        compute: Function `compute(progress, coarse)` that returns the data.
        tables, figures, movies: Functions that make the results shown on the page.
        data: Functions that make further tables, which no page shows.
        description: `name`, `title` and `citation` of `Paper`.
    """

    def compute_results(progress: bool, coarse: bool) -> Findings:
        computed = compute(progress, coarse)
        return Findings(
            tables={_name(table): table(computed) for table in (*tables, *data)},
            figures={_name(figure): figure(computed) for figure in figures},
            movies={_name(movie): movie(computed) for movie in movies},
        )

    results = {"tables": tables, "data": data, "figures": figures, "movies": movies}
    names = {result: tuple(map(_name, functions)) for result, functions in results.items()}
    return Paper(compute=compute_results, **names, **description)


def _name(function: Callable) -> str:
    return function.__name__.removesuffix("_figure").removesuffix("_movie")


def run_impacts(*arguments: Any, **options: Any) -> Runs:
    """Run impacts in LIGGGHTS as `collide` does, without warnings about the range of a law.

    Warnings would not help, because the paper sets the speeds. The page of the paper states the
    error of each law.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RangeWarning)
        return collide(*arguments, **options)


def draw_stress(
    axes: Axes,
    snapshot: Snapshot,
    strength: float,
    *,
    origin: Sequence[float],
    scale: float,
    zone_edge: float,
    mirror: bool = True,
) -> ContourSet:
    """Draw von Mises stress / flow stress and the edge of the plastic zone on the deformed body.

    Args:
        axes: Axes to draw in.
        snapshot: Fields of the finite elements.
        strength: Flow stress of the material, Pa.
        origin: Coordinates (2,) of the point that the picture shows at the origin, m.
        scale: Length on the axes that represents 1 m.
        zone_edge: Plastic strain at the edge of the plastic zone.
        mirror: Whether to repeat the field at negative first coordinates.
    """
    vertices = scale * (snapshot.vertices + snapshot.displacement - origin)
    stress = at_vertices(snapshot, snapshot.mises) / strength
    stress = np.minimum(stress, 1 - 1e-9)  # keep points at the flow stress below the last contour
    contours = draw_field(
        axes, vertices, snapshot.quads, stress, STRESS_LEVELS, mirror, cmap="viridis"
    )
    strain = at_vertices(snapshot, snapshot.plastic_strain)
    if strain.max() > zone_edge:
        style = {"colors": COLOURS[1], "linewidths": 1.2}
        draw_field(axes, vertices, snapshot.quads, strain, [zone_edge], mirror, False, **style)
    axes.set_aspect("equal")
    return contours
