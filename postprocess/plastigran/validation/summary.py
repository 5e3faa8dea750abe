# SPDX-License-Identifier: GPL-2.0-or-later
"""Summary of the errors of a law in one line, at the top of the law's page in docs/laws."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.calibration.expected_errors import KINDS
from plastigran.validation.laws_on_spheres import FITTED_LAW

#: Upper bounds of the speed regimes in the summary, impact speed / yield speed.
UPPER_ENDS = (10, 100, 300, 1000)
WORDS = {"coefficient_of_restitution": "restitution", "force_max": "force"}
LINE = re.compile(r"^\| \*\*How far off\*\* \| .* \|$", re.MULTILINE)


def how_far_off(law: str, table: pd.DataFrame) -> str:
    """Return the errors of a law for perfectly plastic spheres in words, by speed regime.

    Args:
        law: Name of the law.
        table: Table of `plastigran.calibration.expected_errors.errors_table`.

    Returns:
        Text with the root mean square errors of restitution and largest force [%].
    """
    rows = table[(table["law"] == law) & (table["kind"] == KINDS[0])]
    parts = []
    for quantity, word in WORDS.items():
        errors, start = [], 0
        for end in UPPER_ENDS:
            inside = rows["speed_ratio_to"].between(start, end, inclusive="right")
            part = rows[inside & (rows["quantity"] == quantity)]
            rms = 100 * np.average(part["rms"] ** 2, weights=part["cases"]) ** 0.5
            errors.append(f"{rms:.0f}" if rms >= 10 else f"{rms:.2g}")
            start = end
        parts.append(f"{word} {', '.join(errors)} %")
    *first, last = (f"{start}–{end}" for start, end in pairwise((1, *UPPER_ENDS)))
    ranges = f"{', '.join(first)} and {last}"
    metals = " of metals outside the fit" if law == FITTED_LAW else ""
    return (
        f"rms difference from finite elements{metals} at [{ranges} yield speeds]"
        f"(../laws.md#accuracy-on-law-pages): {'; '.join(parts)}"
    )


def summarised(page: str, law: str, table: pd.DataFrame) -> str:
    """Return the page of a law with a new summary of its errors.

    Args:
        page: Text of the page.
        law: Name of the law.
        table: As for `how_far_off`.

    Raises:
        ValueError: The page lacks the line `| **How far off** | ... |`.
    """
    if not LINE.search(page):
        raise ValueError(
            f"the page of {law} has no line `| **How far off** | ... |`. Add this line to the "
            "table at the top of the page"
        )
    return LINE.sub(lambda _: f"| **How far off** | {how_far_off(law, table)} |", page, count=1)


def write_summaries(folder: Path, table: pd.DataFrame) -> list[Path]:
    """Write the summary of the errors of each law into the page of this law; return the pages.

    Args:
        folder: Folder of the law pages.
        table: As for `how_far_off`.

    Raises:
        ValueError: A page lacks the line `| **How far off** | ... |`.
    """
    pages = [folder / f"{law}.md" for law in sorted(set(table["law"]))]
    for page in pages:
        page.write_text(summarised(page.read_text(), page.stem, table))
    return pages
