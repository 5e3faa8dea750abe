# SPDX-License-Identifier: GPL-2.0-or-later
"""Results table and record of a sweep, which runs several cases of an experiment.

The table and the record are two files in the folder of results, next to `runs`, which contains one
folder per case.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Mapping
from io import StringIO
from math import isnan
from pathlib import Path
from typing import Any

import attrs
import pandas as pd

from plastigran.experiments.case import Case
from plastigran.materials import Material

#: Name of the file with the results table of a sweep.
TABLE = "impacts.csv"
#: Name of the file with the record of a sweep: its command, settings and software versions.
STUDY = "study.json"
#: Columns of the results table that contain text, if the record does not list them.
WORDS = ("law", "material", "wall", "options", "geometry")
#: Types of the values in study.json that contain text, by key.
_TEXTS = {"command": str, "words": list, "versions": dict}


def add_row(path: Path, row: Mapping[str, object]) -> None:
    """Append a row to a results table, completely or not at all. The first row creates the file."""
    line = pd.DataFrame([row])
    if path.exists():
        with open(path, "a", newline="") as file:
            file.write(line.to_csv(header=False, index=False))
        return
    draft = path.with_suffix(".new")
    line.to_csv(draft, index=False)
    draft.replace(path)


def read_table(path: Path) -> tuple[pd.DataFrame, list[str]]:
    """Return the complete rows of a results table, and sentences that name the omitted rows.

    The columns that the record lists as text are never read as numbers, because a material may have
    the name "304".

    Raises:
        OSError, ValueError: The table is missing or invalid.
    """
    complete, _, rest = path.read_text(encoding="utf-8").rpartition("\n")
    head, *lines = complete.splitlines() or [""]
    words = read_study(path.parent)[0].get("words", WORDS)
    damaged = _damaged_rows(_cells(head), [_cells(line) for line in lines], words)
    remarks = [f"Line {k + 2} of {path.name} is damaged and omitted." for k in damaged]
    if rest:
        remarks.append(f"The last line of {path.name} is truncated and omitted.")
    kept = "\n".join([head, *(line for k, line in enumerate(lines) if k not in damaged)])
    types = dict.fromkeys(words, str)
    table = pd.read_csv(StringIO(kept), dtype=types, keep_default_na=False, na_values=[""])
    return table, remarks


def _cells(line: str) -> list[str]:
    try:
        return next(csv.reader([line]), [])
    except csv.Error:
        return []


def _damaged_rows(head: list[str], rows: list[list[str]], words: list[str]) -> list[int]:
    """Return the indices of damaged rows of a results table.

    A row is damaged if its number of cells is wrong, if a text cell is empty, or if it has text in
    a column of numbers.
    """
    damaged = {k for k, row in enumerate(rows) if len(row) != len(head)}
    for place, name in enumerate(head):
        cells = {k: row[place] for k, row in enumerate(rows) if k not in damaged}
        filled = {k for k, cell in cells.items() if cell}
        if name in words:
            damaged |= cells.keys() - filled
            continue
        texts = {k for k in filled if not _is_number(cells[k])}
        damaged |= texts if 2 * len(texts) < len(filled) else set()
    return sorted(damaged)


def _is_number(cell: str) -> bool:
    try:
        return not isnan(float(cell))
    except ValueError:
        return False


def read_study(folder: Path) -> tuple[dict[str, Any], list[str]]:
    """Return the valid entries in the record of a sweep, and sentences on damaged entries."""
    try:
        record = json.loads((folder / STUDY).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}, []
    except (OSError, ValueError) as error:
        return {}, [f"{STUDY} is damaged: {error}."]
    if not isinstance(record, dict):
        return {}, [f"{STUDY} is damaged: it is not the record of a sweep."]
    damaged = [name for name in _TEXTS.keys() & record.keys() if not _is_text(name, record[name])]
    remarks = [f"{STUDY} is damaged: the entry {name} is omitted." for name in sorted(damaged)]
    return {name: value for name, value in record.items() if name not in damaged}, remarks


def _is_text(name: str, value: object) -> bool:
    """Return whether a value of study.json is text, or a list or dict of text, as in `_TEXTS`."""
    if not isinstance(value, _TEXTS[name]):
        return False
    texts = value.values() if isinstance(value, dict) else value
    return all(isinstance(text, str) for text in texts)


def write_study(
    folder: Path,
    cases: list[Case],
    settings: Mapping[str, Any],
    made_with: Mapping[str, str],
    by_theory: bool = False,
) -> None:
    """Write the record of a sweep before its simulations start, or of a study by theory."""
    facts = [case.facts() for case in cases]
    record = {
        "command": cases[0].command,
        "cases": len(cases),
        "by_theory": by_theory,
        "settings": settings,
        "words": sorted(k for k in facts[0] if all(isinstance(row.get(k), str) for row in facts)),
        "materials": {name: value.variables() for name, value in materials_of(cases).items()},
        "versions": made_with,
    }
    (folder / STUDY).write_text(json.dumps(record, indent=2, default=_plain) + "\n")


def _plain(value: Any) -> list | str:
    """Convert a value for JSON: several values to a list, a material to its name."""
    return list(value) if isinstance(value, Iterable) else str(getattr(value, "name", value))


def materials_of(cases: Iterable[Case]) -> dict[str, Material]:
    """Return the materials of all bodies by name.

    Raises:
        ValueError: Two different materials have one name, which tables could not distinguish.
    """
    materials: dict[str, Material] = {}
    for case in cases:
        for value in attrs.astuple(case, recurse=False):
            if isinstance(value, Material) and materials.setdefault(value.name, value) != value:
                raise ValueError(
                    f"two different materials have the name {value.name}. Rename one of their files"
                )
    return materials
