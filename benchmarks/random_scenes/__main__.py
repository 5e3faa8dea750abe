#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare forces and energies of random scenes in LIGGGHTS with a replay in Python.

    .venv/bin/python benchmarks/random_scenes --scenes 1000

Each scene has a random law for spheres with random options, and one to three materials. Two to
fourteen particles approach each other. Each side of the box is periodic or a wall; one wall may be
a mesh. A scene runs on one to four ranks, in up to four runs. Between two runs, an event deletes,
creates or displaces particles, resets the step number, gives the pair style again, or restarts the
simulation on other ranks. The replay computes the expected forces, elastic energy and plastic work
only from the positions in the frames. A scene follows from its seed: `--seed 17 --scenes 1 --keep
FOLDER` repeats scene 17.
"""

from __future__ import annotations

import argparse
import csv
import os
import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, fields
from itertools import repeat
from pathlib import Path
from shutil import rmtree

import numpy as np
import pandas as pd
from deck import write_decks
from events import AXES, Event
from frames import Frame, read
from replay import Replay
from scene import Scene, random_scene
from tqdm import tqdm

from plastigran.engine.log import LOG, read_thermo
from plastigran.engine.process import PROJECT, run_deck

#: Largest allowed difference, relative to the largest force or energy of a scene. Positions are
#: rounded to 1e-16 of the box, so an overlap of 1e-5 of the box has a relative error of 1e-11. A
#: steep force curve multiplies this error by ten.
TOLERANCE = 1e-9
RESULTS = PROJECT / "results" / "random_scenes.csv"


@dataclass(frozen=True)
class Verdict:
    """Result of a scene: largest relative differences, or the error that stopped the scene."""

    seed: int
    law: str
    ranks: int
    events: str
    contacts: int = 0
    frames: int = 0
    force: float = np.nan
    elastic: float = np.nan
    plastic: float = np.nan
    error: str = ""

    @property
    def passed(self) -> bool:
        return not self.error and max(self.force, self.elastic, self.plastic) <= TOLERANCE


def judge(seed: int, folder: Path) -> Verdict:
    """Run a scene in a folder and compare it with its replay."""
    scene = random_scene(seed)
    events = ", ".join(event.action for event in scene.events)
    head = (seed, scene.law_name, max(int(np.prod(e.grid)) for e in scene.events), events)
    try:
        logs = []
        for number, (deck, grid) in enumerate(write_decks(scene, folder)):
            run_deck(deck, {}, folder, ranks=int(np.prod(grid)), timeout=120)
            logs.append(folder / f"log_{number}")
            (folder / LOG).rename(logs[-1])
        return Verdict(*head, *compare(scene, folder, logs))
    except Exception as error:  # record any error, also of the replay, and continue
        return Verdict(*head, error=f"{type(error).__name__}: {error}")


def compare(scene: Scene, folder: Path, logs: list[Path]) -> tuple[int, int, float, float, float]:
    """Return numbers of contacts and frames, and largest relative differences from the replay.

    The differences are those of force, elastic energy and plastic work.
    """
    ledger = [read_thermo(log) for log in logs]
    # Drop the rows of `run 0`, which have no energies.
    lines = pd.concat(ledger, ignore_index=True)[ledger[0].columns].dropna()
    lines = lines.set_axis(["run", "step", "kinetic", "elastic", "plastic", "drift"], axis=1)
    replay, last = Replay(scene), None
    scale, worst, energy, frames = 0.0, 0.0, 0.0, 0
    energies = []  # elastic energy and plastic work, at start and end of each run
    for number, event in enumerate(scene.events):
        run = list(read(folder / f"run_{number}.dump"))
        for frame in run:
            names = match(scene, event, frame, last)
            force, *stored = replay.forces(names, frame, begins=frame is run[0])
            scale = max(scale, np.abs(force).max(initial=0))
            worst = max(worst, np.abs(force - frame.force).max(initial=0))
            energy = max(energy, frame.kinetic_energy)
            last = (names, frame.place, frame.step)
            if frame is run[0] or frame is run[-1]:
                energies.append(stored)
        frames += len(run)
    assert len(lines) == len(energies), f"{len(lines)} lines of energies instead of {len(energies)}"
    difference = np.abs(lines[["elastic", "plastic"]].to_numpy() - energies).max(axis=0) / energy
    return (replay.contacts_begun, frames, float(worst / (scale or 1)), *map(float, difference))


def match(
    scene: Scene, event: Event, frame: Frame, last: tuple[np.ndarray, np.ndarray, int] | None
) -> np.ndarray:
    """Return the names of the particles in a frame.

    A particle has the same name in all runs, although commands may change atom IDs. Each particle
    has the name of the nearest particle in the last frame; a new particle has a new name.
    """
    if last is None:
        return frame.ids
    names, before, step = last
    if frame.step == step + 1:
        return names
    if event.action == "displace":
        before = before + event.shift
    periodic = np.array([axis not in scene.walled for axis in AXES])
    apart = frame.place[:, None] - before[None]
    side = scene.high - scene.low
    apart -= np.where(periodic, side * np.round(apart / side), 0)
    distance = np.sqrt((apart**2).sum(axis=-1))
    matched = np.zeros(len(distance), int)
    for k, row in enumerate(distance):
        if row.min(initial=1) < 1e-9:
            matched[k] = names[row.argmin()]
    new = np.flatnonzero(matched == 0)
    assert len(new) == ("create" in event.action), f"{len(new)} new particles at {event.action}"
    matched[new] = 1 + names.max(initial=0) + step  # new names, which no earlier particle had
    lost = np.setdiff1d(names, matched)
    assert "delete" in event.action or not len(lost), (
        f"{len(lost)} particles lost at {event.action}"
    )
    return matched


def judge_in(root: Path, seed: int) -> Verdict:
    """Call `judge` in a new folder; delete the folder if LIGGGHTS and the replay agree."""
    folder = root / str(seed)
    folder.mkdir(parents=True, exist_ok=True)
    verdict = judge(seed, folder)
    if verdict.passed:
        rmtree(folder)
    return verdict


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument(
        "--scenes", type=int, default=1000, help="number of scenes (default: %(default)s)"
    )
    parser.add_argument(
        "--seed", type=int, default=1, help="seed of the first scene (default: %(default)s)"
    )
    parser.add_argument(
        "--workers",
        type=int,
        default=2,
        help="number of scenes that run at the same time (default: %(default)s)",
    )
    parser.add_argument(
        "--keep",
        type=Path,
        help="folder for the files of scenes in which LIGGGHTS and the replay differ",
    )
    parser.add_argument(
        "--output",
        type=Path,
        default=RESULTS,
        help="file for the table of results (default: %(default)s)",
    )
    options = parser.parse_args()
    # Let idle ranks yield the processor, because other scenes need it.
    os.environ.setdefault("OMPI_MCA_mpi_yield_when_idle", "1")
    seeds = range(options.seed, options.seed + options.scenes)
    options.output.parent.mkdir(parents=True, exist_ok=True)
    with (
        tempfile.TemporaryDirectory() as scratch,
        ProcessPoolExecutor(options.workers) as pool,
        open(options.output, "w", newline="") as file,
    ):
        rows = csv.DictWriter(
            file, [*(f.name for f in fields(Verdict)), "passed"], lineterminator="\n"
        )
        rows.writeheader()
        verdicts = pool.map(judge_in, repeat(options.keep or Path(scratch)), seeds)
        for verdict in tqdm(verdicts, total=len(seeds), unit="scene"):
            rows.writerow({**vars(verdict), "passed": verdict.passed})
            file.flush()
    if report(pd.read_csv(options.output)):
        raise SystemExit(1)


def report(table: pd.DataFrame) -> int:
    """Print the results of all scenes, and return the number of scenes that differ."""
    passed = table["passed"]
    if not passed.all():
        print(table[~passed].to_string(index=False, max_colwidth=60))
    largest = table.loc[passed, ["force", "elastic", "plastic"]].max()
    print(
        f"{len(table)} scenes, {table['contacts'].sum()} contacts, {table['frames'].sum()} frames: "
        f"{(~passed).sum()} differ by more than {TOLERANCE:g}; largest differences of the others: "
        + ", ".join(f"{name} {value:.1e}" for name, value in largest.items())
    )
    return int((~passed).sum())


if __name__ == "__main__":
    main()
