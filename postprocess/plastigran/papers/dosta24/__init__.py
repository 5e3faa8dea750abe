# SPDX-License-Identifier: GPL-2.0-or-later
"""Bulk benchmark of Dosta et al. 2024: impact, silo and drum, computed by eight open codes."""

from __future__ import annotations

from pathlib import Path

from plastigran.papers.base import Paper
from plastigran.papers.dosta24 import drum, impact, silo
from plastigran.report.base import Findings

#: Modules of the cases by name. Each module has `compute`, and the functions of its tables and
#: figures by name, `TABLES` and `FIGURES`.
CASES = {"impact": impact, "silo": silo, "drum": drum}


def paper(
    case: str | None = None,
    folder: Path | None = None,
    host: str = "liggghts",
    **options: object,
) -> Paper:
    """Return the benchmark with the tables and figures of one case, or of all cases.

    Args:
        case: Name in `CASES`; None for all cases.
        folder: Folder of the bulk runs, by default results/dosta24. Unfinished runs in it continue.
        host: Program that runs the decks: liggghts, or lammps for the case impact.
        options: Further arguments of `compute` in the modules of the cases.

    Raises:
        ValueError: The number of grains, or the host lammps, is given for a case other than impact.
    """
    if host != "liggghts":
        if case != "impact":
            raise ValueError(
                f"--host is {host}, but silo and drum run only in LIGGGHTS. Add --case impact, or "
                "remove --host"
            )
        options["host"] = host
    if "grains" in options and case != "impact":
        raise ValueError("--grains is an option of --case impact. Add --case impact")
    folder = folder or Path("results") / "dosta24"
    modules = [CASES[case]] if case else list(CASES.values())

    def compute(progress: bool, coarse: bool) -> Findings:
        tables, figures = {}, {}
        for module in modules:
            data = module.compute(progress, coarse, folder=folder, **options)
            tables |= {name: table(data) for name, table in module.TABLES.items()}
            figures |= {name: draw(data) for name, draw in module.FIGURES.items()}
        return Findings(tables=tables, figures=figures)

    return Paper(
        name="dosta24",
        title="bulk benchmark of eight open codes",
        citation="M. Dosta et al., Comput. Phys. Commun. 296 (2024) 109066",
        compute=compute,
        tables=tuple(name for module in modules for name in module.TABLES),
        figures=tuple(name for module in modules for name in module.FIGURES),
    )
