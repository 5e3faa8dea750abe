# SPDX-License-Identifier: GPL-2.0-or-later
"""Files of a sweep in addition to its runs: a table of results, and a record of the study."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Mapping
from io import StringIO
from math import isnan
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pandas as pd

if TYPE_CHECKING:
    from plastigran.experiments.base import Experiment
    from plastigran.materials import Material

#: Results table in the folder of a sweep.
TABLE = "impacts.csv"
#: Record in the folder of a sweep: command, settings, versions.
STUDY = "study.json"
#: Columns of text, if the record does not name them.
WORDS = ("law", "material", "wall", "options", "geometry")
#: Types of the entries of a record.
_TEXTS = {"command": str, "words": list, "versions": dict}


def add_row(path: Path, row: Mapping[str, object]) -> None:
    """Append a row to a table, completely or not at all. The first row creates the file."""
    line = pd.DataFrame([row])
    if path.exists():
        with open(path, "a", newline="") as file:
            file.write(line.to_csv(header=False, index=False))
        return
    draft = path.with_suffix(".new")
    line.to_csv(draft, index=False)
    draft.replace(path)


def read_table(path: Path) -> tuple[pd.DataFrame, list[str]]:
    """Return the complete rows of a table, and sentences on rows left out.

    Columns that the record declares as text are read as text, because a steel may be named 304.

    Raises:
        OSError, ValueError: The table is missing or invalid.
    """
    whole, _, rest = path.read_text(encoding="utf-8").rpartition("\n")
    head, *lines = whole.splitlines() or [""]
    rows = [_cells(line) for line in lines]
    words = read_study(path.parent)[0].get("words", WORDS)
    odd = _odd_rows(_cells(head), rows, words)
    left = [f"Line {k + 2} of {path.name} is damaged and left out." for k in odd]
    if rest:
        left.append(f"The last line of {path.name} is cut short and left out.")
    kept = "\n".join([head, *(line for k, line in enumerate(lines) if k not in odd)])
    kinds = dict.fromkeys(words, str)
    table = pd.read_csv(StringIO(kept), dtype=kinds, keep_default_na=False, na_values=[""])
    return table, left


def _cells(line: str) -> list[str]:
    try:
        return next(csv.reader([line]), [])
    except csv.Error:
        return []


def _odd_rows(head: list[str], rows: list[list[str]], words: list[str]) -> list[int]:
    """Return rows that cannot be those of a sweep.

    They have another length, lack a word, or contain text where most rows have a number.
    """
    odd = {k for k, row in enumerate(rows) if len(row) != len(head)}
    for place, name in enumerate(head):
        cells = {k: row[place] for k, row in enumerate(rows) if k not in odd}
        filled = {k for k, cell in cells.items() if cell}
        if name in words:
            odd |= cells.keys() - filled
            continue
        texts = {k for k in filled if not _is_number(cells[k])}
        odd |= texts if 2 * len(texts) < len(filled) else set()
    return sorted(odd)


def _is_number(cell: str) -> bool:
    try:
        return not isnan(float(cell))
    except ValueError:
        return False


def read_study(folder: Path) -> tuple[dict[str, Any], list[str]]:
    """Return the readable part of a sweep's record, and sentences on the rest."""
    try:
        said = json.loads((folder / STUDY).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}, []
    except (OSError, ValueError) as error:
        return {}, [f"{STUDY} is damaged: {error}."]
    if not isinstance(said, dict):
        return {}, [f"{STUDY} is damaged: it is not the record of a sweep."]
    odd = [name for name, kind in _TEXTS.items() if name in said and not _holds(said[name], kind)]
    whole = {name: value for name, value in said.items() if name not in odd}
    return whole, [f"{STUDY} is damaged: entry {name} is left out." for name in odd]


def _holds(value: object, kind: type) -> bool:
    """Return whether a value is a text, or a list or dict of texts."""
    if not isinstance(value, kind):
        return False
    texts = value.values() if isinstance(value, dict) else [value] if kind is str else value
    return all(isinstance(text, str) for text in texts)


def write_study(
    folder: Path,
    cases: list[Experiment],
    settings: Mapping[str, Any],
    made_with: Mapping[str, str],
    by_theory: bool = False,
) -> None:
    """Record a sweep before it runs, or a study by theory."""
    facts = [each.facts() for each in cases]
    said = {
        "command": cases[0].command,
        "cases": len(cases),
        "by_theory": by_theory,
        "settings": {name: _plain(value) for name, value in settings.items()},
        "words": sorted(k for k in facts[0] if all(isinstance(row.get(k), str) for row in facts)),
        "materials": {name: each.variables() for name, each in materials_of(cases).items()},
        "versions": made_with,
    }
    (folder / STUDY).write_text(json.dumps(said, indent=2) + "\n")


def materials_of(cases: Iterable[Experiment]) -> dict[str, Material]:
    """Return the materials of all bodies by name.

    Raises:
        ValueError: Two different materials have one name, which tables could not distinguish.
    """
    found: dict[str, Material] = {}
    for case in cases:
        for name, material in case.materials().items():
            if found.setdefault(name, material) != material:
                raise ValueError(
                    f"two materials are named {name}; give their files different names"
                )
    return found


def _plain(value: Any) -> Any:
    """Return a setting for JSON: numbers and words, and the name of other objects."""
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, Iterable):
        return [_plain(each) for each in value]
    return str(getattr(value, "name", value))
