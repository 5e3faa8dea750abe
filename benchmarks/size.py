#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Large settled beds: time and memory per grain, checkpoints, restarts, ranks.

    ./run bench size                                        # 50 000 and 200 000 grains
    ./run bench size --part cost --grains 1000000 --repeats 1

A bed of 25 by 25 by 20 grains settles once on a floor (size/settle.in, kept in build/bench/size);
wider ones are copies of it side by side, as deep and as dense. Contenders take turns within a
round; times are of the processor unless ranks are compared, and ratios are taken within a round.

    cost        time and memory of laws, the ledger off and on; a checkpoint and the way on from it
    ranks       strong and weak scaling on two ranks, and what two beds cost that run side by side
    settings    where a step's time goes, and what the deck's settings change
    many        one bed on 1 and on 64 ranks that share the cores: how equal the ends are
    calls       messages and reductions of a step on four ranks (size/mpi_calls.c)
"""

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
import pandas as pd
from size_beds import DECKS, SECTIONS, WORK, base, run, widen
from tqdm import tqdm

from plastigran.engine.dumps import read_dump
from plastigran.engine.process import PROJECT, EngineError, run_deck

RESULTS = PROJECT / "results" / "bench"
REFERENCE = "hertz"
LAWS = {
    REFERENCE: {"law": "hertz"},
    "thornton": {"law": "thornton"},
    "thornton, ledger": {"law": "thornton", "ledger": 1},
    "universal": {"law": "universal"},
    "universal, ledger": {"law": "universal", "ledger": 1},
    "hertz again": {"law": "hertz"},
}
#: One change each from a settled bed's usual settings.
SETTINGS = {
    "as it is": {},
    "again": {},
    "skin 1 % of a radius": {"skin": 2.5e-5},
    "skin 40 % of a radius": {"skin": 1e-3},
    "neigh_modify every 10": {"every": 10},
    "sort 0": {"sort": 0},
    "sort 100": {"sort": 100},
}
#: Copies of the base along x and y, by grains.
WIDTHS = {12_500: (1, 1), 25_000: (2, 1), 50_000: (2, 2), 200_000: (4, 4), 1_000_000: (8, 10)}


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


def cost(options: argparse.Namespace) -> None:
    """Time and memory of every law; a checkpoint of the first plastic one."""
    for grains in options.grains:
        bed, rows = widen(base(), *WIDTHS[grains]), []
        for round_, name in turns(options.law, options.repeats, f"{grains} grains"):
            done = run(bed, LAWS[name] | {"steps": options.steps}, WORK / "run")
            rows.append({"round": round_, "law": name, **done.row()})
        print_cost(write(rows, f"cost_{grains}"))
        print_restart(bed, options.steps)


def print_cost(table: pd.DataFrame) -> None:
    """Medians of the rounds, and of ratios to the reference of the round."""
    table["microseconds"] = 1e6 * table["processor"] / table["steps"] / table["grains"]
    memory = ["first", "later", "peak"]
    wide = table.set_index(["round", "law"])[["processor", *memory]].unstack("law")
    ratio = {key: wide[key].div(wide[key][REFERENCE], axis=0) for key in ("processor", *memory)}
    found = table.groupby("law", sort=False)
    shown = pd.DataFrame(
        {
            "microseconds a grain and step": found["microseconds"].median().map("{:.3f}".format),
            "time over hertz": ratio["processor"].median().map("{:.2f}".format),
            "lowest": ratio["processor"].min().map("{:.2f}".format),
            "highest": ratio["processor"].max().map("{:.2f}".format),
        }
        | {
            f"bytes a grain, {key}": (found[key].median() / table["grains"].iloc[0]).round()
            for key in memory
        }
        | {f"{key} over hertz": ratio[key].median().round(3) for key in memory}
    )
    shown = shown.loc[[name for name in LAWS if name in shown.index]]
    print(f"\n{table['grains'].iloc[0]} grains\n{shown.to_string()}")


def print_restart(bed: Path, steps: int) -> None:
    """A checkpoint in mid-run, and whether the way on from it ends as the run does, in every
    digit of every grain's position, velocity and force."""
    whole, again = WORK / "whole", WORK / "again"
    done = run(bed, LAWS["thornton"] | {"steps": steps, "rest": steps}, whole)
    written = (whole / "bed.restart").stat().st_size
    rest = {"restart": whole / "bed.restart", "rest": steps, "here": DECKS}
    run_deck(DECKS / "again.in", LAWS["thornton"] | rest, again, timeout=None)
    ends = [(folder / "end.dump").read_bytes() for folder in (whole, again)]
    print(
        f"checkpoint: {written / done.grains:.0f} bytes a grain, {done.checkpoint:.2f} s of the "
        f"processor; {steps} steps on from it: "
        f"{'the same in every digit' if ends[0] == ends[1] else 'NOT the same'}"
    )


