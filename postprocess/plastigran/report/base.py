# SPDX-License-Identifier: GPL-2.0-or-later
"""Declaration of a report, and the result of its computation.

    REPORT = Report(
        name="impacts",
        title="Impacts of a sphere",
        tables=("impacts",),
        figures=("restitution",),
        pictures="figures/impacts",
        compute=compute,
    )

`compute(progress, coarse)` returns `Findings` with exactly these tables and figures. Use
`plastigran.report.computing.compute_all` for finite elements; it keeps results on disk and runs one
computation per core. Use `plastigran.experiments` for runs of LIGGGHTS.
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

RESOLUTION = 100  # dots per inch; keeps the picture of a page below 150 kB


@attrs.frozen(eq=False)
class Findings:
    """Result of the computation of a report.

    Attributes:
        tables: Tables by name. A row is one quantity: columns `quantity` and `unit`, or other
            columns that identify it, and then columns of numbers such as `paper`, `finite
            elements`, the name of a law, or `LIGGGHTS`. A column whose name ends in "(%)" is a
            difference, see `add_difference`.
        figures: Figures by name, made with `plastigran.plot.style`.
        movies: Movies by name.
    """

    tables: Mapping[str, pd.DataFrame]
    figures: Mapping[str, Figure]
    movies: Mapping[str, Movie] = attrs.field(factory=dict)

    def write(self, folder: Path) -> list[Path]:
        """Write tables as CSV, figures as PNG and movies as GIF; return the files."""
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
    """Computed tables and figures, and the pages that show them.

    Attributes:
        name: Short name, as in its command.
        title: Subject of the report.
        tables, figures, movies: Names of the results.
        data: Names of further tables, which no page shows.
        pages: Names of the page files; together they have one place for each of `tables`.
        pictures: Folder of the pictures, relative to the folder of the pages.
        compute: Function `compute(progress, coarse)` that returns the results.
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
        """Names of the files that `Findings.write` writes."""
        kinds = {".csv": self.tables + self.data, ".png": self.figures, ".gif": self.movies}
        return [name + ending for ending, names in kinds.items() for name in names]

    def run(self, progress: bool = False, coarse: bool = False) -> Findings:
        """Compute every table, figure and movie.

        Args:
            progress: Whether to show progress bars.
            coarse: Use coarse meshes and fewer cases. This takes some seconds; results are off by
                some per cent.

        Raises:
            ValueError: A computation failed, or a declared result is missing.
            EngineError: LIGGGHTS stopped with an error.
        """
        made = self.compute(progress, coarse)
        promised = {"tables": self.tables + self.data}
        promised |= {"figures": self.figures, "movies": self.movies}
        for kind, declared in promised.items():
            if odd := sorted(set(declared) ^ set(getattr(made, kind))):
                raise ValueError(f"{kind} of report {self.name} are not as declared: {odd}")
        return made


def add_difference(table: pd.DataFrame, of: str, against: str) -> pd.DataFrame:
    """Return the table with a column of differences after column `of`.

    The difference from column `against` is in per cent of the latter; empty where it has no value.
    """
    position = table.columns.get_loc(of) + 1
    ours, theirs = (table[name].astype(float) for name in (of, against))
    result = table.copy()
    result.insert(position, f"{of} vs {against} (%)", 100 * (ours / theirs.replace(0, np.nan) - 1))
    return result
