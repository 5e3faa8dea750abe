#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the time of a step in the three decks of the benchmark of Dosta et al. 2024.

    ./run bench bulk_cost
    ./run bench bulk_cost --case ball_impact --repeats 5

First, a run with `hertz` settles the grains of each deck (kept in build/bench/bulk_cost). Then all
laws start from the same positions, on one and on two ranks, with the time steps of `plastigran
reproduce dosta24`. The grains are softened, so that they settle in few steps. Times are elapsed
times without the start of LIGGGHTS. In a round, every law runs once, and ratios are computed from
the times of the same round. After a change of the decks, delete the settled grains in
build/bench/bulk_cost.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path

import pandas as pd
from rounds import start, turns

from plastigran.bulk.run import run_bulk
from plastigran.cli.arguments import positive_integer
from plastigran.engine.process import PROJECT, EngineError, run_deck
from plastigran.papers.dosta24 import drum, impact, silo
from plastigran.papers.dosta24.beds import CONTACTS, softened_grains
from plastigran.plot.frame_files import find_frames, read_frame_file

WORK = PROJECT / "build" / "bench" / "bulk_cost"
RESULTS = PROJECT / "results" / "bench" / "bulk_cost.csv"
#: Settings of the runs that settle the grains. At the end of these runs, the ball is in the bed.
CASES = {
    "ball_impact": softened_grains(0.01) | {"timestep": 1e-5, "duration": 0.024},
    "silo": silo.SOFT | {"duration": 0.06, "settling": 0.01},
    "mixing_drum": drum.SOFT | {"duration": 0.15},
}
#: Time steps of the timed runs [s], if they differ from those in `CASES`. The farther the ball
#: moves in a step, the more often LIGGGHTS rebuilds its neighbor lists.
TIMESTEPS = {"ball_impact": impact.FULL["timestep"]}
REFERENCE = "hertz"
#: Settings of the contacts, by name. LIGGGHTS' own `hertz` has no energy balance.
LAWS = {
    REFERENCE: CONTACTS["hertz"],
    "thornton": {"law": "thornton", "ledger": "off"},
    "thornton, energy balance": CONTACTS["thornton"],
    "hertz again": CONTACTS["hertz"],
}
RANKS = (1, 2)


def settled(deck: str) -> Path:
    """Return the data file of the settled grains of a deck; make it if it is missing."""
    folder = WORK / deck
    file = folder / "grains.data"
    if file.exists():
        return file
    print(f"settling the grains of {deck} (some minutes, once) ...", flush=True)
    values = CASES[deck] | CONTACTS["hertz"] | {"rows": 1, "checkpoints": 1, "frames": 1}
    run = run_bulk(deck, values, folder / "settling", ranks=2, force=True)
    last = read_frame_file(find_frames(run.folder)[-1].grains)
    head, mark, rows = (run.folder / "grains.data").read_text().partition("Atoms\n\n")
    grains = {int(words[0]): words[:4] for words in map(str.split, rows.splitlines())}
    moved = [
        " ".join([*grains[number], *map(str, position)])
        for number, position in zip(last["id"].astype(int), last.points.tolist(), strict=True)
    ]
    head = re.sub(r"\d+ atoms", f"{len(moved)} atoms", head)
    part = file.with_suffix(".part")
    part.write_text(head + mark + "\n".join(moved) + "\n")
    part.rename(file)
    return file


def seconds(deck: str, law: str, ranks: int, steps: int) -> tuple[float, int]:
    """Return the elapsed time [s] of `steps` steps of a deck, and the number of grains."""
    folder = WORK / deck / "run"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "grains.data").write_bytes(settled(deck).read_bytes())
    values = CASES[deck] | LAWS[law] | {"rows": 1, "checkpoints": 1, "output": folder}
    values["timestep"] = TIMESTEPS.get(deck, CASES[deck]["timestep"])
    values |= {"duration": steps * values["timestep"], "inputs": PROJECT / "inputs"}
    log = run_deck(f"bulk/{deck}.in", values, folder, ranks, timeout=None)
    line = r"^Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms"
    times = re.findall(line, log, re.MULTILINE)
    if not times:
        raise EngineError(f"{folder}: the log has no line `Loop time`; look there for an error")
    loop, done, grains = times[-1]
    return float(loop) * steps / int(done), int(grains)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument(
        "--case", nargs="+", choices=CASES, default=list(CASES), help="default: all"
    )
    parser.add_argument(
        "--repeats",
        type=positive_integer,
        default=3,
        help="number of rounds (default: %(default)s)",
    )
    parser.add_argument(
        "--steps",
        type=positive_integer,
        default=200,
        help="number of timed steps (default: %(default)s)",
    )
    options = parser.parse_args()
    rows = []
    for deck in options.case:
        settled(deck)
        names = [f"{law}; {ranks}" for ranks in RANKS for law in LAWS]
        for round_, name in turns(names, options.repeats, deck):
            law, _, ranks = name.partition("; ")
            loop, grains = seconds(deck, law, int(ranks), options.steps)
            row = {"deck": deck, "grains": grains, "law": law, "ranks": int(ranks)}
            rows.append({**row, "round": round_, "seconds": loop, "steps": options.steps})
    table = pd.DataFrame(rows)
    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    table.to_csv(RESULTS, index=False, float_format="%.6g")
    table["microseconds"] = 1e6 * table["seconds"] / table["steps"] / table["grains"]
    wide = table.set_index(["deck", "round", "law", "ranks"])["microseconds"].unstack("ranks")
    reference = wide.xs(REFERENCE, level="law")
    ratio = wide.div(reference)
    speedup = wide[1] / wide[2]
    shown = wide.groupby(["deck", "law"], sort=False).median().add_prefix("us, ranks ")
    shown = shown.join(ratio.groupby(["deck", "law"]).median().add_prefix("/ hertz, ranks "))
    shown["one rank / two ranks"] = speedup.groupby(["deck", "law"]).median()
    print(shown.to_string(float_format="%.3g"))
    print(f"wrote {RESULTS}")


if __name__ == "__main__":
    start(main)
