# SPDX-License-Identifier: GPL-2.0-or-later
"""Impacts of the benchmarks of Chung & Ooi (2011), and functions that choose and run them."""

from __future__ import annotations

import pandas as pd

from plastigran.engine.dumps import read_dump
from plastigran.experiments.chung_ooi import BenchmarkImpact


def sweeps(number: int) -> list[list[BenchmarkImpact]]:
    """Return the impacts of a benchmark, one list per sweep."""
    found: dict[tuple, list[BenchmarkImpact]] = {}
    for case in BenchmarkImpact.cases():
        if case.benchmark == number:
            found.setdefault((case.material, case.modulus_ratio), []).append(case)
    return list(found.values())


def middles(number: int) -> list[BenchmarkImpact]:
    """Return the middle impact of each sweep, in which springs stick and slide."""
    return [sweep[len(sweep) // 2] for sweep in sweeps(number)]


def few(number: int) -> list[BenchmarkImpact]:
    """Return the second, middle and last impact of each sweep."""
    return [
        sweep[k]
        for sweep in sweeps(number)
        for k in sorted({min(1, len(sweep) - 1), len(sweep) // 2, len(sweep) - 1})
    ]


def steps(case: BenchmarkImpact, folder) -> pd.DataFrame:
    """Return every step of an impact in LIGGGHTS."""
    case.run(folder)
    return read_dump(folder / "trajectory.dump")
