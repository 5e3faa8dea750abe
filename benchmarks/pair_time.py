#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the cost of a law: time of the pair forces / time of the pair forces of stock `hertz`.

A bed of spheres (bed.in, kept in build/bench) is compressed and half released along prescribed
paths (pair_time.in). Every law therefore has the same contacts at every step. There are two cases.
In the plastic bed, a low yield strength makes nearly all contacts plastic. In the elastic bed, a
high yield strength keeps all contacts elastic. All laws run once per round, and every round begins
with another law. Ratios are computed from the times of the same round, so that slow changes of the
machine's speed cancel. `hertz` runs twice per round, and the ratio of these two times shows the
noise.

The reference is stock `hertz` with restitution 0.6. The reference computes viscous damping, which
the laws of this project do not have. All runs have `tangential history`, except with the option
`--tangential`. With this option, the reference is the law itself with `tangential history`.

    .venv/bin/python benchmarks/pair_time.py --repeats 5 --law thornton
    .venv/bin/python benchmarks/pair_time.py --copies 3 --law universal
    .venv/bin/python benchmarks/pair_time.py --law thornton --ledger
    .venv/bin/python benchmarks/pair_time.py --law thornton --tangential incremental partial_slip

With `--ledger`, every law also runs with energy balance. With `--copies 3`, the bed consists of
3 by 3 by 3 copies, 540 000 spheres.

Laws for cylinders run on a bed of discs in two dimensions (bed_of_discs.in). The reference is
`hertz` there too, although it is a law for spheres. Only ratios are reported, because times depend
on the machine.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path

import pandas as pd
from attrs import frozen
from pair_time_figure import BOTH, cost_figure
from rounds import start, turns
from size_beds import widen

from plastigran import laws
from plastigran.cli.arguments import positive_integer
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import PROJECT, EngineError, engine_path, run_deck
from plastigran.plot.style import save

HERE = Path(__file__).resolve().parent
WORK = PROJECT / "build" / "bench"
RESULTS = PROJECT / "results" / "bench" / "pair_time.csv"

REFERENCE = "hertz"
AGAIN = " again"  # suffix of the name of the second run of the reference
WITH_LEDGER = ", ledger"  # suffix of the name of a law with energy balance
WITH_ADHESION = " adhesion jkr"  # suffix of the name of a law with adhesion
SURFACE_ENERGY = 0.1  # work of adhesion of laws with adhesion [J/m2]
FITTED = ("walton_braun", "luding_2008", "edinburgh_2014")  # laws with fitted stiffnesses
YIELD_STRENGTH = {"plastic": 3.0e8, "elastic": 1.0e13}  # Pa
PHASES = ("compression", "release")


@frozen
class Bed:
    """Bed of bodies of one shape.

    Attributes:
        deck: Deck that makes the bed.
        dimension: Number of dimensions.
        variables: Further variables of pair_time.in.
    """

    deck: Path
    dimension: int
    variables: dict[str, object]

    def make(self, grains: int) -> Path:
        """Return the data file of about `grains` bodies; make it if it is missing or old."""
        folder = WORK / (f"{grains}" if self.dimension == 3 else f"{grains}_discs")
        data = folder / "bed.data"
        if not data.exists() or data.stat().st_mtime < self.deck.stat().st_mtime:
            print("making the bed (half a minute for 20 000, once) ...", flush=True)
            across = max(4, round((grains / 1.28) ** (1 / self.dimension)))
            high = max(4, round(grains / across ** (self.dimension - 1)))
            run_deck(self.deck, {"across": across, "high": high}, folder)
        return data


BEDS = {
    "sphere": Bed(HERE / "bed.in", 3, {}),
    "cylinder": Bed(
        HERE / "bed_of_discs.in",
        2,
        {
            "dimension": 2,
            "axis": "y",
            "boundary": "p f p",
            "properties": HERE / "cylinder_properties.in",
        },
    ),
}


def known_laws() -> list[str]:
    """Return the names of the laws in LIGGGHTS, including the variants with adhesion."""
    lines = (PROJECT / "contact_models/liggghts/plugin/laws.txt").read_text().splitlines()
    names = {line.split()[0] for line in lines if not line.startswith("#")}
    return sorted(names | {name + WITH_ADHESION for name in laws.ADHESIVE_LAWS})


def shape_of(contender: str) -> str:
    """Return the shape of the bodies of a law."""
    return laws.LAWS[contender.removesuffix(WITH_ADHESION)].shape


def make_bed(grains: int) -> Path:
    """Return the data file of the bed of spheres; make it if it is missing or old."""
    return BEDS["sphere"].make(grains)


