# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw the figures of the docs, and update the tables on the same pages.

    ./run figures --list       list the parts
    ./run figures              draw all parts, in about an hour; a repeated command continues
    ./run figures NAME ...     draw the named parts
    ./run figures --again      draw all parts again

Figures of new laws and papers are drawn without further changes here.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
from adhesion_figure import adhesion_figure
from bulk_figures import BULK
from law_figures import draw_law
from overview_figure import overview_figure

from plastigran import laws
from plastigran.calibration import DropTest, calibrate
from plastigran.calibration.figures import figure as calibration_figure
from plastigran.cli import main as plastigran
from plastigran.experiments import find_experiments
from plastigran.experiments.central import PAPER_SPEEDS
from plastigran.papers import paper_names
from plastigran.plot.style import save

PROJECT = Path(__file__).parents[1]
FIGURES = PROJECT / "docs" / "figures"
#: File with the names of the parts that are already drawn.
DONE = PROJECT / "results" / "figures" / "done.txt"
#: For each experiment: settings of its study, and files of its figures by their names in
#: `Runs.figures`.
EXPERIMENTS = {
    "impact": ({"speed": PAPER_SPEEDS}, {"restitution": "restitution.png"}),
    "cylinder": ({}, {"maps_10": "cylinder_maps.png", "comparison": "cylinder_comparison.svg"}),
    "rod": ({}, {"outcome": "rod.png"}),
    "chung-ooi": (
        {"benchmark": (4, 6)},
        {"benchmark_4": "chung_ooi_4.png", "benchmark_6": "chung_ooi_6.png"},
    ),
}
#: Example of a drop test: heights of fall and rebound of a steel ball on a rigid plate [m].
DROPS = [(0.05, 0.0215), (0.05, 0.0222), (0.10, 0.0385), (0.20, 0.0680), (0.50, 0.1490)]


def draw_experiment(name: str, folder: Path) -> None:
    """Draw the figures of an experiment that `EXPERIMENTS` lists."""
    settings, files = EXPERIMENTS[name]
    with tempfile.TemporaryDirectory() as results:
        runs = find_experiments()[name].study(results, **settings)
    for figure, file in files.items():
        save(runs.figure(figure), folder / file, (Path(file).suffix,))


def draw_calibration(folder: Path) -> None:
    """Draw the calibrations of docs/calibrate.md by drops and by finite elements, in a minute."""
    steel = {"youngs_modulus": 206e9, "poissons_ratio": 0.3, "density": 7850.0}
    falls, rebounds = np.array(DROPS).T
    drops = DropTest(np.sqrt(2 * 9.81 * falls), np.sqrt(rebounds / falls))
    paper = {"youngs_modulus": 70e9, "poissons_ratio": 0.3, "density": 2699.0}
    for name, metal in {
        "calibrate_drops": calibrate(**steel, drops=drops),
        "calibrate_finite_elements": calibrate(**paper, yield_strength=1e8, force_ratio=41),
    }.items():
        save(calibration_figure(metal), folder / name, (".png",))


def draw_fit(folder: Path) -> None:
    """Draw the fit of `universal` to finite elements, and its errors, in some minutes."""
    from plastigran.validation.spheres.fit import main as fit

    fit(["--figures", str(folder)])


def draw_overview(folder: Path) -> None:
    """Draw the first figure of README and docs, in some seconds."""
    save(overview_figure(), folder / "overview", (".png",))


def draw_adhesion(folder: Path) -> None:
    """Draw the laws with adhesion, in some seconds."""
    save(adhesion_figure(), folder / "adhesion", (".png",))


def run_command(words: list[str], pages: str, folder: Path) -> None:
    """Run a command of `plastigran` that writes tables and pictures into pages of the docs.

    Raises:
        RuntimeError: The command failed and printed the reason.
    """
    with tempfile.TemporaryDirectory() as results:
        places = ["--output", results, "--force", "--docs", str(folder.parent / pages)]
        if plastigran([*words, *places]):
            raise RuntimeError(f"plastigran {' '.join(words)} failed")


def parts() -> dict[str, Callable[[Path], None]]:
    """Return the functions that draw the parts into a folder, by name of the part."""
    papers = {
        name: partial(run_command, ["reproduce", name], "papers")
        for name in sorted(paper_names())
        if name != "dosta24"  # takes hours: plastigran reproduce dosta24 --docs docs/papers
    }
    return (
        {name: partial(draw_law, name) for name in sorted(laws.LAWS)}
        | {
            "overview": draw_overview,
            "adhesion": draw_adhesion,
            "calibration": draw_calibration,
            "universal_fit": draw_fit,
        }
        | {name: partial(draw_experiment, name) for name in sorted(EXPERIMENTS)}
        | BULK
        | {"validation": partial(run_command, ["validate"], "")}
        | papers
    )


def draw_all(all_parts: dict[str, Callable[[Path], None]], folder: Path, again: bool) -> None:
    """Draw the parts that `DONE` does not list, and remove `DONE` after the last part."""
    if again:
        DONE.unlink(missing_ok=True)
    done = set(DONE.read_text().split()) if DONE.exists() else set()
    DONE.parent.mkdir(parents=True, exist_ok=True)
    for name in (name for name in all_parts if name not in done):
        print(f"drawing {name}", flush=True)
        all_parts[name](folder)
        with DONE.open("a") as file:
            file.write(f"{name}\n")
    DONE.unlink(missing_ok=True)


def main(words: list[str], folder: Path = FIGURES) -> None:
    """Draw the named parts, or all parts."""
    parser = argparse.ArgumentParser(prog="./run figures", description=__doc__.splitlines()[0])
    all_parts = parts()
    parser.add_argument(
        "name", nargs="*", choices=[[], *all_parts], metavar="NAME", help="name of a part"
    )
    parser.add_argument("--list", action="store_true", help="list the parts")
    parser.add_argument("--again", action="store_true", help="draw all parts from the start")
    arguments = parser.parse_args(words)
    if arguments.list:
        print("\n".join(all_parts))
    elif arguments.name:
        for name in arguments.name:
            all_parts[name](folder)
    else:
        draw_all(all_parts, folder, arguments.again)


if __name__ == "__main__":
    main(sys.argv[1:])
