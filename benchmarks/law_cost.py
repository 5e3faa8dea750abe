#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the cost of each law without a host: time, instructions and cache misses of a contact.

All results are for one contact and one step. law_cost.cpp describes the measurement. callgrind
(Debian's package valgrind) counts instructions and cache misses, which are the same in every run of
one binary. Times are the shortest of many repetitions. Times depend on the machine and its load.

    .venv/bin/python benchmarks/law_cost.py --law stronge universal
"""

from __future__ import annotations

import argparse
import io
import re
import shutil
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

import pandas as pd

from plastigran.engine.process import PROJECT

PROGRAM = PROJECT / "build" / "benchmarks" / "law_cost"
RESULTS = PROJECT / "results" / "bench" / "law_cost.csv"
CONTACT_STEPS = 4096 * 8  # number of contacts times steps of a path, as in law_cost.cpp
KEYS = ["law", "phase", "answer"]


def build() -> None:
    """Compile the program if it is older than its sources."""
    subprocess.run(["cmake", "--build", "--preset", "release", "--target", "law_cost"], check=True)


def times(laws: list[str], repeats: int) -> pd.DataFrame:
    """Return the time of each law, phase and set of results, column `ns` [ns].

    The row of the phase `setup` contains the time to construct the law and, in the column `sum`,
    the size of the law in memory [bytes].
    """
    line = [str(PROGRAM), "--repeats", str(repeats), *laws]
    done = subprocess.run(line, check=True, capture_output=True, text=True)
    return pd.read_csv(io.StringIO(done.stdout))


def counts(laws: list[str]) -> pd.DataFrame:
    """Return the instructions and level-1 data cache misses per contact and step."""
    rows = []
    with TemporaryDirectory() as folder:
        out = Path(folder) / "callgrind"
        line = ["valgrind", "--tool=callgrind", "--cache-sim=yes", f"--callgrind-out-file={out}"]
        subprocess.run(
            [*line, str(PROGRAM), "--repeats", "1", *laws], check=True, capture_output=True
        )
        for dump in Path(folder).glob("callgrind.*"):
            text = dump.read_text(errors="replace")
            name = re.search(r"^desc: Trigger: Client Request: (\w+)/(\w+)/(\w+)$", text, re.M)
            events = re.search(r"^events: (.+)$", text, re.M)
            total = re.search(r"^(?:summary|totals): (.+)$", text, re.M)
            if not (name and events and total):
                continue
            count = dict(zip(events[1].split(), map(int, total[1].split()), strict=False))
            misses = count.get("D1mr", 0) + count.get("D1mw", 0)
            per_contact = (count["Ir"] / CONTACT_STEPS, misses / CONTACT_STEPS)
            rows.append((*name.groups(), *per_contact))
    return pd.DataFrame(rows, columns=[*KEYS, "instructions", "cache_misses"])


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--law", nargs="*", default=[], help="names of laws; default: all")
    parser.add_argument(
        "--repeats", type=int, default=100, help="repetitions of a path (default: %(default)s)"
    )
    options = parser.parse_args()
    build()
    table = times(options.law, options.repeats)
    if shutil.which("valgrind"):
        table = table.merge(counts(options.law), on=KEYS, how="left")
    else:
        print("instructions are not counted, because valgrind is missing")
    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    table.drop(columns="sum").to_csv(RESULTS, index=False, float_format="%.4g")
    print(table.drop(columns="sum").to_string(index=False, float_format="%.1f"))
    print(f"wrote {RESULTS}")


if __name__ == "__main__":
    main()
