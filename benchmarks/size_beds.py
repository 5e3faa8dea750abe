# SPDX-License-Identifier: GPL-2.0-or-later
"""Settled beds of any width, and what a run of one took."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from tqdm import tqdm

from plastigran.engine.process import PROJECT, EngineError, run_deck

HERE = Path(__file__).resolve().parent
DECKS = HERE / "size"
WORK = PROJECT / "build" / "bench" / "size"
RESULTS = PROJECT / "results" / "bench"
#: Copies of the base along x and y, by grains.
WIDTHS = {12_500: (1, 1), 25_000: (2, 1), 50_000: (2, 2), 200_000: (4, 4), 1_000_000: (8, 10)}
#: Rows of the engine's table of times.
SECTIONS = ("Pair", "Neigh", "Comm", "Outpt", "Other")


def turns(names: list[str], repeats: int, bar: str) -> list[tuple[int, str]]:
    """Rounds in which every name has its turn, beginning with another each time."""
    order = [
        (round_, name)
        for round_ in range(repeats)
        for name in names[round_ % len(names) :] + names[: round_ % len(names)]
    ]
    return tqdm(order, desc=bar, unit="run")


def write(rows: list[dict], name: str) -> pd.DataFrame:
    """Keep all rounds as results/bench/size_<name>.csv."""
    table = pd.DataFrame(rows)
    RESULTS.mkdir(parents=True, exist_ok=True)
    table.to_csv(RESULTS / f"size_{name}.csv", index=False, float_format="%.6g")
    return table


@dataclass(frozen=True)
class Run:
    """What a run of bed.in took.

    Attributes:
        grains: In the bed.
        ranks: MPI ranks.
        steps: That were timed.
        clock: Of these steps [s].
        processor: Of the first rank in these steps [s].
        first: Memory of the first rank in its first run, before these steps [bytes].
        later: In these steps.
        peak: The most it had; after a run the plugin keeps contacts for the next.
        sections: Seconds by the engine's own table, by name of `SECTIONS`.
        ghosts: Copies of other ranks' or periodic grains, mean of the ranks.
        neighbours: Pairs that are listed.
        checkpoint: Processor time of the checkpoint [s]; nan without one.
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
    neighbours: int
    checkpoint: float = float("nan")

    def row(self) -> dict[str, float]:
        """All of it, flat."""
        flat = asdict(self)
        return flat | flat.pop("sections")


def base(across: int = 25, high: int = 20, steps: int = 8000) -> Path:
    """A settled bed of across * across * high grains, made when it is missing."""
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
    """A bed of copies of another side by side, made when it is missing or older than that.

    Args:
        settled: Its data file, of `base` say; periodic in the directions in which it is copied.
        along_x: Copies.
        along_y: Copies.
        first: Number of the first grain.
        along_z: Copies.

    Returns:
        Its data file. Grains are at rest, contacts without a past.
    """
    sides = (along_x, along_y, along_z)
    file = settled.parent / f"{'_'.join(map(str, sides))}_{first}.data"
    if file.exists() and file.stat().st_mtime >= settled.stat().st_mtime:
        return file
    text = settled.read_text()
    bounds = re.findall(r"^(\S+) (\S+) [xyz]lo [xyz]hi$", text, re.MULTILINE)
    low, high = np.array(bounds, float).T
    rows = text.partition("Atoms\n\n")[2].partition("\n\n")[0].splitlines()
    one = np.array([row.split()[:7] for row in rows], float)  # number type diameter density x y z
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
        bed: Its data file.
        settings: Of the deck: law, ledger, steps and so on.
        folder: For what it leaves.
        ranks: MPI ranks.
        deck: Of benchmarks/size.

    Raises:
        EngineError: It failed, or its log is not as expected.
    """
    variables = {"bed": bed, "here": DECKS, **settings}
    log = run_deck(DECKS / deck, variables, folder, ranks, timeout=None)
    stamps = np.array([line.split() for line in (folder / "stamps").read_text().splitlines()])
    processor, clock = stamps[:, 0].astype(float) / 1e9, stamps[:, -1].astype(float)
    # The first run is to warm up, the second is the one.
    part = log.split("Loop time of")[2]
    head = re.search(r"for (\d+) steps with (\d+) atoms", part)
    found = {
        name: re.search(rf"^{name} +time \(%\) = (\S+)", part, re.MULTILINE) for name in SECTIONS
    }
    ghosts = re.search(r"^Nghost: +(\S+) ave", part, re.MULTILINE)
    pairs = re.search(r"^Total # of neighbors = (\d+)", part, re.MULTILINE)
    if not (head and ghosts and pairs and all(found.values())):
        raise EngineError(f"{folder}: the log lacks the table of times")
    return Run(
        grains=int(head[2]),
        ranks=ranks,
        steps=int(head[1]),
        clock=clock[1] - clock[0],
        processor=processor[1] - processor[0],
        first=_bytes(folder / "first"),
        later=_bytes(folder / "later"),
        peak=_bytes(folder / "peak"),
        sections={name: float(match[1]) for name, match in found.items() if match},
        ghosts=float(ghosts[1]),
        neighbours=int(pairs[1]),
        checkpoint=processor[3] - processor[2] if len(stamps) > 3 else float("nan"),
    )


def _bytes(file: Path) -> float:
    """The median of what the kernel said of a process' memory; nan when it was gone before."""
    found = [int(line.split()[1]) for line in file.read_text().splitlines()]
    return 1024 * float(np.median(found)) if found else float("nan")