def ranks(options: argparse.Namespace) -> None:
    """Strong and weak scaling, by the clock. Two beds of half the size on a rank each, at the same
    time, cost what the machine takes from two ranks that have nothing to say to each other."""
    grains = options.grains[0]
    along = WIDTHS[grains]
    whole, half = (widen(base(), *copies) for copies in (along, (along[0] // 2, along[1])))
    settings = LAWS["thornton"] | {"steps": options.steps}
    ways: dict[str, Callable[[], float]] = {
        "whole, 1 rank": lambda: run(whole, settings, WORK / "run").clock,
        "whole, 2 ranks": lambda: run(whole, settings, WORK / "run", ranks=2).clock,
        "half, 1 rank": lambda: run(half, settings, WORK / "run").clock,
        "two halves side by side": lambda: side_by_side(half, settings),
        "whole, 1 rank again": lambda: run(whole, settings, WORK / "run").clock,
    }
    rows = [
        {"round": round_, "way": way, "clock": ways[way]()}
        for round_, way in turns(list(ways), options.repeats, "ranks")
    ]
    wide = write(rows, "ranks").pivot(index="round", columns="way", values="clock")
    one, two = wide["whole, 1 rank"], wide["whole, 2 ranks"]
    for name, ratio in {
        "strong: 1 rank over 2": one / two,
        "what two beds side by side allow": one / wide["two halves side by side"],
        "2 ranks over two beds side by side": two / wide["two halves side by side"],
        "weak: half on 1 rank over whole on 2": wide["half, 1 rank"] / two,
        "noise: 1 rank again over 1 rank": wide["whole, 1 rank again"] / one,
    }.items():
        print(f"{name}: {ratio.median():.2f} ({ratio.min():.2f} to {ratio.max():.2f})")


def side_by_side(bed: Path, settings: dict[str, object]) -> float:
    """Mean time by the clock of a bed of which two run at once [s]."""
    with ThreadPoolExecutor() as pool:
        runs = pool.map(lambda name: run(bed, settings, WORK / name), ("left", "right"))
        return float(np.mean([done.clock for done in runs]))


def settings(options: argparse.Namespace) -> None:
    """What the settings of a deck change, over enough steps that neighbours are listed anew."""
    bed, rows = widen(base(), *WIDTHS[options.grains[0]]), []
    for round_, name in turns(list(SETTINGS), options.repeats, "settings"):
        changed = LAWS["thornton"] | {"steps": options.steps} | SETTINGS[name]
        rows.append({"round": round_, "setting": name, **run(bed, changed, WORK / "run").row()})
    table = write(rows, "settings")
    for section in SECTIONS:
        table[section] = table[section] / table["clock"]
    wide = table.pivot(index="round", columns="setting", values="processor")
    shown = table.groupby("setting")[[*SECTIONS]].median().map("{:.1%}".format)
    ratio = wide.div(wide["as it is"], axis=0)
    shown["time"] = ratio.median().map("{:.2f}".format)
    shown["lowest"], shown["highest"] = ratio.min().round(2), ratio.max().round(2)
    shown["pairs listed"] = table.groupby("setting")["neighbours"].median()
    print(shown.loc[list(SETTINGS)].to_string())


def many(options: argparse.Namespace, count: int = 64) -> None:
    """The base on 1 and on many ranks, and the largest differences of any grain."""
    ends = {}
    for number in (1, count):
        began = monotonic()
        case = LAWS["thornton"] | {"steps": options.steps, "rest": options.steps}
        run(widen(base(), 1, 1), case, WORK / f"ranks_{number}", number)
        dump = read_dump(WORK / f"ranks_{number}" / "end.dump")
        ends[number] = dump[dump["step"] == dump["step"].max()].sort_values("id", ignore_index=True)
        print(f"{number} ranks: {monotonic() - began:.0f} s")
    one, other = ends[1], ends[count]
    if list(one["id"]) != list(other["id"]):
        raise EngineError(f"{len(one)} grains on one rank, {len(other)} on {count}")
    for words, columns, scale in (
        ("positions, over the smallest radius", ["xu", "yu", "zu"], 2e-3),
        ("velocities, over the largest", ["vx", "vy", "vz"], None),
        ("forces, over the largest", ["fx", "fy", "fz"], None),
    ):
        scale = scale or one[columns].abs().max(axis=None)
        difference = (one[columns] - other[columns]).abs().max(axis=None)
        print(f"{words}: at most {difference / scale:.1e} apart")


def calls(options: argparse.Namespace) -> None:
    """What the base's first of four ranks hands to MPI, a step."""
    program = WORK / "mpi_calls.so"
    source = DECKS / "mpi_calls.c"
    subprocess.run(["mpicc", "-O2", "-shared", "-fPIC", "-o", program, source], check=True)
    bed, counts = widen(base(), 1, 1), []
    for law, ledger in ((REFERENCE, 0), ("thornton", 1)):
        for steps in (options.steps, 11 * options.steps):
            case = {"law": law, "ledger": ledger, "steps": steps}
            with patch.dict(os.environ, {"LD_PRELOAD": str(program)}):
                done = run(bed, case, WORK / "calls", ranks=4)
            lines = (WORK / "calls" / "mpi_calls.0").read_text().splitlines()
            counts.append(np.array([line.split()[1:] for line in lines], float))
        a_step = (counts[-1] - counts[-2]) / (10 * options.steps)
        print(f"{law}, ledger {ledger}, {done.ghosts:.0f} copies a rank:")
        for line, (number, size) in zip(lines, a_step, strict=True):
            if number:
                print(f"  {line.split()[0]}: {number:.4g} a step, {size:.4g} bytes")


PARTS = {part.__name__: part for part in (cost, ranks, settings, many, calls)}


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--part", nargs="+", choices=PARTS, default=list(PARTS), help="all")
    parser.add_argument(
        "--grains", type=int, nargs="+", choices=WIDTHS, default=[50_000, 200_000], metavar="N",
        help=f"of {', '.join(map(str, WIDTHS))}; ranks and settings take the first",
    )  # fmt: skip
    parser.add_argument("--law", nargs="+", choices=LAWS, default=list(LAWS), help="default: all")
    parser.add_argument("--repeats", type=int, default=3, help="rounds (default: %(default)s)")
    parser.add_argument("--steps", type=int, default=100, help="timed (default: %(default)s)")
    options = parser.parse_args()
    if options.repeats < 1 or options.steps < 1:
        parser.error("--repeats and --steps must be at least 1")
    options.law = [REFERENCE, *(law for law in options.law if law != REFERENCE)]
    for part in options.part:
        PARTS[part](options)


if __name__ == "__main__":
    try:
        main()
    except EngineError as error:
        raise SystemExit(f"ERROR: {error}") from None
