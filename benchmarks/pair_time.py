#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What a law costs: time of the pair forces over that of LIGGGHTS' own `hertz`.

One bed of spheres, 20 000 unless told, is made once (bed.in, kept in build/bench) and compressed
and half released along given paths (pair_time.in), so that every law sees the same contacts at
every step. It is done with a yield strength at which nearly all contacts are plastic and with one
at which none is. All laws run once per round, in an order that turns from round to round; a law's
ratio is taken within each round, so that slow changes of the machine's speed cancel. `hertz` runs
twice per round: the ratio of the two is the noise.

The reference is stock `hertz` with restitution 0.6, with `tangential history` as everywhere here;
it computes a viscous damping that the laws do not have.

    .venv/bin/python benchmarks/pair_time.py --repeats 5 --law thornton
    .venv/bin/python benchmarks/pair_time.py --copies 3 --law universal
    .venv/bin/python benchmarks/pair_time.py --law thornton --ledger

With `--ledger` every law runs with the energy ledger, too. With `--copies 3` the bed is 3 by 3 by 3
of them, 540 000 spheres.

Cylinders have a bed of their own, of discs in two dimensions (bed_of_discs.in); `hertz`, which is
for spheres, is the reference there as well.

Times depend on the machine, ratios far less; only ratios are reported.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path

import pandas as pd
from attrs import frozen
from pair_time_figure import BOTH, cost_figure
from size_beds import widen
from tqdm import tqdm

from plastigran import laws
from plastigran.cli.arguments import positive_integer
from plastigran.engine.contacts import read_contacts
from plastigran.engine.process import PROJECT, EngineError, engine_path, run_deck
from plastigran.plot.style import save

HERE = Path(__file__).resolve().parent
WORK = PROJECT / "build" / "bench"
RESULTS = PROJECT / "results" / "bench" / "pair_time.csv"

REFERENCE, CONTROL = "hertz", "hertz again"
WITH_LEDGER = ", ledger"  # after the name of a law
YIELD_STRENGTH = {"plastic": 3.0e8, "elastic": 1.0e13}  # Pa
PHASES = ("compression", "release")


@frozen
class Bed:
    """Bodies of one shape.

    Attributes:
        deck: That makes it.
        dimension: Of it.
        variables: What pair_time.in has to know of it.
    """

    deck: Path
    dimension: int
    variables: dict[str, object]

    def make(self, grains: int) -> Path:
        """The data file, made when missing or older than its deck, of about so many bodies."""
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
    """Names of the laws in LIGGGHTS."""
    lines = (PROJECT / "contact_models/liggghts/plugin/laws.txt").read_text().splitlines()
    return sorted(line.split()[0] for line in lines if not line.startswith("#"))


def make_bed(grains: int) -> Path:
    """The bed of spheres."""
    return BEDS["sphere"].make(grains)


def bed_variables(
    contender: str, state: str, bed: Path, steps: int, shape: str = "sphere"
) -> dict[str, object]:
    """What pair_time.in is told of a law, or of a law with the ledger."""
    law = REFERENCE if contender == CONTROL else contender.removesuffix(WITH_LEDGER)
    return {
        "law": law,
        "options": "energy_ledger on" if contender.endswith(WITH_LEDGER) else "",
        "yield_strength": YIELD_STRENGTH[state],
        "steps": steps,
        "bed": bed,
        **BEDS[shape].variables,
    }


def run_bed(
    contender: str,
    state: str,
    bed: Path,
    steps: int,
    count_every: int | None = None,
    shape: str = "sphere",
) -> str:
    """Run a law, or a law with energy balance, along the path of the bed; return the log.

    The contacts of every `count_every` steps go to contacts.dump.
    """
    variables = bed_variables(contender, state, bed, steps, shape)
    if count_every:
        variables |= {"count": 1, "every": count_every}
    return run_deck(HERE / "pair_time.in", variables, WORK / "run")


def pair_times(log: str) -> list[float]:
    """Time in the pair forces of each phase [s], from the engine's own timers."""
    times = [float(time) for time in re.findall(r"^Pair  time \(%\) = (\S+)", log, re.MULTILINE)]
    if len(times) != len(PHASES):
        raise EngineError(f"the log has {len(times)} pair times instead of {len(PHASES)}")
    return times


def count_contacts(
    law: str, state: str, bed: Path, steps: int, shape: str = "sphere"
) -> dict[str, object]:
    """Contacts carrying force at full compression, and the share of them that has yielded.

    A law's state is zero until first yield and comes first in the contact history.
    """
    run_bed(law, state, bed, steps, count_every=steps, shape=shape)
    contacts = read_contacts(WORK / "run" / "contacts.dump").query("step == @steps")
    share = 0.0 if law == REFERENCE else (contacts["history_1"] > 0).mean()
    return {"state": state, "law": law, "contacts": len(contacts), "plastic_share": share}


