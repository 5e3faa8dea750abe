# SPDX-License-Identifier: GPL-2.0-or-later
"""Sections of a page, one for each folder of results."""

from __future__ import annotations

from typing import Any

import attrs
import numpy as np
import pandas as pd

from plastigran.report.page.charts import Chart
from plastigran.report.page.collect import Results
from plastigran.report.page.movie import GrainMovie
from plastigran.report.page.pictures import Picture
from plastigran.report.page.trust import Trust


@attrs.frozen(kw_only=True)
class Table:
    """Table of a section; cells are text.

    Attributes:
        title: Title of the table.
        head: Names of the columns.
        rows: Texts of the cells, by row.
        laws: Name of the law of each row; None if rows do not belong to laws. The page hides the
            rows of a law that the reader switches off.
        open: Whether the table is unfolded when the page opens.
    """

    title: str
    head: list[str]
    rows: list[list[str]]
    laws: list[str] | None = None
    open: bool = False


@attrs.frozen(kw_only=True)
class Section:
    """Section of a page, with the results of one folder.

    Attributes:
        results: Folder of the results.
        state: "passed", "failed", "unfinished", or "done" if there are no checks.
        verdict: State in a few words.
        missing: Sentences about missing results and failures.
        notes: Sentences about quantities that the deck could not measure or check.
        warnings: Warnings of LIGGGHTS, and warnings about the use of a law.
        facts: Facts about the run, by name.
        settings: Further settings: name, value with unit, meaning.
        checks: Rows of `BulkRun.checks`.
        charts: Interactive charts in the order of the page.
        movie: Frames for the three-dimensional view of grains; None without frames.
        pictures: Figures that earlier commands wrote.
        tables: Tables of numbers.
        trust: Errors of verification and validation of each law.
        laws: Names of the laws.
        name: ID of the HTML element of the section.
    """

    results: Results
    state: str
    verdict: str
    missing: list[str] = attrs.field(factory=list)
    notes: list[str] = attrs.field(factory=list)
    warnings: list[str] = attrs.field(factory=list)
    facts: dict[str, str] = attrs.field(factory=dict)
    settings: list[tuple[str, str, str]] = attrs.field(factory=list)
    checks: list[dict[str, Any]] = attrs.field(factory=list)
    charts: list[Chart] = attrs.field(factory=list)
    movie: GrainMovie | None = None
    pictures: list[Picture] = attrs.field(factory=list)
    tables: list[Table] = attrs.field(factory=list)
    trust: list[Trust] = attrs.field(factory=list)
    laws: list[str] = attrs.field(factory=list)
    name: str = ""


def empty_section(results: Results) -> Section:
    """Return the section of a folder without results."""
    return Section(
        results=results,
        state="unfinished",
        verdict="no results",
        missing=[
            "This folder has no results of a plastigran command. It contains no run.json of a "
            "bulk run, no impacts.csv of a sweep, and no tables or figures."
        ],
    )


def cells(table: pd.DataFrame, title: str, heads: dict[str, str] | None = None) -> Table:
    """Convert a table to texts for the page. `heads` are titles that replace column names."""
    rows = [[number(value) for value in row] for row in table.itertuples(index=False)]
    laws = [str(law) for law in table["law"]] if "law" in table else None
    head = [(heads or {}).get(str(name), str(name)) for name in table]
    return Table(title=title, head=head, rows=rows, laws=laws)


def number(value: object) -> str:
    """Format a value for a table cell: four digits, and powers of ten with superscripts."""
    if isinstance(value, bool | np.bool_):
        return "yes" if value else "no"
    if not isinstance(value, int | float | np.integer | np.floating):
        return "" if value is None else str(value)
    if np.isnan(value):
        return ""
    mantissa, _, power = f"{value:.4g}".partition("e")
    if power:
        raised = str(int(power)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        mantissa = f"{mantissa} × 10{raised}".removeprefix("1 × ")
    return mantissa.replace("-", "−")


def span(smallest: float, largest: float) -> str:
    """Format a range of numbers as text, or as one number if both ends are equal."""
    return " to ".join(dict.fromkeys(number(float(end)) for end in (smallest, largest)))


def version_facts(versions: dict[str, str]) -> dict[str, str]:
    """Return the versions of the programs of a run, shortened for the page, by program."""
    facts = {}
    for name, text in versions.items():
        if name == "plugin" and " sha256 " in text:
            text = text.partition(" sha256 ")[2][:12]
        if name == "engine" and "(Version " in text:
            text = text.partition("(Version ")[2].partition(",")[0]
        facts["plugin, sha256" if name == "plugin" else name] = text
    return facts
