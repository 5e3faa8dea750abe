# SPDX-License-Identifier: GPL-2.0-or-later
"""Bulk runs that are killed at random moments and continue from their newest checkpoint."""

from __future__ import annotations

import os
import random
import shutil
import signal
import time
from collections.abc import Iterator
from contextlib import suppress
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from page_rows import Row
from tqdm import tqdm

from plastigran.bulk.folder import read_record, restart_point
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series
from plastigran.engine.checkpoints import PATTERN, step_of
from plastigran.engine.log import LogFollower
from plastigran.engine.process import EngineError, engines

#: Settings of a granular gas whose run takes some seconds and writes a checkpoint every tenth of a
#: second.
SMALL = {"side": "5", "duration": "100", "rows": "200", "checkpoints": "50", "mixing": "1"}


class RunLost(RuntimeError):
    """A run could not continue from its newest checkpoint."""


def kills(folder: Path, count: int) -> Iterator[Row]:
    """Kill mpirun and every rank at random moments, and continue from the last checkpoint."""
    for ranks in (1, 2):
        words = f"{ranks} rank{'s' * (ranks > 1)}"
        whole = folder / f"whole_{ranks}"
        run_bulk("cooling_gas", SMALL, whole, ranks, show=False).raise_if_failed()
        killed, lost, losses, ends = 0, 0, [0], []
        with tqdm(total=count // 2, desc=f"kills, {words}") as bar:
            while killed < count // 2 and lost < 10:
                try:
                    steps, end = kill_until_done(
                        folder / f"{ranks}_{len(ends) + lost}", ranks, whole
                    )
                except RunLost as error:
                    tqdm.write(str(error))
                    lost += 1
                    continue
                killed += len(steps)
                losses += steps
                ends.append(same_end(whole, end))
                bar.update(len(steps))
        yield Row(
            f"{words}: number of lost runs, of {len(ends) + lost} runs that were killed {killed} "
            "times in total",
            lost,
            0,
        )
        interval = checkpoint_interval(whole)
        yield Row(
            f"{words}: most steps lost to a kill; the limit is the number of steps between "
            "checkpoints",
            max(losses),
            interval,
        )
        if ranks == 1:
            other = len(ends) - sum(ends)
            yield Row(
                f"{words}: number of runs whose end is not bitwise identical to the end of the run "
                "without kills",
                other,
                0,
            )


def kill_until_done(work: Path, ranks: int, whole: Path) -> tuple[list[int], Path]:
    """Run a deck from its start; kill and continue it until it ends.

    Args:
        work: Folder for the parts of the run.
        ranks: MPI ranks.
        whole: Folder of the same run without kills.

    Returns:
        Number of steps lost by each kill, and the folder of the last part.

    Raises:
        RunLost: A part could not continue from the previous one.
    """
    last, at, earlier, losses = read_series(whole)["step"].iloc[-1], 0, None, []
    while True:
        folder = work / str(len(losses))
        process = get_context("fork").Process(target=_run_part, args=(folder, ranks, earlier))
        process.start()
        log, until = LogFollower(folder / "log.liggghts"), at + random.uniform(0, 0.15) * last
        # Kill a new simulation only in its second run. The first run mixes the gas, and the step
        # count restarts after it.
        while process.is_alive() and (log.read().step < until or log.progress.run < 1 + (at == 0)):
            time.sleep(0.002)
        time.sleep(random.uniform(0, 0.02))
        by_itself = not process.is_alive()
        for engine in engines(folder):
            with suppress(ProcessLookupError):  # the process has ended already
                os.kill(engine, signal.SIGKILL)
        process.join(60)
        if process.exitcode == 0:
            return losses, folder
        if by_itself:
            raise RunLost(f"{folder}: {(folder / 'error.txt').read_text()}")
        try:
            at = step_of(restart_point(folder, read_record(folder)))
        except EngineError:  # the run was killed before it wrote a checkpoint: start it again
            shutil.rmtree(folder)
            continue
        losses.append(log.read().step - at)
        earlier = folder


def _run_part(folder: Path, ranks: int, earlier: Path | None) -> None:
    try:
        run = run_bulk("cooling_gas", {} if earlier else SMALL, folder, ranks, earlier, show=False)
        run.raise_if_failed()
    except Exception as error:  # the run was killed, or cannot continue
        (folder / "error.txt").write_text(repr(error))
        os._exit(1)


def checkpoint_interval(folder: Path) -> int:
    steps = sorted(step_of(file) for file in folder.glob(PATTERN))
    return int(np.diff(steps).max())


def same_end(one: Path, other: Path) -> bool:
    columns = ["step", "kinetic_energy", "plastic"]
    return bool((read_series(one)[columns].iloc[-1] == read_series(other)[columns].iloc[-1]).all())
