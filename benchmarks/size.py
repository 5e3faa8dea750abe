#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure large settled beds: time and memory per grain, checkpoints, restarts, ranks.

    ./run bench size                                        # 50 000 and 200 000 grains
    ./run bench size --part cost --grains 1000000 --repeats 1

A bed of 25 by 25 by 20 grains settles once on a floor (size/settle.in, kept in build/bench/size).
Wider beds are copies of this bed side by side. All laws run once per round, and ratios are computed
from the times of the same round. Times are processor times, except that the comparison of ranks
uses elapsed times.

    cost        time and memory of laws, without and with energy balance; checkpoint and restart
    ranks       strong and weak scaling on two ranks, and the cost of two beds at the same time
    settings    parts of the time of a step, and the effect of settings of the deck
    many        differences between the results on 1 rank and on 64 ranks, which share the cores
    calls       messages and reductions of a step on four ranks (size/mpi_calls.c)
    maps        memory of the table of all atom IDs, which every rank stores
"""

from __future__ import annotations

import argparse
from pathlib import Path

import pandas as pd
from rounds import start, turns
from size_beds import DECKS, SECTIONS, WIDTHS, WORK, base, run, widen, write
from size_parallel import calls, many, maps, ranks

from plastigran.cli.arguments import positive_integer
from plastigran.engine.process import run_deck

REFERENCE = "hertz"
LAWS = {
    REFERENCE: {"law": "hertz"},
    "thornton": {"law": "thornton"},
    "thornton, ledger": {"law": "thornton", "ledger": 1},
    "universal": {"law": "universal"},
    "universal, ledger": {"law": "universal", "ledger": 1},
    "hertz again": {"law": "hertz"},
}
#: Changed settings of a settled bed, by the description of the change.
SETTINGS = {
    "as it is": {},
    "again": {},
    "skin 1 % of a radius": {"skin": 2.5e-5},
    "skin 40 % of a radius": {"skin": 1e-3},
    "neigh_modify every 10": {"every": 10},
    "sort 0": {"sort": 0},
    "sort 100": {"sort": 100},
}


def cost(options: argparse.Namespace) -> None:
    """Measure time and memory of every law, and test a restart with `thornton`."""
    for grains in options.grains:
        bed, rows = widen(base(), *WIDTHS[grains]), []
        for round_, name in turns(options.law, options.repeats, f"{grains} grains"):
            done = run(bed, LAWS[name] | {"steps": options.steps}, WORK / "run")
            rows.append({"round": round_, "law": name, **done.row()})
        print_cost(write(rows, f"cost_{grains}"))
        print_restart(bed, options.steps)


def print_cost(table: pd.DataFrame) -> None:
    """Print medians over all rounds: times, and ratios to the reference of the same round."""
    table["microseconds"] = 1e6 * table["processor"] / table["steps"] / table["grains"]
    memory = ["first", "later", "peak"]
    wide = table.set_index(["round", "law"])[["processor", *memory]].unstack("law")
    ratio = {key: wide[key].div(wide[key][REFERENCE], axis=0) for key in ("processor", *memory)}
    by_law = table.groupby("law", sort=False)
    shown = pd.DataFrame(
        {
            "microseconds per grain and step": by_law["microseconds"].median().map("{:.3f}".format),
            "time / time of hertz": ratio["processor"].median().map("{:.2f}".format),
            "lowest": ratio["processor"].min().map("{:.2f}".format),
            "highest": ratio["processor"].max().map("{:.2f}".format),
        }
        | {
            f"bytes per grain, {key}": (by_law[key].median() / table["grains"].iloc[0]).round()
            for key in memory
        }
        | {f"{key} / {key} of hertz": ratio[key].median().round(3) for key in memory}
    )
    shown = shown.loc[[name for name in LAWS if name in shown.index]]
    print(f"\n{table['grains'].iloc[0]} grains\n{shown.to_string()}")


def print_restart(bed: Path, steps: int) -> None:
    """Print whether a restarted run ends bitwise identical to the run without restart.

    The comparison includes positions, velocities and forces of every grain.
    """
    whole, again = WORK / "whole", WORK / "again"
    done = run(bed, LAWS["thornton"] | {"steps": steps, "rest": steps}, whole)
    written = (whole / "bed.restart").stat().st_size
    rest = {"restart": whole / "bed.restart", "rest": steps, "here": DECKS}
    run_deck(DECKS / "again.in", LAWS["thornton"] | rest, again, timeout=None)
    ends = [(folder / "end.dump").read_bytes() for folder in (whole, again)]
    print(
        f"checkpoint: {written / done.grains:.0f} bytes per grain, {done.checkpoint:.2f} s of "
        f"processor time; {steps} steps after a restart, the results are "
        f"{'bitwise identical' if ends[0] == ends[1] else 'NOT identical'}"
    )


def settings(options: argparse.Namespace) -> None:
    """Measure the effect of settings in a run that rebuilds its neighbor lists."""
    bed, rows = widen(base(), *WIDTHS[options.grains[0]]), []
    for round_, name in turns(list(SETTINGS), options.repeats, "settings"):
        changed = LAWS["thornton"] | {"steps": options.steps} | SETTINGS[name]
        rows.append(
            {"round": round_, "setting": name, **run(bed, changed, WORK / "settings").row()}
        )
    table = write(rows, "settings")
    for section in SECTIONS:
        table[section] = table[section] / table["clock"]
    wide = table.pivot(index="round", columns="setting", values="processor")
    shown = table.groupby("setting")[[*SECTIONS]].median().map("{:.1%}".format)
    ratio = wide.div(wide["as it is"], axis=0)
    shown["time"] = ratio.median().map("{:.2f}".format)
    shown["lowest"], shown["highest"] = ratio.min().round(2), ratio.max().round(2)
    shown["pairs listed"] = table.groupby("setting")["neighbors"].median()
    print(shown.loc[list(SETTINGS)].to_string())


PARTS = {part.__name__: part for part in (cost, ranks, settings, many, calls, maps)}


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument(
        "--part", nargs="+", choices=PARTS, default=list(PARTS), help="default: all"
    )
    parser.add_argument(
        "--grains", type=int, nargs="+", choices=WIDTHS, default=[50_000, 200_000], metavar="N",
        help=f"numbers of grains: {', '.join(map(str, WIDTHS))}; `ranks` and `settings` use the "
        "first number",
    )  # fmt: skip
    parser.add_argument("--law", nargs="+", choices=LAWS, default=list(LAWS), help="default: all")
    parser.add_argument(
        "--repeats",
        type=positive_integer,
        default=3,
        help="number of rounds (default: %(default)s)",
    )
    parser.add_argument(
        "--steps",
        type=positive_integer,
        default=100,
        help="number of timed steps (default: %(default)s)",
    )
    options = parser.parse_args()
    options.law = [REFERENCE, *(law for law in options.law if law != REFERENCE)]
    for part in options.part:
        PARTS[part](options)


if __name__ == "__main__":
    start(main)