def measure(
    names: list[str], bed: Path, steps: int, repeats: int, shape: str = "sphere"
) -> pd.DataFrame:
    """Pair times of laws in all rounds.

    Args:
        names: Of the laws.
        bed: Data file of the bodies.
        steps: Time steps of each phase.
        repeats: Rounds; a round is one run of every law and two of the reference, in both states.
        shape: Of the bodies.

    Returns:
        One row per run and phase: round, state, law, phase, time [s].
    """
    contenders = [REFERENCE, *names, CONTROL]
    rows = []
    runs = tqdm(total=repeats * len(YIELD_STRENGTH) * len(contenders), unit="run")
    for round_ in range(repeats):
        for state in YIELD_STRENGTH:
            turn = round_ % len(contenders)
            for law in contenders[turn:] + contenders[:turn]:
                log = run_bed(law, state, bed, steps, shape=shape)
                for phase, time in zip(PHASES, pair_times(log), strict=True):
                    rows.append((round_, state, law, phase, time))
                runs.update()
    runs.close()
    return pd.DataFrame(rows, columns=["round", "state", "law", "phase", "time"])


def compare(named: list[str], shape: str, bed: Path, options: argparse.Namespace) -> pd.DataFrame:
    """Pair times of laws for bodies of one shape over the reference's, with what they were of."""
    names = named + [law + WITH_LEDGER for law in named if options.ledger]
    counts = pd.DataFrame(
        count_contacts(law, state, bed, options.steps, shape)
        for state in YIELD_STRENGTH
        for law in [REFERENCE, *names]
    )
    again = counts[counts["law"] == REFERENCE].assign(law=CONTROL)
    table = summarize(measure(names, bed, options.steps, options.repeats, shape))
    table = table.merge(pd.concat([counts, again]), on=["state", "law"])
    grains = options.grains * options.copies**3
    return table.assign(shape=shape, repeats=options.repeats, steps=options.steps, grains=grains)


def summarize(times: pd.DataFrame) -> pd.DataFrame:
    """Ratio to the reference of the same round: median and quartiles, by state, law and phase."""
    both = times.groupby(["round", "state", "law"], as_index=False)["time"].sum()
    times = pd.concat([times, both.assign(phase=BOTH)])
    wide = times.pivot(index=["state", "phase", "round"], columns="law", values="time")
    ratio = wide.div(wide[REFERENCE], axis=0).drop(columns=REFERENCE).stack().rename("ratio")
    quartiles = ratio.groupby(["state", "law", "phase"]).quantile([0.25, 0.5, 0.75]).unstack()
    quartiles.columns = ["ratio_q25", "ratio", "ratio_q75"]
    return quartiles.reset_index()


def report(table: pd.DataFrame) -> str:
    """The table to print: one row per state and law, one column per phase."""
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
    parser.add_argument("--ledger", action="store_true", help="laws with the energy ledger, too")
    parser.add_argument("--grains", type=int, default=20_000, help="default: %(default)s")
    parser.add_argument(
        "--copies", type=positive_integer, default=1, help="of the bed along each side, of spheres"
    )
    parser.add_argument(
        "--repeats", type=positive_integer, default=10, help="rounds (default: %(default)s)"
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
    flat = [law for law in options.law if laws.LAWS[law].shape == "cylinder"]
    if options.copies > 1 and flat:
        parser.error(f"--copies is {options.copies}; name laws for spheres, and not {flat[0]}")
    engine_path()  # says what to do when there is none

    tables = []
    for shape, bed in BEDS.items():
        named = [law for law in options.law if laws.LAWS[law].shape == shape]
        if not named:
            continue
        made = bed.make(options.grains)
        if options.copies > 1:
            made = widen(made, options.copies, options.copies, along_z=options.copies)
        tables.append(compare(named, shape, made, options))
    table = pd.concat(tables, ignore_index=True)

    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    table.to_csv(RESULTS, index=False, float_format="%.4f")
    print(
        f"\npair time over that of stock {REFERENCE} (restitution 0.6), tangential history for all"
        f": median (quartiles) of {options.repeats} rounds\n"
    )
    for shape, part in table.groupby("shape", sort=False):
        print(f"a bed of {shape}s\n\n{report(part)}\n")
    control = table.loc[table["law"] == CONTROL, ["ratio_q25", "ratio_q75"]]
    noise = (control - 1).abs().max(axis=None)
    print(f"\n'{CONTROL}' over {REFERENCE} should be 1; its quartiles are off by up to {noise:.0%}")
    figure = RESULTS.with_suffix(".svg")
    save(cost_figure(table, CONTROL), figure.with_suffix(""), (".svg",))
    print(f"wrote {RESULTS}, {figure}")


if __name__ == "__main__":
    try:
        main()
    except EngineError as error:
        raise SystemExit(f"ERROR: {error}") from None
