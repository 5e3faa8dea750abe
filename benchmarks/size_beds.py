# SPDX-License-Identifier: GPL-2.0-or-later
"""Make settled beds of any width, and measure time and memory of their runs."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.engine.process import PROJECT, EngineError, run_deck

HERE = Path(__file__).resolve().parent
DECKS = HERE / "size"
WORK = PROJECT / "build" / "bench" / "size"
RESULTS = PROJECT / "results" / "bench"
#: Numbers of copies of the base bed along x and y, by the number of grains.
WIDTHS = {12_500: (1, 1), 25_000: (2, 1), 50_000: (2, 2), 200_000: (4, 4), 1_000_000: (8, 10)}
#: Names of the rows in the table of times that LIGGGHTS prints after a run.
SECTIONS = ("Pair", "Neigh", "Comm", "Outpt", "Other")


def write(rows: list[dict], name: str) -> pd.DataFrame:
    """Write all rounds to results/bench/size_NAME.csv, and return them as a table."""
    table = pd.DataFrame(rows)
    RESULTS.mkdir(parents=True, exist_ok=True)
    table.to_csv(RESULTS / f"size_{name}.csv", index=False, float_format="%.6g")
    return table


@dataclass(frozen=True)
class Run:
    """Time and memory of a run of bed.in.

    Attributes:
        grains: Number of grains.
        ranks: Number of MPI ranks.
        steps: Number of timed steps.
        clock: Elapsed time of the timed steps [s].
        processor: Processor time of the first rank in the timed steps [s].
        first: Memory of the first rank in its first run, before the timed steps [bytes].
        later: Memory of the first rank during the timed steps [bytes].
        peak: Largest memory of the first rank [bytes], also between runs.
        sections: Times [s] in the table that LIGGGHTS prints, by the names in `SECTIONS`.
        ghosts: Mean number of ghost atoms of a rank.
        neighbors: Number of pairs in the neighbor lists.
        checkpoint: Processor time of the checkpoint [s]; nan without a checkpoint.
    """

    grains: int
    ranks: int
    steps: int
    clock: float
    processor: float
    first: float
    later: float
    peak: float
    sections: dict[str, float]
    ghosts: float
    neighbors: int
    checkpoint: float = float("nan")

    def row(self) -> dict[str, float]:
        """Return all values by name."""
        flat = asdict(self)
        return flat | flat.pop("sections")


def base(across: int = 25, high: int = 20, steps: int = 8000) -> Path:
    """Return the data file of a settled bed of across^2 * high grains; make it if missing."""
    folder = WORK / f"{across}_{across}_{high}"
    settled = folder / "settled.data"
    if not settled.exists():
        print(f"settling {across * across * high} grains (some minutes, once) ...", flush=True)
        folder.mkdir(parents=True, exist_ok=True)
        run_deck(HERE / "bed.in", {"across": across, "high": high, "steps": 1500}, folder)
        run_deck(
            DECKS / "settle.in",
            {"bed": folder / "bed.data", "steps": steps, "here": DECKS},
            folder,
            timeout=None,
        )
    return settled


def widen(settled: Path, along_x: int, along_y: int, first: int = 1, along_z: int = 1) -> Path:
    """Return the data file of copies of a bed side by side; make it if it is missing or old.

    Args:
        settled: Data file of the bed, periodic in the directions in which it is copied.
        along_x, along_y, along_z: Numbers of copies.
        first: ID of the first grain.

    Returns:
        Data file. Grains are at rest, and contacts have no history.
    """
    sides = (along_x, along_y, along_z)
    file = settled.parent / f"{'_'.join(map(str, sides))}_{first}.data"
    if file.exists() and file.stat().st_mtime >= settled.stat().st_mtime:
        return file
    text = settled.read_text()
    bounds = re.findall(r"^(\S+) (\S+) [xyz]lo [xyz]hi$", text, re.MULTILINE)
    low, high = np.array(bounds, float).T
    rows = text.partition("Atoms\n\n")[2].partition("\n\n")[0].splitlines()
    one = np.array([row.split()[:7] for row in rows], float)  # ID type diameter density x y z
    one[:, 0] = np.argsort(np.argsort(one[:, 0])) + first
    copies = np.array(list(np.ndindex(sides)))
    all_of_them = np.tile(one, (len(copies), 1))
    all_of_them[:, 0] += np.repeat(np.arange(len(copies)) * len(one), len(one))
    all_of_them[:, 4:] += np.repeat(copies * (high - low), len(one), axis=0)
    top = low + (high - low) * sides
    with open(file, "w") as out:
        out.write(f"a bed of {len(copies)} copies\n\n{len(all_of_them)} atoms\n2 atom types\n\n")
        for axis, a, b in zip("xyz", low, top, strict=True):
            out.write(f"{a:.17g} {b:.17g} {axis}lo {axis}hi\n")
        out.write("\nAtoms\n\n")
        np.savetxt(out, all_of_them, fmt="%d %d %.9g %.9g %.17g %.17g %.17g")
    return file


def run(
    bed: Path, settings: Mapping[str, object], folder: Path, ranks: int = 1, deck: str = "bed.in"
) -> Run:
    """Run a bed.

    Args:
        bed: Data file.
        settings: Variables of the deck, such as law, ledger and steps.
        folder: Folder of the results.
        ranks: Number of MPI ranks.
        deck: Name of a deck in benchmarks/size.

    Raises:
        EngineError: The run failed, or its log has no table of times.
    """
    variables = {"bed": bed, "here": DECKS, **settings}
    log = run_deck(DECKS / deck, variables, folder, ranks, timeout=None)
    stamps = np.array([line.split() for line in (folder / "stamps").read_text().splitlines()])
    processor, clock = stamps[:, 0].astype(float) / 1e9, stamps[:, -1].astype(float)
    # The first run is a warm-up; the second run is measured.
    part = log.split("Loop time of")[2]
    head = re.search(r"for (\d+) steps with (\d+) atoms", part)
    times = {
        name: re.search(rf"^{name} +time \(%\) = (\S+)", part, re.MULTILINE) for name in SECTIONS
    }
    ghosts = re.search(r"^Nghost: +(\S+) ave", part, re.MULTILINE)
    pairs = re.search(r"^Total # of neighbors = (\d+)", part, re.MULTILINE)
    if not (head and ghosts and pairs and all(times.values())):
        raise EngineError(f"{folder}: the log has no table of times; look there for an error")
    return Run(
        grains=int(head[2]),
        ranks=ranks,
        steps=int(head[1]),
        clock=clock[1] - clock[0],
        processor=processor[1] - processor[0],
        first=_bytes(folder / "first"),
        later=_bytes(folder / "later"),
        peak=_bytes(folder / "peak"),
        sections={name: float(match[1]) for name, match in times.items() if match},
        ghosts=float(ghosts[1]),
        neighbors=int(pairs[1]),
        checkpoint=processor[3] - processor[2] if len(stamps) > 3 else float("nan"),
    )


def _bytes(file: Path) -> float:
    """Return the median memory [bytes] in a file of lines `VmRSS: N kB`; nan if it is empty."""
    kilobytes = [int(line.split()[1]) for line in file.read_text().splitlines()]
    return 1024 * float(np.median(kilobytes)) if kilobytes else float("nan")