def bed_variables(
    contender: str, state: str, bed: Path, steps: int, shape: str = "sphere"
) -> dict[str, object]:
    """Return the variables of pair_time.in for a law.

    Args:
        contender: Name of the law, and a suffix for energy balance or a tangential model.
        state: `plastic` or `elastic`, which selects the yield strength.
        bed: Data file of the bodies.
        steps: Time steps of each phase.
        shape: Shape of the bodies.
    """
    law, _, suffix = contender.removesuffix(AGAIN).partition(", ")
    options = "energy_ledger on" if contender.endswith(WITH_LEDGER) else ""
    adhesive = law.endswith(WITH_ADHESION) or (law in laws.LAWS and laws.LAWS[law].adhesive)
    if law.endswith(WITH_ADHESION):
        options += WITH_ADHESION
    fitted = {"properties": HERE / "fitted_stiffnesses.in"} if law in FITTED else {}
    return {
        "law": law.removesuffix(WITH_ADHESION),
        "options": options,
        "tangential": suffix if suffix in laws.TANGENTIAL_LAWS else "history",
        "surface_energy": SURFACE_ENERGY if adhesive else 0,
        "yield_strength": YIELD_STRENGTH[state],
        "steps": steps,
        "bed": bed,
        **BEDS[shape].variables,
        **fitted,
    }


def run_bed(
    contender: str,
    state: str,
    bed: Path,
    steps: int,
    count_every: int | None = None,
    shape: str = "sphere",
) -> str:
    """Run a law, named as for `bed_variables`, along the path of the bed; return the log.

    If `count_every` is given, the run writes the contacts to contacts.dump every so many steps.
    """
    variables = bed_variables(contender, state, bed, steps, shape)
    if count_every:
        variables |= {"count": 1, "every": count_every}
    return run_deck(HERE / "pair_time.in", variables, WORK / "run")


def pair_times(log: str) -> list[float]:
    """Return the time of the pair forces in each phase [s], from the timers of LIGGGHTS."""
    times = [float(time) for time in re.findall(r"^Pair  time \(%\) = (\S+)", log, re.MULTILINE)]
    if len(times) != len(PHASES):
        raise EngineError(f"the log has {len(times)} pair times instead of {len(PHASES)}")
    return times


def read_contacts() -> pd.DataFrame:
    """Return step, normal force and first value of the history of each contact with force.

    The dump also contains neighbors without contact.
    """
    table = read_dump(WORK / "run" / "contacts.dump")
    table.columns = ["step", "fnx", "fny", "fnz", "history"]
    return table[(table[["fnx", "fny", "fnz"]] != 0).any(axis=1)]


def count_contacts(
    law: str, state: str, bed: Path, steps: int, shape: str = "sphere"
) -> dict[str, object]:
    """Count the contacts that carry force at full compression, and the share that has yielded.

    The state of the law comes first in the contact history, and is zero until first yield.
    """
    run_bed(law, state, bed, steps, count_every=steps, shape=shape)
    contacts = read_contacts().query("step == @steps")
    share = 0.0 if law == REFERENCE else (contacts["history"] > 0).mean()
    return {"state": state, "law": law, "contacts": len(contacts), "plastic_share": share}


def measure(
    names: list[str], bed: Path, steps: int, repeats: int, shape: str = "sphere"
) -> pd.DataFrame:
    """Return the pair times of laws in all rounds.

    Args:
        names: Names of the laws, in the order reference, other laws, second run of the reference.
        bed: Data file of the bodies.
        steps: Time steps of each phase.
        repeats: Number of rounds. A round is one run of every name, in both states.
        shape: Shape of the bodies.

    Returns:
        One row per run and phase: round, state, law, phase, time [s].
    """
    rows = []
    for round_, law in turns(names, repeats):
        for state in YIELD_STRENGTH:
            log = run_bed(law, state, bed, steps, shape=shape)
            for phase, time in zip(PHASES, pair_times(log), strict=True):
                rows.append((round_, state, law, phase, time))
    return pd.DataFrame(rows, columns=["round", "state", "law", "phase", "time"])


def compare(
    reference: str, names: list[str], shape: str, bed: Path, options: argparse.Namespace
) -> pd.DataFrame:
    """Return pair times of laws / pair time of the reference for one shape, and contact counts."""
    names = [reference, *names]
    counts = pd.DataFrame(
        count_contacts(law, state, bed, options.steps, shape)
        for state in YIELD_STRENGTH
        for law in names
    )
    control = reference + AGAIN
    again = counts[counts["law"] == reference].assign(law=control)
    times = measure([*names, control], bed, options.steps, options.repeats, shape)
    table = summarize(times, reference).merge(pd.concat([counts, again]), on=["state", "law"])
    grains = options.grains * options.copies**3
    return table.assign(
        reference=reference,
        shape=shape,
        repeats=options.repeats,
        steps=options.steps,
        grains=grains,
    )


