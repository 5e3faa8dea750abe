#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Test bulk runs: killed runs, restarts, numbers of ranks, energy balance, and large systems.

    ./run reliability                    # all parts; about half an hour on two cores
    ./run reliability kills restarts     # only the parts on killed runs and on restarts

The script writes the table rows of the chosen parts into docs/reliability.md, and the results of
the runs into results/reliability. The script ends with an error if a value exceeds its limit.
"""

from __future__ import annotations

import argparse
import random
import re
import resource
import shutil
from collections.abc import Callable, Iterator
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from page_rows import Row, write_rows
from reliability_kills import kills
from tqdm import tqdm

from plastigran import laws
from plastigran.bulk.checks import LEDGER_CHECKS, energy_input
from plastigran.bulk.deck import BENCHMARK_BALANCE
from plastigran.bulk.decks import deck_class, deck_names
from plastigran.bulk.run import run_bulk
from plastigran.engine.checkpoints import PATTERN
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import PROJECT, run_deck
from plastigran.usable_laws import laws_for

WORK = PROJECT / "results" / "reliability"
PAGE = PROJECT / "docs" / "reliability.md"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(PARTS))
    parser.add_argument(
        "--count", type=int, default=100, help="number of killed runs and of restarts; default 100"
    )
    parser.add_argument(
        "--seed", type=int, default=1, help="seed of the random moments, laws and geometries"
    )
    arguments = parser.parse_args()
    if unknown := set(arguments.parts) - set(PARTS):
        parser.error(f"part is {unknown.pop()!r}; it must be one of {', '.join(PARTS)}")
    shutil.rmtree(WORK, ignore_errors=True)
    failed = []
    for part in arguments.parts or PARTS:
        random.seed(arguments.seed)
        folder = WORK / part
        folder.mkdir(parents=True)
        rows = list(PARTS[part](folder, arguments.count))
        for row in rows:
            print(row.cells())
        failed += [row for row in rows if not row.passed]
        write_rows(PAGE, part, rows)
    if failed:
        raise SystemExit("\n".join(["above the limit:", *(row.cells() for row in failed)]))


def restarts(folder: Path, count: int) -> Iterator[Row]:
    """Restart oblique collisions of two spheres, or of a sphere with a plane or mesh."""
    decks = PROJECT / "tests" / "conformance" / "decks"
    names = [
        name
        for name in laws_for("sphere")
        if not laws.LAWS[name].rate_dependent and name != "hertz"
    ]
    different = done = 0
    with tqdm(total=count, desc="restarts") as bar:
        while done < count:
            law, geometry = random.choice(names), random.choice(["pair", "plane", "mesh"])
            before = random.randint(5, 110)
            case = {"law": law, "geometry": geometry, "decks": decks, "after": 150}
            run_deck(decks / "restart_write.in", case | {"before": before}, folder / "whole")
            whole = read_dump(folder / "whole" / "trajectory.dump")
            whole = whole[whole["step"] >= before].drop_duplicates(["step", "id"])
            if whole["fx"].iloc[0] == 0:
                continue  # the bodies separated before the restart
            # In the first step of a run, forces use the current velocities. In later steps, forces
            # use the velocities of half a step earlier. Friction may therefore differ by round-off
            # in the first step after a restart, but the later motion does not differ.
            whole = whole[whole["step"] > before]
            case["restart"] = folder / "whole" / "middle.restart"
            run_deck(decks / "restart_read.in", case, folder / "rest")
            rest = read_dump(folder / "rest" / "trajectory.dump")
            rest = rest[rest["step"] > before]
            different += not np.array_equal(rest.to_numpy(), whole.to_numpy())
            done += 1
            bar.update()
    yield Row(
        "number of collisions that are not bitwise identical to the collision without restart, of "
        f"{count} collisions with random laws and geometries",
        different,
        0,
    )


def ranks(folder: Path, _: int) -> Iterator[Row]:
    """Compare runs of the same granular gas on 1, 2 and 4 ranks."""
    values = {"side": "8", "mixing": "0.1", "duration": "60", "rows": "240", "checkpoints": "1"}
    runs = {}
    for count in (1, 2, 4):
        run = run_bulk("cooling_gas", values, folder / str(count), count, show=False)
        runs[count] = run.raise_if_failed().series
    one = runs.pop(1)
    for count, other in runs.items():
        ratio = (other["kinetic_energy"] / one["kinetic_energy"] - 1).abs()
        # Compare early rows only: round-off grows tenfold per impact, to 1e-10 after six impacts.
        early = one["collisions"] < 1
        yield Row(
            f"{count} ranks compared with one, up to one collision per grain: relative difference "
            "of the kinetic energy of 512 grains",
            ratio[early].max(),
            1e-9,
        )
        late = f"{one['collisions'].iloc[-1]:.0f} collisions per grain"
        yield Row(
            f"{count} ranks compared with one, after {late}: difference of the kinetic energy, "
            "divided by the standard deviation expected for two gases with different random "
            "initial velocities",
            (ratio / (2**0.5 * one["temperature_error"])).iloc[-1],
            4,
        )


def ledger(folder: Path, _: int) -> Iterator[Row]:
    """Check the energy balance of the bulk decks at their default size, on two ranks.

    The decks of the bulk benchmark are left out, because they run for hours or days.
    """
    for deck in deck_names():
        if deck_class(deck).balance_limit == BENCHMARK_BALANCE:
            continue
        run = run_bulk(deck, {}, folder / deck, ranks=2).raise_if_failed()
        series, checks = run.series, run.checks.set_index("name")
        grains, steps = int(series["atoms"].max()), int(series["step"].iloc[-1])
        share = np.ptp(series["plastic"]) / energy_input(series)
        error = LEDGER_CHECKS[0]
        yield Row(
            f"balance error of `{deck}` ({grains} grains, {steps} steps; plastic work {share:.0%})",
            checks.value[error],
            checks.limit[error],
        )


def size(folder: Path, _: int) -> Iterator[Row]:
    """Measure time and memory of a gas of more than 200 000 grains, on two ranks."""
    log = folder / "log.liggghts"
    values = {"side": "59", "mixing": "0.1", "duration": "1e9", "rows": "1000000000"}
    values |= {"checkpoints": "1"}
    # The deck gives the duration in collision times. Replace it by a number of steps.
    deck = PROJECT / "inputs" / "bulk" / "cooling_gas.in"
    text = deck.read_text()
    text = text.partition("variable per_row")[0] + (
        "thermo 1000\nrestart 20000 ${output}/checkpoint.*.restart\nrun 20000 upto\n"
    )
    (folder / "cooling_gas.in").write_text(text)
    with get_context("spawn").Pool(1) as pool:  # its only children are the ranks
        peak = pool.apply(_largest_rank, (folder / "cooling_gas.in", values, folder))
    loop = re.findall(
        r"Loop time of (\S+) on 2 procs for 20000 steps with (\d+) atoms", log.read_text()
    )[-1]
    seconds, grains = float(loop[0]), int(loop[1])
    written = max(file.stat().st_size for file in folder.glob(PATTERN))
    yield Row(
        f"wall time of `cooling_gas` (s): {grains} grains, 20 000 steps, two ranks", round(seconds)
    )
    yield Row("grains · steps per second", grains * 20000 / seconds)
    yield Row("memory of both ranks, GiB", 2 * peak / 2**30, 24)
    yield Row("bytes per grain", 2 * peak / grains)
    yield Row("bytes per grain of a checkpoint", written / grains)


def _largest_rank(deck: Path, values: dict[str, str], folder: Path) -> int:
    """Return the largest memory of a rank, including libraries, in a run on two ranks [bytes]."""
    run_deck(deck, values, folder, ranks=2, timeout=7200)
    return 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss


PARTS: dict[str, Callable[[Path, int], Iterator[Row]]] = {
    part.__name__: part for part in (kills, restarts, ranks, ledger, size)
}

if __name__ == "__main__":
    main()
