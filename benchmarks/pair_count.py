#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Count the instructions of the pair forces per contact and step in LIGGGHTS.

A small bed follows the paths of pair_time.in under callgrind (Debian's package valgrind). The count
includes all functions that the pair forces call. With energy balance, the count also includes the
loops of the energy balance over particles. Counts are the same in every run of one binary, also on
a busy machine. The counts do not contain the costs of memory access and of mispredicted branches.

    .venv/bin/python benchmarks/pair_count.py --law thornton universal
    .venv/bin/python benchmarks/pair_count.py --law thornton --tangential history partial_slip
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
from itertools import product
from pathlib import Path

import pandas as pd
from pair_time import (
    BEDS,
    REFERENCE,
    WITH_LEDGER,
    WORK,
    bed_variables,
    known_laws,
    read_contacts,
    run_bed,
    shape_of,
)
from rounds import start
from tqdm import tqdm

from plastigran import laws
from plastigran.engine.process import PROJECT, EngineError, command, engine_path, environment

HERE = Path(__file__).resolve().parent
RESULTS = PROJECT / "results" / "bench" / "pair_count.csv"
GRAINS = 2000
STEPS = 100  # steps of each phase
COUNTED = (
    "LAMMPS_NS::PairGran::compute(int, int)",
    "plastigran::EnergyLedger::post_integrate()",
    "plastigran::EnergyLedger::pre_force(int)",
    "plastigran::EnergyLedger::pre_final_integrate()",
)


def contact_steps(bed: Path, shape: str) -> int:
    """Return the number of contacts with force, summed over the steps; equal for all laws."""
    run_bed(REFERENCE, "plastic", bed, STEPS, count_every=1, shape=shape)
    contacts = read_contacts()
    # The setup of the second run computes the contacts of step STEPS again, so count them twice.
    return len(contacts) + len(contacts.query("step == @STEPS"))


def instructions(contender: str, bed: Path, shape: str, tangential: str = "history") -> int:
    """Return the number of instructions of the pair forces in all steps.

    Raises:
        EngineError: LIGGGHTS stopped, or callgrind counted no instructions.
    """
    folder = WORK / "count"
    folder.mkdir(parents=True, exist_ok=True)
    out = folder / "callgrind.out"
    variables = bed_variables(contender, "plastic", bed, STEPS, shape) | {"tangential": tangential}
    tool = ["valgrind", "--tool=callgrind", "--trace-children=yes"]
    tool += [f"--callgrind-out-file={out}", *(f"--toggle-collect={name}" for name in COUNTED)]
    done = subprocess.run(
        [*tool, *command(HERE / "pair_time.in", variables, folder)],
        cwd=folder,
        env=environment(),
        capture_output=True,
        text=True,
    )
    if done.returncode:
        raise EngineError(f"{contender}: {done.stdout[-300:]} {done.stderr[-300:]}")
    total = re.search(r"^(?:summary|totals): (\d+)", out.read_text(errors="replace"), re.M)
    if not total or int(total[1]) == 0:
        raise EngineError(f"{contender}: callgrind counted no instructions of the pair forces")
    return int(total[1])


def count(names: list[str], tangentials: list[str], shape: str) -> pd.DataFrame:
    """Return instructions per contact and step, and ratios, for each law of one shape.

    Args:
        names: Names of the laws.
        tangentials: Names of the tangential models.
        shape: Shape of the bodies.
    """
    bed = BEDS[shape].make(GRAINS)
    steps = contact_steps(bed, shape)
    reference = instructions(REFERENCE, bed, shape) / steps
    rows = [(shape, REFERENCE, "history", reference, 1.0, None, None)]
    for name, tangential in tqdm(list(product(names, tangentials)), unit="law"):
        alone = instructions(name, bed, shape, tangential) / steps
        ledger = instructions(name + WITH_LEDGER, bed, shape, tangential) / steps
        rows.append((shape, name, tangential, alone, alone / reference, ledger, ledger / alone))
    columns = ["shape", "law", "tangential", "pair_forces", "over_hertz"]
    columns += ["with_ledger", "over_without"]
    return pd.DataFrame(rows, columns=columns)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    names = known_laws()
    parser.add_argument(
        "--law", nargs="+", choices=names, default=names, help="names of laws; default: all"
    )
    models = ["history", *laws.TANGENTIAL_LAWS]
    parser.add_argument(
        "--tangential", nargs="+", choices=models, default=models[:1], help="default: history"
    )
    options = parser.parse_args()
    engine_path()  # raises EngineError if LIGGGHTS is missing
    if not shutil.which("valgrind"):
        raise EngineError("valgrind is missing; install Debian's package valgrind")
    tables = []
    for shape in BEDS:
        named = [law for law in options.law if shape_of(law) == shape]
        if named:
            tables.append(count(named, options.tangential, shape))
    table = pd.concat(tables, ignore_index=True)
    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    table.to_csv(RESULTS, index=False, float_format="%.4g")
    print(table.to_string(index=False, float_format="%.4g", na_rep=""))
    print(f"wrote {RESULTS}")


if __name__ == "__main__":
    start(main)