def summarize(times: pd.DataFrame, reference: str) -> pd.DataFrame:
    """Return median and quartiles of time / time of the reference in the same round."""
    both = times.groupby(["round", "state", "law"], as_index=False)["time"].sum()
    times = pd.concat([times, both.assign(phase=BOTH)])
    wide = times.pivot(index=["state", "phase", "round"], columns="law", values="time")
    ratio = wide.div(wide[reference], axis=0).drop(columns=reference).stack().rename("ratio")
    quartiles = ratio.groupby(["state", "law", "phase"]).quantile([0.25, 0.5, 0.75]).unstack()
    quartiles.columns = ["ratio_q25", "ratio", "ratio_q75"]
    return quartiles.reset_index()


def report(table: pd.DataFrame) -> str:
    """Return the table as text: one row per bed and law, one column per phase."""
    text = table.assign(
        cell=[
            f"{row.ratio:.2f} ({row.ratio_q25:.2f}-{row.ratio_q75:.2f})"
            for row in table.itertuples()
        ]
    )
    wide = text.pivot(
        index=["state", "law", "contacts", "plastic_share"], columns="phase", values="cell"
    )[[BOTH, *PHASES]].reset_index()
    wide["plastic_share"] = wide["plastic_share"].map("{:.1%}".format)
    order = {state: k for k, state in enumerate(YIELD_STRENGTH)}
    wide = wide.sort_values("state", key=lambda column: column.map(order), kind="stable")
    return wide.rename_axis(columns=None).to_string(index=False)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    names = known_laws()
    parser.add_argument("--law", nargs="+", choices=names, default=names, help="default: all")
    also = parser.add_mutually_exclusive_group()
    also.add_argument(
        "--ledger", action="store_true", help="run every law also with energy balance"
    )
    also.add_argument(
        "--tangential",
        nargs="+",
        choices=list(laws.TANGENTIAL_LAWS),
        default=[],
        help="compare these tangential models with `history`, separately for every law",
    )
    parser.add_argument("--grains", type=int, default=20_000, help="default: %(default)s")
    parser.add_argument(
        "--copies",
        type=positive_integer,
        default=1,
        help="copies of the bed of spheres along each side",
    )
    parser.add_argument(
        "--repeats",
        type=positive_integer,
        default=10,
        help="number of rounds (default: %(default)s)",
    )
    parser.add_argument(
        "--steps",
        type=positive_integer,
        default=200,
        help="time steps of each phase (default: %(default)s)",
    )
    options = parser.parse_args()
    if options.grains < 1000:
        parser.error(f"--grains is {options.grains}; it must be at least 1000")
    flat = [law for law in options.law if shape_of(law) == "cylinder"]
    if options.copies > 1 and flat:
        parser.error(
            f"--copies is {options.copies}, which is possible only for laws for spheres, "
            f"not for {flat[0]}"
        )
    engine_path()  # raises EngineError if LIGGGHTS is missing

    tables = []
    for shape, bed in BEDS.items():
        named = [law for law in options.law if shape_of(law) == shape]
        if not named:
            continue
        made = bed.make(options.grains)
        if options.copies > 1:
            made = widen(made, options.copies, options.copies, along_z=options.copies)
        groups = {REFERENCE: named + [law + WITH_LEDGER for law in named if options.ledger]}
        if options.tangential:
            groups = {law: [f"{law}, {model}" for model in options.tangential] for law in named}
        tables += [compare(*group, shape, made, options) for group in groups.items()]
    table = pd.concat(tables, ignore_index=True)

    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    table.to_csv(RESULTS, index=False, float_format="%.4f")
    print(
        "\npair time / pair time of the reference with tangential history: "
        f"median (quartiles) of {options.repeats} rounds\n"
    )
    for (shape, reference), part in table.groupby(["shape", "reference"], sort=False):
        print(f"a bed of {shape}s; reference: {reference}\n\n{report(part)}\n")
    control = table.loc[table["law"] == table["reference"] + AGAIN, ["ratio_q25", "ratio_q75"]]
    noise = (control - 1).abs().max(axis=None)
    print(f"ratios named '...{AGAIN}' should be 1; their quartiles differ by up to {noise:.0%}")
    print(f"wrote {RESULTS}")
    if not options.tangential:
        figure = RESULTS.with_suffix(".svg")
        save(cost_figure(table, REFERENCE + AGAIN), figure.with_suffix(""), (".svg",))
        print(f"wrote {figure}")


if __name__ == "__main__":
    start(main)
