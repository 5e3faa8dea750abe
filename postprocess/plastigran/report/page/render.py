# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the page: sections through templates, with styles, scripts and numbers inside."""

from __future__ import annotations

import base64
import gzip
import json
import os
from collections.abc import Callable, Iterable
from datetime import datetime
from functools import cache
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from shutil import copymode

import plotly.offline
from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup
from plotly.utils import PlotlyJSONEncoder

from plastigran.plot.quantities import words
from plastigran.plot.style import COLOURS, law_number
from plastigran.plot.style import title as law_title
from plastigran.report.page import bulk_section, sweep_section, table_section
from plastigran.report.page.collect import Results, collect
from plastigran.report.page.colours import on_dark
from plastigran.report.page.names import number
from plastigran.report.page.sections import Section, nothing

#: By this a page is known to be ours.
GENERATOR = "plastigran report"
_MAKERS: dict[str, Callable[[Results, str], Section]] = {
    "bulk": bulk_section.make,
    "sweep": sweep_section.make,
    "tables": table_section.make,
    "nothing": nothing,
}
_STATES = ("failed", "unfinished", "passed", "done")


def write_report(
    folders: Iterable[str | Path], path: str | Path, title: str = "", force: bool = False
) -> Path:
    """Write one page on the results in some folders.

    Args:
        folders: Of runs, or folders that hold such.
        path: The page to write; an earlier report there is replaced once it is whole.
        title: Headline; by default the folders' names.
        force: Overwrite a file that is no report.

    Returns:
        The page.

    Raises:
        ValueError: A folder is not there, or `path` is a file that is no report.
    """
    path, folders = Path(path), [Path(folder) for folder in folders]
    check_page(path, force)
    found = collect(folders)
    sections = [make_section(each, f"run-{k}") for k, each in enumerate(found)]
    names = ", ".join(dict.fromkeys(folder.resolve().name for folder in folders))
    path.parent.mkdir(parents=True, exist_ok=True)
    _replace(path, render(sections, title or f"Results: {names}"))
    return path


def _replace(path: Path, text: str) -> None:
    """Write a file whole or not at all: beside its place, from where it is moved there."""
    path = path.resolve()  # a link stays one
    draft = path.with_name(f".{path.name}.{os.getpid()}.new")
    try:
        with open(draft, "w", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        if path.exists():
            copymode(path, draft)
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)


def check_page(path: Path, force: bool = False) -> None:
    """Refuse a path that a report cannot be written to.

    Raises:
        ValueError: It does not end in .html, or is a file that is no report, without `force`.
    """
    if path.suffix != ".html":
        raise ValueError(f"{path} is no name of a page; it must end in .html")
    if path.exists() and not force:
        if not path.is_file() or GENERATOR not in path.read_text(errors="replace")[:2000]:
            raise ValueError(f"{path} is there and is no report; choose another, or add --force")


def make_section(results: Results, name: str) -> Section:
    """The section of a folder, by what it holds."""
    return _MAKERS[results.kind](results, name)


def render(sections: list[Section], title: str) -> str:
    """The page as text.

    Args:
        sections: In the order they are shown.
        title: Headline.
    """
    charts = {chart.name: chart.to_json() for section in sections for chart in section.charts}
    shades = {law: law_number(law) for section in sections for law in section.laws}
    switched = sorted({law for s in sections if s.kind != "bulk" for law in s.laws})
    colours = {"light": COLOURS, "dark": [on_dark(colour) for colour in COLOURS]}
    numbers = {"charts": charts, "colours": colours, "laws": shades}
    page = _environment().get_template("page.html.j2")
    return page.render(
        title=title,
        generator=GENERATOR,
        version=version("plastigran"),
        written=datetime.now().astimezone(),
        sections=sections,
        counts={s: k for s in _STATES if (k := sum(each.state == s for each in sections))},
        laws=switched if len(switched) > 1 else [],
        law_number=shades,
        colours=colours,
        numbers=packed(json.dumps(numbers, cls=PlotlyJSONEncoder)),
        plotly=_plotly() if charts else "",
    )


def packed(text: str) -> Markup:
    """A text as a page carries it: gzip, in base64."""
    return Markup(base64.b64encode(gzip.compress(text.encode(), 9, mtime=0)).decode())


@cache
def _plotly() -> Markup:
    return packed(plotly.offline.get_plotlyjs())


@cache
def _environment() -> Environment:
    made = Environment(
        loader=PackageLoader(__package__),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    assets = files(__package__) / "assets"
    made.globals["asset"] = lambda name: Markup((assets / name).read_text(encoding="utf-8"))
    made.filters |= {"number": number, "words": words, "law": law_title, "percent": _percent}
    return made


def _percent(share: float | None) -> str:
    """A share in per cent, two digits; a dash for nothing known."""
    if share is None:
        return "–"
    value = 100 * share
    return f"{value:.0f} %" if value >= 10 else f"{value:.2g} %" if value >= 1e-3 else "< 0.001 %"
