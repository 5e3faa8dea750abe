# SPDX-License-Identifier: GPL-2.0-or-later
"""What a report declares, and what computing it gives.

    REPORT = Report(
        name="impacts",
        title="Impacts of a sphere",
        tables=("impacts",),
        figures=("restitution",),
        pictures="figures/impacts",
        compute=compute,
    )

`compute(progress, coarse)` returns `Findings` with tables and figures of just these names. Its
finite elements go through `plastigran.report.computing.compute_all`, which keeps them on disk and
runs one a core; its runs of LIGGGHTS through `plastigran.experiments`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import attrs
import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from plastigran.plot.movie import Movie, save_movie
from plastigran.plot.style import save

RESOLUTION = 100  # dots an inch: a picture of a page stays below 150 kB


@attrs.frozen(eq=False)
class Findings:
    """What came of a report's computation.

    Attributes:
        tables: By name. One row a quantity: `quantity` and `unit`, or what else tells it; then
            columns of numbers, as far as there are some: `paper`, `finite elements`, a law's name,
            `LIGGGHTS`. A column whose name ends in "(%)" is a difference, see `add_difference`.
        figures: By name, made in `plastigran.plot.style`.
        movies: By name.
    """

    tables: Mapping[str, pd.DataFrame]
    figures: Mapping[str, Figure]
    movies: Mapping[str, Movie] = attrs.field(factory=dict)

    def write(self, folder: Path) -> list[Path]:
        """Write tables as CSV, figures as PNG and movies as GIF; returns the files."""
        folder.mkdir(parents=True, exist_ok=True)
        written = []
        for name, table in self.tables.items():
            written.append(folder / f"{name}.csv")
            table.to_csv(written[-1], index=False)
        for name, figure in self.figures.items():
            written += save(figure, folder / name, (".png",), RESOLUTION)
        for name, movie in self.movies.items():
            written.append(save_movie(movie, folder / f"{name}.gif"))
        return written


@attrs.frozen(kw_only=True)
class Report:
    """Tables and figures that are computed, and the pages that show them.

    Attributes:
        name: Short, as of its command.
        title: What it is about.
        tables, figures, movies: Names of what is made.
        data: Names of further tables, which no page shows.
        pages: Files of a folder of pages; together they have one place for each of `tables`.
        pictures: Folder of the pages' pictures, seen from that of the pages.
        compute: Makes it, `compute(progress, coarse)`.
    """

    name: str
    title: str
    tables: tuple[str, ...]
    figures: tuple[str, ...]
    movies: tuple[str, ...] = ()
    data: tuple[str, ...] = ()
    pages: tuple[str, ...] = attrs.Factory(lambda self: (f"{self.name}.md",), takes_self=True)
    pictures: str
    compute: Callable[[bool, bool], Findings]

    @property
    def files(self) -> list[str]:
        """What `Findings.write` writes."""
        kinds = {".csv": self.tables + self.data, ".png": self.figures, ".gif": self.movies}
        return [name + ending for ending, names in kinds.items() for name in names]

    def run(self, progress: bool = False, coarse: bool = False) -> Findings:
        """Compute every table, figure and movie.

        Args:
            progress: Show bars.
            coarse: Coarse meshes and fewer cases: some seconds for a look or a test, and results
                that are off by some per cent.

        Raises:
            ValueError: A computation gave up, or something declared was not made.
            EngineError: The engine stopped with an error.
        """
        made = self.compute(progress, coarse)
        promised = {"tables": self.tables + self.data}
        promised |= {"figures": self.figures, "movies": self.movies}
        for kind, declared in promised.items():
            if odd := sorted(set(declared) ^ set(getattr(made, kind))):
                raise ValueError(f"{kind} of {self.name}: {odd} do not match")
        return made


def add_difference(table: pd.DataFrame, of: str, against: str) -> pd.DataFrame:
    """The table with a column of differences after the column `of`: how far its numbers are off
    those of the column `against`, in per cent of the latter; empty where it has none."""
    position = table.columns.get_loc(of) + 1
    ours, theirs = (table[name].astype(float) for name in (of, against))
    result = table.copy()
    result.insert(position, f"{of} off {against} (%)", 100 * (ours / theirs.replace(0, np.nan) - 1))
    return result
