# SPDX-License-Identifier: GPL-2.0-or-later
"""Run settled beds on several ranks: the parts of size.py that need more than one rank."""

from __future__ import annotations

import argparse
import os
import subprocess
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from time import monotonic
from unittest.mock import patch

import numpy as np
from rounds import turns
from size_beds import DECKS, WIDTHS, WORK, base, run, widen, write

from plastigran.engine.dumps import read_dump
from plastigran.engine.process import EngineError

LAW = {"law": "thornton"}


def ranks(options: argparse.Namespace) -> None:
    """Measure strong and weak scaling by elapsed time.

    For comparison, two beds of half the size run at the same time on one rank each. Their time
    shows the cost of sharing the machine without communication.
    """
    grains = options.grains[0]
    along = WIDTHS[grains]
    whole, half = (widen(base(), *copies) for copies in (along, (along[0] // 2, along[1])))
    settings = LAW | {"steps": options.steps}
    runs: dict[str, Callable[[], float]] = {
        "whole, 1 rank": lambda: run(whole, settings, WORK / "ranks").clock,
        "whole, 2 ranks": lambda: run(whole, settings, WORK / "ranks", ranks=2).clock,
        "half, 1 rank": lambda: run(half, settings, WORK / "ranks").clock,
        "two halves at the same time": lambda: two_at_once(half, settings),
        "whole, 1 rank again": lambda: run(whole, settings, WORK / "ranks").clock,
    }
    rows = [
        {"round": round_, "way": way, "clock": runs[way]()}
        for round_, way in turns(list(runs), options.repeats, "ranks")
    ]
    wide = write(rows, "ranks").pivot(index="round", columns="way", values="clock")
    one, two = wide["whole, 1 rank"], wide["whole, 2 ranks"]
    for name, ratio in {
        "strong scaling: 1 rank / 2 ranks": one / two,
        "limit: 1 rank / two halves at the same time": one / wide["two halves at the same time"],
        "2 ranks / two halves at the same time": two / wide["two halves at the same time"],
        "weak scaling: half on 1 rank / whole on 2": wide["half, 1 rank"] / two,
        "noise: 1 rank again / 1 rank": wide["whole, 1 rank again"] / one,
    }.items():
        print(f"{name}: {ratio.median():.2f} ({ratio.min():.2f} to {ratio.max():.2f})")


def two_at_once(bed: Path, settings: dict[str, object]) -> float:
    """Return the mean elapsed time of two runs of a bed at the same time [s]."""
    with ThreadPoolExecutor() as pool:
        runs = pool.map(lambda name: run(bed, settings, WORK / name), ("left", "right"))
        return float(np.mean([done.clock for done in runs]))


def many(options: argparse.Namespace, count: int = 64) -> None:
    """Print the largest differences of any grain between the base bed on one and on many ranks."""
    ends = {}
    for number in (1, count):
        began = monotonic()
        case = LAW | {"steps": options.steps, "rest": options.steps}
        run(widen(base(), 1, 1), case, WORK / f"ranks_{number}", number)
        dump = read_dump(WORK / f"ranks_{number}" / "end.dump")
        ends[number] = dump[dump["step"] == dump["step"].max()].sort_values("id", ignore_index=True)
        print(f"{number} ranks: {monotonic() - began:.0f} s")
    one, other = ends[1], ends[count]
    if list(one["id"]) != list(other["id"]):
        raise EngineError(
            f"the final states have different grains: {len(one)} on one rank, {len(other)} on "
            f"{count} ranks"
        )
    for quantity, columns, scale in (
        ("positions / smallest radius", ["xu", "yu", "zu"], 2e-3),
        ("velocities / largest velocity", ["vx", "vy", "vz"], None),
        ("forces / largest force", ["fx", "fy", "fz"], None),
    ):
        scale = scale or one[columns].abs().max(axis=None)
        difference = (one[columns] - other[columns]).abs().max(axis=None)
        print(f"{quantity}: largest difference {difference / scale:.1e}")


def calls(options: argparse.Namespace) -> None:
    """Print the MPI calls and bytes per step of the first of four ranks."""
    program = WORK / "mpi_calls.so"
    source = DECKS / "mpi_calls.c"
    subprocess.run(["mpicc", "-O2", "-shared", "-fPIC", "-o", program, source], check=True)
    bed, counts = widen(base(), 1, 1), []
    for law, ledger in (("hertz", 0), ("thornton", 1)):
        for steps in (options.steps, 11 * options.steps):
            case = {"law": law, "ledger": ledger, "steps": steps}
            with patch.dict(os.environ, {"LD_PRELOAD": str(program)}):
                done = run(bed, case, WORK / "calls", ranks=4)
            lines = (WORK / "calls" / "mpi_calls.0").read_text().splitlines()
            counts.append(np.array([line.split()[1:] for line in lines], float))
        a_step = (counts[-1] - counts[-2]) / (10 * options.steps)
        print(f"{law}, ledger {ledger}, {done.ghosts:.0f} ghost atoms per rank:")
        for line, (number, size) in zip(lines, a_step, strict=True):
            if number:
                print(f"  {line.split()[0]}: {number:.4g} per step, {size:.4g} bytes")


def maps(options: argparse.Namespace) -> None:
    """Print the memory of the base bed with small atom IDs, and with large IDs as in a huge bed."""
    for first in (1, 250_000_000):
        for way in ("array", "hash"):
            bed = widen(base(), 1, 1, first)
            done = run(bed, LAW | {"steps": options.steps, "map": way}, WORK / "maps")
            case = f"IDs up to {first + done.grains - 1}, map {way}"
            print(f"{case}: {done.peak / 1e6:.0f} MB, {done.processor:.2f} s of processor time")
