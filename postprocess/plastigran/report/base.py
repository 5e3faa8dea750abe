# SPDX-License-Identifier: GPL-2.0-or-later
"""Declaration of evidence: computed tables and figures, and the pages of the docs that show them.

    EVIDENCE = Evidence(
        name="impacts",
        title="Impacts of a sphere",
        tables=("impacts",),
        figures=("restitution",),
        pictures="figures/impacts",
        compute=compute,
    )

`compute(progress, coarse)` must return `Findings` with exactly the declared tables and figures. For
finite elements, use `plastigran.report.computing.compute_all`, which runs one computation per core.
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

# Dots per inch of figures. With this resolution, each figure is smaller than 150 kB.
RESOLUTION = 100


@attrs.frozen(eq=False)
class Findings:
    """Computed tables, figures and movies by name.

    A row of a table compares the values of one quantity from several sources. The first columns,
    such as `quantity` and `unit`, identify the quantity. The other columns contain the values from
    each source, such as `paper`, `finite elements`, a law, or `LIGGGHTS`. Names of columns with
    differences end in "(%)"; see `add_difference`.
    """

    tables: Mapping[str, pd.DataFrame]
    figures: Mapping[str, Figure]
    movies: Mapping[str, Movie] = attrs.field(factory=dict)

    def write(self, folder: Path) -> list[Path]:
        """Write tables as CSV, figures as PNG and movies as GIF; return the paths of the files."""
        folder.mkdir(parents=True, exist_ok=True)
        files = [folder / f"{name}.csv" for name in self.tables]
        for file, table in zip(files, self.tables.values(), strict=True):
            table.to_csv(file, index=False)
        for name, figure in self.figures.items():
            files += save(figure, folder / name, (".png",), RESOLUTION)
        return files + [save_movie(m, folder / f"{name}.gif") for name, m in self.movies.items()]


@attrs.frozen(kw_only=True)
class Evidence:
    """Declaration of computed tables and figures, and of the pages of the docs that show them.

    Attributes:
        name: Short name, as on the command line.
        title: Title of the results.
        tables, figures, movies: Names of the computed tables, figures and movies.
        data: Names of further tables, which are written as CSV files but shown on no page.
        pages: File names of the pages. Each of `tables` has its place on at most one page.
        pictures: Folder for the pictures, relative to the folder of the pages.
        compute: Function `compute(progress, coarse)` that returns the `Findings`.
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
        names = {".csv": self.tables + self.data, ".png": self.figures, ".gif": self.movies}
        return [name + suffix for suffix in names for name in names[suffix]]

    def run(self, progress: bool = False, coarse: bool = False) -> Findings:
        """Compute every table, figure and movie.

        Args:
            progress: Whether to show progress bars.
            coarse: Whether to use coarse meshes and compute fewer impacts. A coarse computation
                takes some seconds and has errors of some per cent.

        Raises:
            ValueError: A computation failed, or the names of the results differ from the declared
                names.
            EngineError: LIGGGHTS stopped with an error.
        """
        findings = self.compute(progress, coarse)
        declared = {"tables": self.tables + self.data}
        declared |= {"figures": self.figures, "movies": self.movies}
        for results, names in declared.items():
            if odd := sorted(set(names) ^ set(getattr(findings, results))):
                raise ValueError(
                    f"{results} of {self.name}: computed and declared names differ in "
                    f"{', '.join(odd)}. Compute exactly the declared {results}"
                )
        return findings


def add_difference(table: pd.DataFrame, of: str, against: str) -> pd.DataFrame:
    """Return a table with a new column of differences, inserted after column `of`.

    The new column contains the difference of column `of` from column `against`, in per cent of
    `against`. A cell is empty where `against` is zero or has no value.
    """
    position = table.columns.get_loc(of) + 1
    values, references = (table[name].astype(float) for name in (of, against))
    difference = 100 * (values / references.replace(0, np.nan) - 1)
    result = table.copy()
    result.insert(position, f"{of} vs {against} (%)", difference)
    return result
