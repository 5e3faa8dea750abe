#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Run shortened tutorials of LIGGGHTS with laws of this project, and print a table.

    .venv/bin/python benchmarks/tutorials.py [TREE] [--laws universal thornton] [--rounds 3]

TREE is the source tree of LIGGGHTS, which tests/in_tree/build_upstream.sh fetches. The script
replaces the normal model of each deck by a law, adds a yield strength, and changes nothing else in
the physics.
"""

from __future__ import annotations

import argparse
import re
import shutil
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from statistics import median
from tempfile import TemporaryDirectory

from attrs import frozen

from plastigran.engine.process import PROJECT, EngineError, run_deck


@frozen
class Tutorial:
    """Tutorial of LIGGGHTS, and the changes that shorten its run.

    Attributes:
        folder: Folder in examples/LIGGGHTS/Tutorials_public, and name of the deck without `in.`,
            separated by a slash.
        share: Number of steps of each run / number of steps in the tutorial.
        steps: Name of a variable with a number of steps, and its new value.
        strength: Yield strength / Young's modulus. With the default, grains yield in most contacts.
    """

    folder: str
    share: float = 0.1
    steps: tuple[str, int] | None = None
    strength: float = 0.01

    @property
    def deck(self) -> str:
        folder, name = self.folder.split("/")
        return f"{folder}/in.{name}"


TUTORIALS = (
    Tutorial("chute_wear/chute_wear", 0.1),
    Tutorial("cohesion/cohesion", 0.4, strength=0.1),  # cohesion would pull softer grains together
    Tutorial("contactModels/newModels", 0.2),
    Tutorial("conveyor/conveyor", 0.4),
    Tutorial("heatTransfer_1/heatGran", 0.1),
    Tutorial("heatTransfer_2/heatGran", 0.1),
    Tutorial("hydrogel_multicontact/hydrogel_default", steps=("ts_move", 6000)),
    Tutorial("hydrogel_multicontact/hydrogel_multicontact", steps=("ts_move", 400)),
    Tutorial("hysteresis/hysteresis", 1.0),
    Tutorial("insert_stream/insert_stream", 0.3),
    Tutorial("meshGran/meshGran", 0.4),
    Tutorial("mesh_tet/mesh_tet", 1.0),
    Tutorial("movingMeshGran/movingMeshGran", 0.1),
    Tutorial("multisphere_stone_restitution/multisphere", 0.3),
    Tutorial("packing/packing", 1.0, steps=("growts", 15000)),
)


def shortened(text: str, tutorial: Tutorial) -> str:
    """Return the deck with fewer steps, without its commands `dump` and `processors`."""
    text = re.sub(r"&\s*\n", " ", text.replace("\r", ""))
    text = re.sub(r"(?m)^\s*(dump|processors).*\n", "", text)
    if tutorial.steps:
        name, steps = tutorial.steps
        # Change only the number of steps, not the speeds of moving parts.
        text = re.sub(rf"(?m)^(\s*run\s+)\${{{name}}}", rf"\g<1>{steps}", text)
    return re.sub(
        r"(?m)^(\s*run\s+)(\d+)",
        lambda run: f"{run[1]}{max(1, round(int(run[2]) * tutorial.share))}",
        text,
    )


def ported(text: str, law: str, strength: float) -> str:
    """Return the deck with the law instead of its normal models, and a yield strength."""
    moduli = re.search(r"property/global youngsModulus peratomtype([^#\n]+)", text)[1].split()
    strengths = " ".join(f"{strength * float(modulus):g}" for modulus in moduli)
    line = f"fix yield_strength all property/global yieldStrength peratomtype {strengths}\n"
    text = re.sub(r"(?m)^(.*youngsModulus.*\n)", rf"\1{line}", text)
    return re.sub(r"\bmodel (hertz|hooke/hysteresis|hooke)\b", f"model {law}", text)


def run(text: str, source: Path, folder: Path, ranks: int = 1) -> tuple[float, str]:
    """Return the processor time of a deck [s] and its log; `source` contains its input files."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(source, folder)
    (folder / "post").mkdir(exist_ok=True)
    (folder / "deck.in").write_text(text)
    before = getrusage(RUSAGE_CHILDREN).ru_utime
    # Set no variables, because the tutorials do not have the variables `inputs` and `output`.
    none = {"inputs": None, "output": None}
    log = run_deck(folder / "deck.in", none, folder, ranks=ranks, working_folder=folder)
    return getrusage(RUSAGE_CHILDREN).ru_utime - before, log


def outcome(text: str, source: Path, folder: Path, ranks: int) -> str:
    """Return `runs`, or the error of LIGGGHTS."""
    try:
        run(text, source, folder, ranks)
    except EngineError as error:
        return str(error).splitlines()[-1]
    return "runs"


def row(tutorial: Tutorial, tree: Path, laws: list[str], rounds: int, folder: Path) -> str:
    """Return a table row: outcomes of the first law on 1 and 2 ranks, and the cost of each law."""
    deck = tree / "examples/LIGGGHTS/Tutorials_public" / tutorial.deck
    original = shortened(deck.read_text(), tutorial)
    texts = [original, *(ported(original, law, tutorial.strength) for law in laws), original]
    cells = [outcome(texts[1], deck.parent, folder, ranks) for ranks in (1, 2)]
    costs: list[list[float]] = [[] for _ in texts[1:]]
    for _ in range(rounds if cells[0] == "runs" else 0):
        times = [run(text, deck.parent, folder)[0] for text in texts]
        for ratios, time in zip(costs, times[1:], strict=True):
            ratios.append(time / times[0])
    cells += [f"{median(ratios):.2f}" if ratios else "" for ratios in costs]
    return f"| {' | '.join([tutorial.folder.split('/')[1], *cells])} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tree", nargs="?", type=Path, default=PROJECT / "build/in-tree/liggghts")
    parser.add_argument("--laws", nargs="+", default=["universal", "thornton"])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", default="", help="only tutorials whose folder contains this word")
    arguments = parser.parse_args()
    columns = ["tutorial", "1 rank", "2 ranks", *(f"`{law}`" for law in arguments.laws), "again"]
    print(f"| {' | '.join(columns)} |\n{'|---' * len(columns)}|")
    with TemporaryDirectory() as folder:
        for tutorial in TUTORIALS:
            if arguments.only in tutorial.folder:
                work = Path(folder) / "run"
                print(
                    row(tutorial, arguments.tree, arguments.laws, arguments.rounds, work),
                    flush=True,
                )


if __name__ == "__main__":
    main()
