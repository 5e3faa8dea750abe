#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the cost of laws of this project with laws of LIGGGHTS and LAMMPS on one bed.

    ./run bench peers
    ./run bench peers --part restitution     # accuracy of the laws: peers_restitution.py

The laws of this project run in both hosts. pair_time.py describes the bed and the paths. LAMMPS has
a deck with the same grains, paths and steps. A first check compares the forces of every grain at
full compression between the hosts: `hertz` in LIGGGHTS and `hertz/material` in LAMMPS. The contacts
of this check are elastic and have no damping.

All laws run once per round, stock `hertz` runs twice, and every round begins with another law.
Ratios are computed from the times of the same round. The time of a loop is the processor time of
its process, including the setup of the run. Another load on the machine lengthens this time far
less than the elapsed time. The time of the pair forces is the processor time of the loop,
multiplied by the share of the pair forces in the table of times that the host prints.
"""

from __future__ import annotations

import argparse
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from pair_time import HERE, YIELD_STRENGTH, make_bed
from peers_restitution import draw, restitution
from rounds import start, turns

from plastigran.cli.arguments import positive_integer
from plastigran.engine.dumps import read_dump
from plastigran.engine.lammps import run_lammps
from plastigran.engine.process import PROJECT, EngineError, engine_path, run_deck

WORK = PROJECT / "build" / "bench" / "peers"
RESULTS = PROJECT / "results" / "bench"
REFERENCE, CONTROL = "hertz", "hertz again"
OURS = ("thornton", "vu_quoc_zhang", "kogut_etsion", "universal")
PLUGIN = tuple(
    f"LAMMPS {law}{ledger}" for law in ("thornton", "universal") for ledger in ("", " with energy")
)
#: Targets: compared time, laws of this project, law of LAMMPS, and largest ratio of their times.
#: The compared time is that of the whole loop (`loop`) or of the pair forces (`pair`).
TARGETS = (
    ("loop", OURS, "LAMMPS mdr", 0.25),
    ("loop", OURS, "LAMMPS hertz/material", 0.75),
    ("pair", PLUGIN, "LAMMPS mdr", 0.5),
    ("pair", PLUGIN, "LAMMPS hertz/material", 1.25),
)


@dataclass(frozen=True)
class Contender:
    """One of the laws whose costs are compared, in LIGGGHTS or LAMMPS.

    Attributes:
        law: Name of the law in the host; in LAMMPS, the name is followed by the constants.
        properties: Name of a deck in the folder `peers` with further properties.
        style: Pair style of LAMMPS; empty if the host is LIGGGHTS.
    """

    law: str
    properties: str = ""
    style: str = ""

    def run(self, bed: Path, strength: float, steps: int, restitution: float, folder: Path) -> str:
        """Move the spheres of the bed along their paths with this law, and return the log."""
        variables: dict[str, object] = {"bed": bed, "steps": steps}
        if self.properties:
            variables["properties"] = HERE / "peers" / self.properties
        if self.style:
            material = self.law.format(strength=strength, restitution=restitution)
            deck = HERE / "peers" / "compression.lammps"
            return run_lammps(deck, variables | {"material": material, "style": self.style}, folder)
        variables |= {"law": self.law, "yield_strength": strength, "restitution": restitution}
        return run_deck(HERE / "pair_time.in", variables, folder)


#: Tangential model of LAMMPS. The ratio of tangential to normal damping is the same as in LIGGGHTS,
#: sqrt(2 (1 - nu)/(2 - nu)) with Poisson's ratio nu = 0.3.
FRICTION = "tangential mindlin NULL 0.90748521297303009 0.3"
HERTZ = Contender(
    f"hertz/material 7e10 {{restitution}} 0.3 {FRICTION} damping coeff_restitution",
    style="granular",
)
CONTENDERS = {
    REFERENCE: Contender("hertz"),
    "hooke/hysteresis": Contender("hooke/hysteresis", "hysteresis.in"),
    "thornton_ning": Contender("thornton_ning", "thornton_ning.in"),
    **{law: Contender(law) for law in OURS},
    "LAMMPS hertz/material": HERTZ,
    "LAMMPS mdr": Contender(
        f"mdr 7e10 0.3 {{strength}} 0 0.5 0 {FRICTION} damping mdr 1", style="granular"
    ),
    **{
        law: Contender(
            f"{law.split()[1]} 7e10 0.3 yield_strength {{strength}} {FRICTION}",
            "energy.lammps" if law.endswith("with energy") else "",
            style="granular/plastigran",
        )
        for law in PLUGIN
    },
    "LAMMPS hertz/material again": HERTZ,
    CONTROL: Contender("hertz"),
}


def same_physics(bed: Path, steps: int) -> float:
    """Return the largest force difference between `hertz` and LAMMPS' `hertz/material`.

    The contacts are elastic and undamped, at full compression. The difference is divided by the
    root mean square of all forces.
    """
    forces = []
    for contender in (
        Contender("hertz", "forces.in"),
        Contender(HERTZ.law, "forces.lammps", style="granular"),
    ):
        folder = WORK / "same"
        contender.run(bed, YIELD_STRENGTH["elastic"], steps, 1.0, folder)
        table = read_dump(folder / "forces.dump").query("step == @steps").sort_values("id")
        forces.append(table[["fx", "fy", "fz"]].to_numpy())
    one, other = forces
    if one.shape != other.shape:
        raise EngineError(
            f"LIGGGHTS wrote the forces of {len(one)} grains, LAMMPS of {len(other)}; both must "
            f"write all grains of {bed}"
        )
    return float(np.abs(one - other).max() / np.sqrt((one**2).sum(axis=1).mean()))


def times(log: str, folder: Path) -> list[float]:
    """Return three times [s], each summed over both phases.

    The times are the processor time of the loop, the processor time of the pair forces, and the
    elapsed time of the loop.
    """
    stamps = [int(line.split()[0]) for line in (folder / "processor").read_text().splitlines()]
    loop = np.diff(stamps) / 1e9
    clock = np.array(re.findall(r"^Loop time of (\S+)", log, re.MULTILINE), float)
    pair = re.findall(r"^Pair  (?:time \(%\) = (\S+)|  \|[^|]*\| (\S+))", log, re.MULTILINE)
    share = np.array(["".join(times) for times in pair], float) / clock
    return [loop.sum(), (loop * share).sum(), clock.sum()]


def measure(bed: Path, names: list[str], steps: int, repeats: int) -> pd.DataFrame:
    """Return the times of all rounds: columns round, law, loop, pair, clock [s]."""
    rows, folder = [], WORK / "run"
    for round_, name in turns(names, repeats):
        log = CONTENDERS[name].run(bed, YIELD_STRENGTH["plastic"], steps, 0.6, folder)
        rows.append((round_, name, *times(log, folder)))
    return pd.DataFrame(rows, columns=["round", "law", "loop", "pair", "clock"])


def ratios(table: pd.DataFrame, to: str = REFERENCE) -> pd.DataFrame:
    """Return median and quartiles, by law, of time / time of the law `to` in the same round."""
    wide = table.set_index(["round", "law"]).unstack("law")
    columns = []
    for quantity in ("loop", "pair", "clock"):
        ratio = wide[quantity].div(wide[quantity][to], axis=0).stack().groupby("law")
        quartiles = ratio.quantile([0.25, 0.5, 0.75]).unstack()
        quartiles.columns = [f"{quantity}_{name}" for name in ("q25", "median", "q75")]
        columns.append(quartiles)
    return pd.concat(columns, axis=1)


def markdown(table: pd.DataFrame) -> str:
    """Return the ratios as the table of the page in the documentation."""
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
    """Check the forces, measure times, print ratios, and write all rounds to `peers.csv`."""
    bed = make_bed(options.grains)
    names = [*options.law, CONTROL]
    if any(CONTENDERS[name].style for name in names):
        difference = same_physics(bed, options.steps)
        print(f"forces of hertz in both hosts, elastic and undamped: within {difference:.1e} rms")
    rounds = measure(bed, names, options.steps, options.repeats)
    RESULTS.mkdir(parents=True, exist_ok=True)
    rounds.to_csv(RESULTS / "peers.csv", index=False, float_format="%.5g")
    print(f"\ntime / time of stock hertz, median (quartiles) of {options.repeats} rounds\n")
    print(markdown(ratios(rounds)), "\n")
    for quantity, laws, reference, target in TARGETS:
        if reference not in names:
            continue
        ratio = ratios(rounds, reference)[f"{quantity}_median"]
        for law in (law for law in laws if law in names):
            verdict = "met" if ratio[law] <= target else f"missed by {ratio[law] / target - 1:.0%}"
            print(f"{quantity}, {law} / {reference}: {ratio[law]:.3f}, target {target}: {verdict}")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    laws = [name for name in CONTENDERS if name != CONTROL]
    parser.add_argument("--part", choices=["cost", "restitution"], help="default: both")
    parser.add_argument("--law", nargs="+", choices=laws, default=laws, help="default: all")
    parser.add_argument("--grains", type=int, default=20_000, help="default: %(default)s")
    parser.add_argument(
        "--repeats",
        type=positive_integer,
        default=5,
        help="number of rounds (default: %(default)s)",
    )
    parser.add_argument(
        "--steps",
        type=positive_integer,
        default=200,
        help="time steps of a phase (default: %(default)s)",
    )
    options = parser.parse_args()
    options.law = [REFERENCE, *(law for law in options.law if law != REFERENCE)]
    engine_path()  # raises EngineError if LIGGGHTS is missing
    if options.part != "restitution":
        compare_costs(options)
    if options.part != "cost":
        table = restitution(WORK / "restitution")
        RESULTS.mkdir(parents=True, exist_ok=True)
        table.to_csv(RESULTS / "peers_restitution.csv", index=False, float_format="%.6g")
        draw(table)


if __name__ == "__main__":
    start(main)
