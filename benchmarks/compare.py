#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the results of two states of the project byte by byte.

    ./run compare HEAD~20          # a commit, which is checked out and built in build/compare
    ./run compare ../elsewhere     # the folder of a built tree

Each state runs its own decks with its own LIGGGHTS and the same settings. The runs are every law in
every collision deck, the benchmark impacts, and each bulk deck with settings for a short run. Bulk
decks run on one rank, and for fewer steps on two ranks. Dumps, rows of the log and error messages
must be identical. The command lists the differences, and exits with 1 if there is a difference.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from plastigran import materials
from plastigran.bulk.decks import deck_class
from plastigran.engine.deck import index_variables
from plastigran.engine.process import PROJECT
from plastigran.usable_laws import laws_for


@dataclass(frozen=True)
class Run:
    """Run of a deck: number of ranks, and settings that override the defaults of the deck."""

    deck: str
    ranks: int = 1
    settings: dict[str, object] = field(default_factory=dict, hash=False)
    label: str = ""

    @property
    def name(self) -> str:
        words = [self.deck.removesuffix(".in").replace("/", "_"), self.label, str(self.ranks)]
        return "_".join(word for word in words if word)


def runs(tree: Path) -> list[Run]:
    """Return short runs of all laws of this project with the decks of a source tree."""
    inputs, chosen = tree / "inputs", []
    for law in sorted(
        {*laws_for("sphere"), *laws_for("cylinder")}
        & {page.stem for page in (tree / "docs" / "laws").glob("*.md")}
    ):
        for deck in sorted((inputs / "collision").glob("*.in")):
            settings = {"law": law, **material_with(law, deck)}
            ranks = (1, 2) if deck.stem == "two_spheres" else (1,)
            chosen += [Run(f"collision/{deck.name}", n, settings, law) for n in ranks]
    for deck in sorted((inputs / "collision" / "chung_ooi").glob("*.in")):
        chosen += [Run(f"collision/chung_ooi/{deck.name}")]
    for deck in sorted((inputs / "bulk").glob("*.in")):
        definition = deck_class(deck.stem)
        for label, brief in definition.briefs.items() if definition else ():
            for ranks, settings in ((1, brief.settings), (2, {**brief.settings, **brief.start})):
                chosen += [Run(f"bulk/{deck.name}", ranks, settings, label)]
    return chosen


def material_with(law: str, deck: Path) -> dict[str, str]:
    """Return a setting `material` that names a material with all constants of the law.

    The result is {} if the default material of the deck has these constants.
    """
    default = index_variables(deck)["material"]
    for name in (default, *materials.names()):
        if not materials.read_material(name).missing(law):
            return {} if name == default else {"material": name}
    sys.exit(f"no material has the constants of {law}")


def execute(tree: Path, run: Run, folder: Path) -> dict[str, bytes]:
    """Run a deck of a source tree, and return the results by name.

    The results must be the same in both trees.
    """
    folder.mkdir(parents=True)
    line = [str(tree / "build" / "liggghts-plastigran"), "-in", str(tree / "inputs" / run.deck)]
    line += ["-log", str(folder / "log.liggghts")]
    settings = {"inputs": tree / "inputs", "output": folder, **run.settings}
    for name, value in settings.items():
        line += ["-var", name, str(value)]
    if run.ranks > 1:
        line = ["mpirun", "--oversubscribe", "-np", str(run.ranks), *line]
    allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    done = subprocess.run(
        line, cwd=folder, env=os.environ | allowed, capture_output=True, check=False
    )
    log = folder / "log.liggghts"
    text = log.read_text(errors="replace") if log.exists() else ""
    results = {file.name: file.read_bytes() for file in sorted(folder.glob("*.dump"))}
    results["log"] = "\n".join(
        lines_to_compare(text, done.stdout.decode(errors="replace"))
    ).encode()
    results["end"] = str(done.returncode).encode()
    return results


def lines_to_compare(log: str, screen: str) -> list[str]:
    """Return the rows of numbers, and the error messages without positions in source files."""
    rows = [
        line for line in log.splitlines() if re.fullmatch(r"\s*\d+(\s+[-+.\deE]+|\s+nan)+\s*", line)
    ]
    errors = [line for line in (log + screen).splitlines() if line.startswith("ERROR")]
    return rows + sorted({re.sub(r" \(\S+:\d+\)$", "", line) for line in errors})


def built(state: str) -> Path:
    """Return the folder of a built source tree.

    The tree is the folder `state`, or a new checkout of the commit `state`, which is built first.
    """
    if (Path(state) / "build" / "liggghts-plastigran").exists():
        return Path(state).resolve()
    commit = subprocess.run(
        ["git", "rev-parse", "--verify", f"{state}^{{commit}}"],
        cwd=PROJECT,
        capture_output=True,
        text=True,
        check=False,
    ).stdout.strip()
    if not commit:
        sys.exit(f"{state} is neither a built tree nor a commit. Give one of them")
    tree = PROJECT / "build" / "compare" / commit[:12]
    if not tree.exists():
        subprocess.run(
            ["git", "worktree", "add", "--detach", str(tree), commit], cwd=PROJECT, check=True
        )
    subprocess.run(["./run", "setup"], cwd=tree, check=True)
    return tree


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("state", help="a commit, or the folder of a built tree")
    parser.add_argument("--only", default="", help="only runs whose name contains this word")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    other = built(arguments.state)
    chosen = [run for run in runs(other) if arguments.only in run.name]
    if not chosen:
        sys.exit(f"no run has {arguments.only!r} in its name")
    differing = []
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(arguments.jobs) as pool:

        def compare(run: Run) -> tuple[str, list[str]]:
            before = execute(other, run, Path(scratch) / "before" / run.name)
            after = execute(PROJECT, run, Path(scratch) / "after" / run.name)
            names = sorted(before.keys() | after.keys())
            size = sum(map(len, before.values()))
            summary = f"{size:9d} bytes" + (", refused" if before["end"] != b"0" else "")
            return summary, [name for name in names if before.get(name) != after.get(name)]

        for run, (summary, different) in zip(chosen, pool.map(compare, chosen), strict=True):
            verdict = f"differs: {', '.join(different)}" if different else "same"
            print(f"{run.name:48s} {summary:26s} {verdict}", flush=True)
            differing += [run.name] if different else []
    print(f"{len(chosen)} runs, {len(differing)} differ")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
