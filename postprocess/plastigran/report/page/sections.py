# SPDX-License-Identifier: GPL-2.0-or-later
"""Sections of a page: what is shown of a folder of results, whatever state it is in."""

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
    """A table of a section, its cells as text.

    Attributes:
        title: What it holds.
        head: Names of its columns.
        rows: Its cells.
        laws: The law of each row, where there is one: the page switches the row with it.
        open: Whether it is shown unfolded.
    """

    title: str
    head: list[str]
    rows: list[list[str]]
    laws: list[str] | None = None
    open: bool = False


@attrs.frozen(kw_only=True)
class Section:
    """What a page shows of a folder.

    Attributes:
        kind: As `Results.kind` has it; templates are called by it.
        name: Of the element of the page.
        title: Its headline.
        folder: Where the results are, as given.
        state: "passed", "failed", "unfinished" or "done", the last where nothing is checked.
        verdict: The state in a few words.
        missing: Sentences on what is not there, or went wrong.
        notes: Sentences on what the deck could not measure or check.
        warnings: Of the engine's models, or of how a law was used.
        facts: What ran, by name.
        settings: Further settings: name, value with unit, meaning.
        checks: Rows of `BulkRun.checks`.
        charts: In the order they are shown.
        movie: Frames to look at.
        pictures: Figures that commands have drawn.
        tables: Numbers.
        trust: Of each law: verification beside validation.
        laws: Names of the laws in it.
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
    """The section of a folder that no command has written to."""
    return Section(
        kind="nothing",
        name=name,
        title=results.name,
        folder=results.folder,
        state="unfinished",
        verdict="no results",
        missing=[
            "This folder holds nothing that a command of plastigran has written: no run.json of a "
            "bulk run, no impacts.csv of a sweep, no tables or figures."
        ],
    )


def cells(table: pd.DataFrame, title: str, heads: dict[str, str] | None = None) -> Table:
    """A table of numbers as text.

    Args:
        table: The numbers.
        title: What it holds.
        heads: Names of columns, where they are others.
    """
    rows = [[number(value) for value in row] for row in table.itertuples(index=False)]
    laws = [str(law) for law in table["law"]] if "law" in table else None
    head = [(heads or {}).get(str(name), str(name)) for name in table]
    return Table(title=title, head=head, rows=rows, laws=laws)


def version_facts(versions: dict[str, str]) -> dict[str, str]:
    """Versions as facts: short, as far as the reader needs them to tell two runs apart."""
    shown = {}
    for name, said in versions.items():
        if name == "plugin" and " sha256 " in said:
            said = said.partition(" sha256 ")[2][:12]
        if name == "engine" and "(Version " in said:
            said = said.partition("(Version ")[2].partition(",")[0]
        shown[{"plugin": "plugin, sha256"}.get(name, name)] = said
    return shown
