#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Print for every law what a step costs beyond its range, over one within it.

    .venv/bin/python benchmarks/range_cost.py

It was 20 to 100 for laws whose energy is a quadrature when each contact was looked at in each step.
"""

from __future__ import annotations

import re
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from tempfile import TemporaryDirectory

from plastigran import laws
from plastigran.engine.process import run_deck
from plastigran.usable_laws import laws_for

DECK = Path(__file__).with_suffix(".in")

#: Yield strengths [Pa]: with the first a motion is nearly all beyond yield; the first of the others
#: that leads to twice the law's range is the one to compare with.
STRONG, WEAKER = 3e4, (1e4, 3e3, 1e3)


def overlap_range(law: str, strength: float) -> float:
    """Over R*."""
    body = laws.Body(youngs_modulus=5e6, poissons_ratio=0.3, yield_strength=strength)
    return laws.LAWS[law](laws.combine(body, body)).overlap_range


def cpu_time(law: str, strength: float, depth: float, folder: Path) -> tuple[float, int]:
    """Processor time of a run to an overlap of `depth` R* [s], which is less at the mercy of other
    processes than its length, and the number of contacts that left the law's range."""
    speed = depth * 0.0025 / (2000 * 1e-7)
    before = getrusage(RUSAGE_CHILDREN)
    log = run_deck(DECK, {"law": law, "strength": strength, "speed": speed}, folder)
    after = getrusage(RUSAGE_CHILDREN)
    assert "Loop time of" in log and " 2000 steps with 1024 atoms" in log
    counted = re.findall(r"contacts beyond the law's range .* so far: (\d+)", log)
    return after.ru_utime - before.ru_utime, int(counted[-1]) if counted else 0


def ratio(law: str, folder: Path, rounds: int = 4) -> float:
    """Processor time beyond a law's range over that within it, the shortest of some rounds each:
    others use the machine. The motion is the same, with less strength. A law that asks for small
    overlaps alone has no other range to leave.

    Raises:
        RuntimeError: Contacts were within the range, or beyond it, where they should not be.
    """
    depth = min(0.08, 0.9 * overlap_range(law, STRONG))
    twice = (weak for weak in WEAKER if overlap_range(law, weak) < 0.5 * depth)
    weak = next(twice, WEAKER[-1])
    times: dict[float, list[float]] = {STRONG: [], weak: []}
    for _ in range(rounds):
        for strength, found in times.items():
            seconds, counted = cpu_time(law, strength, depth, folder)
            if (counted > 0) != (overlap_range(law, strength) < depth):
                raise RuntimeError(f"{law}: {counted} contacts beyond its range at {strength:g} Pa")
            found.append(seconds)
    return min(times[weak]) / min(times[STRONG])


def main() -> None:
    names = [name for name in laws_for("sphere") if laws.LAWS[name].yields]
    with TemporaryDirectory() as folder:
        for name in names:
            print(f"{name:20s} {ratio(name, Path(folder)):.2f}")


if __name__ == "__main__":
    main()
