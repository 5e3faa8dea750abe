# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes case files from the references: `make_cases.py [LAW ...]`, all laws when none is named."""

from __future__ import annotations

import csv
import io
import sys
from dataclasses import asdict
from importlib import import_module
from itertools import pairwise
from pathlib import Path

FOLDER = Path(__file__).parent
CASES = FOLDER.parent / "cases"
sys.path.insert(0, str(FOLDER.parent))  # as in the tests, so that it runs as a script

from references.central_impact import CentralImpact, Outcome  # noqa: E402
from references.contact import MATERIALS  # noqa: E402

#: Laws that have a reference: every module here but this one and what they share.
LAWS = sorted(
    {path.stem for path in FOLDER.glob("*.py")} - {"central_impact", "contact", "make_cases"}
)


def reference(law: str) -> type[CentralImpact]:
    return import_module(f"references.{law}").Reference


def jumps(impact: CentralImpact) -> str:
    """Lines `# jump OVERLAP SIZE` where one formula of the virgin force ends and the next begins:
    in overlaps at yield, and as a share of the force."""
    lines = ""
    for (end, before), (_, beyond) in pairwise(impact.pieces):
        size = float(beyond(end) / before(end)) - 1
        if abs(size) > 1e-9:
            place = end / impact.overlap_at(impact.material.yield_pressure)
            lines += f"# jump {place:.6g} {size:.4g}\n"
    return lines


def digits(value: float, form: str) -> str:
    text = format(value, form)
    return f"{float(text):g}" if float(text) in (0, 1) else text


def impacts(law: str) -> list[tuple[dict[str, str], CentralImpact]]:
    """The rows of a law's case file, without their outcomes, and the impact of each."""
    return [
        (row, reference(law)(MATERIALS[row["material"]], **numbers(row)))
        for row in csv.DictReader(io.StringIO(reference(law).cases))
    ]


def numbers(row: dict[str, str]) -> dict[str, float]:
    return {name: float(text) for name, text in row.items() if name != "material"}


def outcomes(law: str) -> list[Outcome]:
    """Outcome of each row.

    Raises:
        ValueError: The two ways do not agree to 1e-9, or the elastic range leaves no rebound to
            ask for.
    """
    found = []
    for row, impact in impacts(law):
        end = impact.pieces[0][0]
        yields = type(impact).published_rebound is not CentralImpact.published_rebound
        if not end > 0 or (yields and end == float("inf")):
            raise ValueError(
                f"{law}: the first of pieces, the elastic one, ends at {end} m; it must end at the "
                "overlap at yield, beyond which published_rebound is asked"
            )
        one, other = impact.two_ways()
        if not one.agrees_with(other):
            raise ValueError(f"{law} at {row['speed']} m/s: {one} one way, {other} the other")
        found.append(one)
    return found


def case_file(law: str, found: list[Outcome]) -> str:
    """Text of a law's case file with these outcomes."""
    kind, cases, rows = reference(law), impacts(law), []
    for (row, _), outcome in zip(cases, found, strict=True):
        rows.append(row | {name: digits(x, kind.digits) for name, x in asdict(outcome).items()})
    text = io.StringIO()
    text.write(kind.comment + jumps(cases[0][1]))
    table = csv.DictWriter(text, rows[0], lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    return text.getvalue()


if __name__ == "__main__":
    if unknown := {*sys.argv[1:]} - {*LAWS}:
        sys.exit(f"no reference for {', '.join(sorted(unknown))}; there are {', '.join(LAWS)}")
    for law in sys.argv[1:] or LAWS:
        (CASES / f"{law}.csv").write_text(case_file(law, outcomes(law)))
