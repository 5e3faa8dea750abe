# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the HTML page from templates; the page includes styles, scripts and data."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable
from datetime import datetime
from functools import cache
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from shutil import copymode

import attrs
import plotly.offline
from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup
from plotly.utils import PlotlyJSONEncoder

from plastigran.plot.style import COLOURS, law_number
from plastigran.plot.style import title as law_title
from plastigran.report.page import bulk_section, sweep_section, table_section
from plastigran.report.page.collect import Results, collect
from plastigran.report.page.colours import on_dark
from plastigran.report.page.movie import pack
from plastigran.report.page.sections import Section, empty_section, number

#: Text in the page that identifies a report of this program.
GENERATOR = "plastigran report"
_MAKERS: dict[str, Callable[[Results], Section]] = {
    "bulk": bulk_section.make,
    "sweep": sweep_section.make,
    "tables": table_section.make,
    "nothing": empty_section,
}


def write_report(
    folders: Iterable[str | Path], path: str | Path, title: str = "", force: bool = False
) -> Path:
    """Write an HTML page about the results in one or more folders.

    Args:
        folders: Folders with results, or folders whose subfolders have results.
        path: Path of the page. An earlier report is replaced when the new report is complete.
        title: Heading of the page; by default the names of the folders.
        force: Whether to overwrite a file that is not a report.

    Returns:
        Path of the page.

    Raises:
        ValueError: A folder does not exist, or `path` is a file that is not a report.
    """
    path, folders = Path(path), [Path(folder) for folder in folders]
    _check_page(path, force)
    sections = [make_section(results) for results in collect(folders)]
    names = ", ".join(dict.fromkeys(folder.resolve().name for folder in folders))
    path.parent.mkdir(parents=True, exist_ok=True)
    _replace(path, render(sections, title or f"Results: {names}"))
    return path


def _replace(path: Path, text: str) -> None:
    """Write a temporary file and rename it, so that the file `path` is never incomplete."""
    path = path.resolve()  # replace the target of a symbolic link, not the link
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


def _check_page(path: Path, force: bool) -> None:
    """Check that the name ends in .html. Without `force`, only a report may be overwritten."""
    if path.suffix != ".html":
        raise ValueError(f"{path} cannot be a report: its name must end in .html. Rename it")
    if path.exists() and not force:
        if not path.is_file() or GENERATOR not in path.read_text(errors="replace")[:2000]:
            raise ValueError(
                f"{path} exists and is not a report. Choose another name, or add --force"
            )


def make_section(results: Results) -> Section:
    """Return the section of a folder of results."""
    return _MAKERS[results.category](results)


def render(sections: list[Section], title: str) -> str:
    """Return the HTML text of the page, with the sections in the given order."""
    sections = [attrs.evolve(section, name=f"run-{k}") for k, section in enumerate(sections)]
    charts = {f"{s.name}-{chart.name}": chart.to_json() for s in sections for chart in s.charts}
    law_colours = {law: law_number(law) for section in sections for law in section.laws}
    switched = {law for s in sections if s.results.category != "bulk" for law in s.laws}
    colours = {"light": COLOURS, "dark": [on_dark(colour) for colour in COLOURS]}
    numbers = {"charts": charts, "colours": colours, "laws": law_colours}
    return _environment().get_template("page.html.j2").render(
        title=title,
        generator=GENERATOR,
        version=version("plastigran"),
        written=datetime.now().astimezone(),
        sections=sections,
        laws=sorted(switched) if len(switched) > 1 else [],
        law_colours=law_colours,
        colours=colours,
        numbers=pack(json.dumps(numbers, cls=PlotlyJSONEncoder).encode()),
        plotly=_plotly() if charts else "",
    )  # fmt: skip


@cache
def _plotly() -> str:
    return pack(plotly.offline.get_plotlyjs().encode())


@cache
def _environment() -> Environment:
    environment = Environment(
        loader=PackageLoader(__package__),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    assets = files(__package__) / "assets"
    environment.globals["asset"] = lambda name: Markup((assets / name).read_text(encoding="utf-8"))
    environment.filters |= {"number": number, "law": law_title, "percent": _percent}
    return environment


def _percent(fraction: float | None) -> str:
    """Return a fraction in per cent with two digits; a dash for None."""
    if fraction is None:
        return "–"
    value = 100 * fraction
    return f"{value:.0f} %" if value >= 10 else f"{value:.2g} %" if value >= 1e-3 else "< 0.001 %"
