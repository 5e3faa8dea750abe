# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw the figures of the docs: one per law, found and never listed, and the README's, the rod's,
the cylinder study's, the bulk decks' and of calibration.

Run it with `./run figures`; the files in docs/figures are its output.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import law_figures
import numpy as np
from matplotlib.figure import Figure

from plastigran import laws
from plastigran.bulk.decks.compaction.figure import compaction_figure
from plastigran.bulk.decks.cooling_gas.figure import cooling_figure
from plastigran.bulk.decks.hopper import orifices
from plastigran.bulk.decks.hopper.figure import orifices_figure
from plastigran.bulk.outcome import BulkRun
from plastigran.bulk.run import run_bulk
from plastigran.calibration import DropTest, calibrate
from plastigran.calibration.figures import figure as calibration_figure
from plastigran.experiments import find_experiments
from plastigran.plot.snapshot import draw, find_frames
from plastigran.plot.style import save, title

FOLDER = Path(__file__).parent / "figures"


def bulk(deck: str, **settings: object) -> BulkRun:
    """A run of a bulk deck whose checks have passed; its folder is gone."""
    with tempfile.TemporaryDirectory() as folder:
        return run_bulk(deck, settings, Path(folder) / deck).raise_if_failed()


def cooling_gases() -> Figure:
    """A gas that yields beside a viscoelastic one of the same grains: a minute or two each."""
    runs = {law: bulk("cooling_gas", law=law, side=10, **given) for law, given in COOLING.items()}
    gas = runs["vu_quoc_zhang"].deck
    rate = gas.gas().cooling_rate(gas.temperature)
    return cooling_figure({title(law): run.series for law, run in runs.items()}, gas.stall, rate)


def draw_bulk(deck: str) -> None:
    """The figure of a bulk deck at its defaults, about a minute each."""
    save(bulk(deck).figures[deck], FOLDER / deck, (".png",))


def compactions() -> Figure:
    """Grains of three strengths pressed to the same density: a minute each."""
    settings = {"die_radius": 0.0075, "layers": 9, "relative_density": 0.7, "release": 0.3}
    runs = {
        f"$\\sigma_Y$ = {strength / 1e3:g} kPa": bulk(
            "compaction", yield_strength=strength, **settings
        ).series
        for strength in STRENGTHS
    }
    return compaction_figure(runs, STRENGTHS)


def shot_figures() -> dict[str, Figure]:
    """Shot on a plate and on a bed, at the deck's defaults: a minute or two each."""
    return {
        f"bed_impact_{target}": bulk("bed_impact", target=target).figures["bed_impact"]
        for target in ("plate", "bed")
    }


# Yield strengths of the compacted grains [Pa].
STRENGTHS = [5e4, 1e5, 2e5]


# Settings of the cooling gas by law; the dissipative constant gives 0.93 at 1 m/s.
COOLING = {
    "vu_quoc_zhang": {},
    "viscoelastic_hertz": {"dissipative_constant": 1e-7, "timestep": 7e-8},
}


def hoppers() -> Figure:
    """The same bed run out of every orifice: one to four minutes each, narrow ones the longest."""
    runs = [bulk("hopper", orifice=orifice) for orifice in orifices()]
    courses = [(r.series, r.deck.discharge(r.series), r.deck.grains.mass) for r in runs]
    return orifices_figure(courses)


def draw_hopper_grains() -> None:
    """Grains of the demo's hopper half-way, by plastic work: a minute."""
    with tempfile.TemporaryDirectory() as folder:
        run_bulk("hopper", {"layers": "10", "frames": "8"}, Path(folder) / "run")
        frames = find_frames(Path(folder) / "run")
        draw(frames[len(frames) // 2], FOLDER / "hopper_grains.png", view="front")


def draw_laws(names: list[str]) -> None:
    for name in names:
        save(law_figures.figure(name), FOLDER / name, (".svg",))


def draw_experiments() -> None:
    """The figures that experiments have in the docs, as they name them."""
    for experiment in find_experiments().values():
        if not experiment.docs_figures:
            continue
        with tempfile.TemporaryDirectory() as folder:
            runs = experiment.study(folder, **experiment.docs)
        for name, file in experiment.docs_figures.items():
            save(runs.figure(name), FOLDER / file, (Path(file).suffix,))


def draw_bulk_decks() -> None:
    save(cooling_gases(), FOLDER / "cooling_gas", (".png",))
    for deck in ("drum", "chute"):
        draw_bulk(deck)
    save(compactions(), FOLDER / "compaction", (".png",))
    for name, figure in shot_figures().items():
        save(figure, FOLDER / name, (".png",))
    save(hoppers(), FOLDER / "hopper", (".png",))
    draw_hopper_grains()


def draw_calibration() -> None:
    """The law against the drops of docs/calibrate.md, and against finite elements: a minute."""
    steel = {"youngs_modulus": 206e9, "poissons_ratio": 0.3, "density": 7850.0}
    falls, rebounds = np.array(DROPS).T
    drops = DropTest(np.sqrt(2 * 9.81 * falls), np.sqrt(rebounds / falls))
    paper = {"youngs_modulus": 70e9, "poissons_ratio": 0.3, "density": 2699.0}
    for name, metal in {
        "calibrate_drops": calibrate(**steel, drops=drops),
        "calibrate_finite_elements": calibrate(**paper, yield_strength=1e8, force_ratio=41),
    }.items():
        save(calibration_figure(metal), FOLDER / name, (".png",))


# Heights of fall and rebound of a ball of steel on a rigid plate [m]: an example.
DROPS = [(0.05, 0.0215), (0.05, 0.0222), (0.10, 0.0385), (0.20, 0.0680), (0.50, 0.1490)]


if __name__ == "__main__":
    draw_laws(sys.argv[1:] or sorted(laws.LAWS))
    if len(sys.argv) == 1:
        draw_experiments()
        draw_bulk_decks()
        draw_calibration()
