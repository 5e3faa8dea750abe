# SPDX-License-Identifier: GPL-2.0-or-later
"""Sections of a page: its view of a folder of results in any state."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import attrs
import pandas as pd

from plastigran.report.page.charts import Chart
from plastigran.report.page.collect import Results
from plastigran.report.page.movie import Movie
from plastigran.report.page.names import number
from plastigran.report.page.pictures import Picture
from plastigran.report.page.trust import Trust


@attrs.frozen(kw_only=True)
class Table:
    """Table of a section; cells are text.

    Attributes:
        title: Title of the table.
        head: Names of the columns.
        rows: Cells.
        laws: Law of each row, or None; the page shows and hides rows with their law.
        open: Whether the table is shown unfolded.
    """

    title: str
    head: list[str]
    rows: list[list[str]]
    laws: list[str] | None = None
    open: bool = False


@attrs.frozen(kw_only=True)
class Section:
    """Part of a page on one folder.

    Attributes:
        kind: See `Results.kind`; it selects the template.
        name: ID of the element of the page.
        title: Headline.
        folder: Folder of the results, as given.
        state: "passed", "failed", "unfinished", or "done" if there are no checks.
        verdict: State in a few words.
        missing: Sentences on missing results and failures.
        notes: Sentences on what the deck could not measure or check.
        warnings: Warnings of LIGGGHTS, or on the use of a law.
        facts: Facts on the run, by name.
        settings: Further settings: name, value with unit, meaning.
        checks: Rows of `BulkRun.checks`.
        charts: Charts in the order of the page.
        movie: View of the grains.
        pictures: Figures of earlier commands.
        tables: Tables of numbers.
        trust: Verification and validation of each law.
        laws: Names of the laws.
    """

    kind: str
    name: str
    title: str
    folder: Path
    state: str
    verdict: str
    missing: list[str] = attrs.field(factory=list)
    notes: list[str] = attrs.field(factory=list)
    warnings: list[str] = attrs.field(factory=list)
    facts: dict[str, str] = attrs.field(factory=dict)
    settings: list[tuple[str, str, str]] = attrs.field(factory=list)
    checks: list[dict[str, Any]] = attrs.field(factory=list)
    charts: list[Chart] = attrs.field(factory=list)
    movie: Movie | None = None
    pictures: list[Picture] = attrs.field(factory=list)
    tables: list[Table] = attrs.field(factory=list)
    trust: list[Trust] = attrs.field(factory=list)
    laws: list[str] = attrs.field(factory=list)


def nothing(results: Results, name: str) -> Section:
    """Return the section of a folder without results."""
    return Section(
        kind="nothing",
        name=name,
        title=results.name,
        folder=results.folder,
        state="unfinished",
        verdict="no results",
        missing=[
            "This folder has no results of a plastigran command. It contains no run.json of a "
            "bulk run, no impacts.csv of a sweep, and no tables or figures."
        ],
    )


def cells(table: pd.DataFrame, title: str, heads: dict[str, str] | None = None) -> Table:
    """Return a table of numbers as text.

    Args:
        table: Numbers.
        title: Title of the table.
        heads: Column titles that differ from the column names.
    """
    rows = [[number(value) for value in row] for row in table.itertuples(index=False)]
    laws = [str(law) for law in table["law"]] if "law" in table else None
    head = [(heads or {}).get(str(name), str(name)) for name in table]
    return Table(title=title, head=head, rows=rows, laws=laws)


def version_facts(versions: dict[str, str]) -> dict[str, str]:
    """Return versions as short facts that distinguish two runs."""
    shown = {}
    for name, said in versions.items():
        if name == "plugin" and " sha256 " in said:
            said = said.partition(" sha256 ")[2][:12]
        if name == "engine" and "(Version " in said:
            said = said.partition("(Version ")[2].partition(",")[0]
        shown[{"plugin": "plugin, sha256"}.get(name, name)] = said
    return shown
