# SPDX-License-Identifier: GPL-2.0-or-later
"""Order in which benchmarks run their laws, and start of a benchmark program."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from tqdm import tqdm

from plastigran.engine.process import EngineError


def turns(names: list[str], repeats: int, bar: str = "") -> Iterable[tuple[int, str]]:
    """Return round and name of each run.

    A round contains one run of every name. Each round begins with another name.
    """
    order = [
        (round_, name)
        for round_ in range(repeats)
        for name in names[round_ % len(names) :] + names[: round_ % len(names)]
    ]
    return tqdm(order, desc=bar, unit="run")


def start(main: Callable[[], None]) -> None:
    """Call a program, and exit with the message of an error of LIGGGHTS or LAMMPS."""
    try:
        main()
    except EngineError as error:
        raise SystemExit(f"ERROR: {error}") from None
