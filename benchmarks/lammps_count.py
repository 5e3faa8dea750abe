# SPDX-License-Identifier: GPL-2.0-or-later
"""Count the instructions of the pair forces in LAMMPS, for laws of LAMMPS and of the plugin.

A small bed follows the paths of pair_time.in beyond yield, under callgrind (Debian's package
valgrind). The count includes all functions that the pair forces call. With energy balance, the
count also includes the loops of the energy balance over particles. The count does not include the
fix of LAMMPS that `mdr` needs. Counts are the same in every run of one binary, also on a busy
machine.

    ./run bench lammps_count
"""

from __future__ import annotations

import re
import shutil
import subprocess

import pandas as pd
from pair_time import HERE, YIELD_STRENGTH, make_bed
from peers import CONTENDERS, PLUGIN
from rounds import start

from plastigran.engine.lammps import LAMMPS
from plastigran.engine.process import PROJECT, EngineError, command

WORK = PROJECT / "build" / "bench" / "lammps_count"
RESULTS = PROJECT / "results" / "bench" / "lammps_count.csv"
GRAINS, STEPS = 2000, 100
REFERENCES = ("LAMMPS hertz/material", "LAMMPS mdr")
COUNTED = (
    "LAMMPS_NS::PairGranular::compute(int, int)",
    "plastigran::EnergyBalance::post_integrate()",
    "plastigran::EnergyBalance::pre_force(int)",
    "plastigran::EnergyBalance::end_of_step()",
)


def instructions(name: str) -> int:
    """Return the number of instructions of the pair forces of a law in all steps.

    Raises:
        EngineError: LAMMPS stopped, or callgrind counted no instructions.
    """
    WORK.mkdir(parents=True, exist_ok=True)
    contender = CONTENDERS[name]
    material = contender.law.format(strength=YIELD_STRENGTH["plastic"], restitution=0.6)
    variables = {"bed": make_bed(GRAINS), "steps": STEPS, "style": contender.style}
    variables["material"] = material
    if contender.properties:
        variables["properties"] = HERE / "peers" / contender.properties
    out = WORK / "callgrind.out"
    for old in WORK.glob("callgrind.out*"):
        old.unlink()
    tool = ["valgrind", "--tool=callgrind", "--trace-children=yes"]
    tool += [
        f"--callgrind-out-file={out}.%p",
        *(f"--toggle-collect={function}" for function in COUNTED),
    ]
    line = command(HERE / "peers" / "compression.lammps", variables, WORK, host=LAMMPS)
    done = subprocess.run(
        [*tool, *line], cwd=WORK, env=LAMMPS.environment(), capture_output=True, text=True
    )
    if done.returncode:
        raise EngineError(f"{name}: {done.stdout[-300:]} {done.stderr[-300:]}")
    texts = [file.read_text(errors="replace") for file in WORK.glob("callgrind.out*")]
    sums = [re.search(r"^(?:summary|totals): (\d+)", text, re.M) for text in texts]
    total = max((int(match[1]) for match in sums if match), default=0)
    if not total:
        raise EngineError(f"{name}: callgrind counted no instructions of the pair forces")
    return total


def main() -> None:
    if not shutil.which("valgrind"):
        raise EngineError("valgrind is missing; install Debian's package valgrind")
    hertz, mdr = (instructions(name) for name in REFERENCES)
    names = (REFERENCES[0] + " again", *PLUGIN)
    rows = [(REFERENCES[1], mdr), *((name, instructions(name)) for name in names)]
    table = pd.DataFrame(rows, columns=["law", "instructions"])
    table["over_hertz"] = table["instructions"] / hertz
    table["over_mdr"] = table["instructions"] / mdr
    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    table.to_csv(RESULTS, index=False, float_format="%.4g")
    print(table.to_string(index=False, float_format="%.4g"))
    print(f"wrote {RESULTS}")


if __name__ == "__main__":
    start(main)
