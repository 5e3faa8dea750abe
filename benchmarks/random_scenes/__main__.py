#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Random scenes in the engine against a replay: forces, memory and ledger.

    .venv/bin/python benchmarks/random_scenes --scenes 1000

Each scene has a random sphere law with random options, one to three materials, two to fourteen
particles that close in on each other, periodic sides or walls, one of them perhaps a mesh, one to
four ranks, and up to four runs with something done between them: particles deleted or created, all
displaced, steps counted anew, the pair style given again, a restart on other ranks. Each frame's
forces must be those that follow from its positions alone, and so must elastic energy and plastic
work of the ledger. A scene is made from its seed: `--seed 17 --scenes 1 --keep` shows one again.
"""

from __future__ import annotations

import argparse
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from deck import write_decks
from replay import FORCE, PLACE, Replay
from scene import AXES, Event, Scene, random_scene
from tqdm import tqdm

from plastigran.engine.dumps import read_frames
from plastigran.engine.log import LOG, read_thermo
from plastigran.engine.process import PROJECT, EngineError, run_deck

#: Of the largest force or energy of a scene. An overlap of 1e-5 of the box is rounded to 1e-11 of
#: itself, and steep branches make of it ten times as much.
TOLERANCE = 1e-9
RESULTS = PROJECT / "results" / "random_scenes.csv"


@dataclass(frozen=True)
class Verdict:
    """What came of a scene: largest differences, relative; or why there are none."""

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
    events = ", ".join(event.kind for event in scene.events)
    head = (seed, scene.law_name, max(int(np.prod(e.grid)) for e in scene.events), events)
    try:
        logs = []
        for number, (deck, grid) in enumerate(write_decks(scene, folder)):
            run_deck(deck, {}, folder, ranks=int(np.prod(grid)), timeout=120)
            logs.append(folder / f"log_{number}")
            (folder / LOG).rename(logs[-1])
        return Verdict(*head, *compare(scene, folder, logs))
    except (EngineError, AssertionError) as error:
        return Verdict(*head, error=str(error))


def compare(scene: Scene, folder: Path, logs: list[Path]) -> tuple[int, int, float, float, float]:
    """Contacts, frames, and the largest differences of force, elastic energy and plastic work."""
    ledger = [read_thermo(log) for log in logs]
    told = pd.concat(ledger, ignore_index=True)[ledger[0].columns].dropna()  # the run 0 has others
    told = told.set_axis(["run", "step", "kinetic", "elastic", "plastic", "drift"], axis=1)
    replay, last = Replay(scene), None
    scale_force, worst_force, frames = 0.0, 0.0, 0
    elastic, plastic, energy = [], [], 0.0
    for number, event in enumerate(scene.events):
        for frame in read_frames(folder / f"run_{number}.dump"):
            first = last is None or frame["step"].iloc[0] != last[2] + 1
            names = match(scene, event, frame, last)
            force, stored = replay.forces(names, frame, first)
            off = np.abs(force - frame[FORCE].to_numpy()).max()
            scale_force = max(scale_force, np.abs(force).max())
            worst_force = max(worst_force, off)
            energy = max(
                energy, 0.5 * (frame["mass"] * (frame[["vx", "vy", "vz"]] ** 2).sum(axis=1)).sum()
            )
            last = (names, frame[PLACE].to_numpy(), frame["step"].iloc[0])
            frames += 1
            if first:
                elastic.append(stored), plastic.append(replay.plastic_work)
        elastic.append(stored), plastic.append(replay.plastic_work)
    assert len(told) == len(elastic), (
        f"{len(told)} lines of the ledger, {len(elastic)} ends of runs"
    )
    grown = np.diff(plastic)[::2] - np.diff(told["plastic"])[::2]  # within runs
    return (
        replay.touched,
        frames,
        worst_force / (scale_force or 1),
        np.abs(told["elastic"] - elastic).max() / energy,
        np.abs(grown).max() / energy,
    )


def match(scene: Scene, event: Event, frame: pd.DataFrame, last) -> np.ndarray:
    """Names of a frame's particles: those of the nearest ones before, moved by the event."""
    places = frame[PLACE].to_numpy()
    if last is None:
        return frame["id"].to_numpy()
    names, before, step = last
    if frame["step"].iloc[0] == step + 1:
        return names
    if event.kind == "displace":
        before = before + event.shift
    periodic = np.array([axis not in scene.walled for axis in AXES])
    apart = places[:, None] - before[None]
    side = scene.high - scene.low
    apart -= np.where(periodic, side * np.round(apart / side), 0)
    distance = np.sqrt((apart**2).sum(axis=-1))
    nearest = distance.argmin(axis=1)
    found = np.where(distance.min(axis=1) < 1e-9, names[nearest], 0)
    fresh = np.flatnonzero(found == 0)
    assert len(fresh) == ("create" in event.kind), (
        f"{len(fresh)} particles appeared at {event.kind}"
    )
    found[fresh] = 1 + names.max() + step  # a name that nobody had
    gone = np.setdiff1d(names, found)
    if "delete" not in event.kind:
        assert not len(gone), f"{len(gone)} particles went at {event.kind}"
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--scenes", type=int, default=1000, help="how many (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the first (default: %(default)s)")
    parser.add_argument("--workers", type=int, default=2, help="at a time (default: %(default)s)")
    parser.add_argument("--keep", type=Path, help="folder for the runs of scenes that differ")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(options.workers) as pool:
        root = options.keep or Path(scratch)

        def one(seed: int) -> Verdict:
            folder = root / str(seed)
            folder.mkdir(parents=True, exist_ok=True)
            verdict = judge(seed, folder)
            if verdict.passed:
                for path in sorted(folder.iterdir()):
                    path.unlink()
                folder.rmdir()
            return verdict

        seeds = range(options.seed, options.seed + options.scenes)
        verdicts = list(tqdm(pool.map(one, seeds), total=len(seeds), unit="scene"))
    table = pd.DataFrame([{**vars(v), "passed": v.passed} for v in verdicts])
    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    table.to_csv(RESULTS, index=False)
    differ = table[~table["passed"]]
    if len(differ):
        print(differ.to_string(index=False, max_colwidth=60))
    print(
        f"{len(table)} scenes, {table['contacts'].sum()} contacts, {table['frames'].sum()} frames: "
        f"{len(differ)} differ by more than {TOLERANCE:g}; largest differences of the others: "
        + ", ".join(
            f"{n} {table.loc[table['passed'], n].max():.1e}"
            for n in ("force", "elastic", "plastic")
        )
    )
    print(f"wrote {RESULTS}")
    if len(differ):
        raise SystemExit(1)


if __name__ == "__main__":
    main()
