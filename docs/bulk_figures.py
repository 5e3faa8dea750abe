# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw the figures on the pages of the bulk decks. Each function runs its deck."""

from __future__ import annotations

import tempfile
from pathlib import Path

from flow_function import flow_functions
from matplotlib.figure import Figure

from plastigran.bulk.decks.compaction.figure import compaction_figure
from plastigran.bulk.decks.cooling_gas.figure import cooling_figure
from plastigran.bulk.decks.hopper import orifices
from plastigran.bulk.decks.hopper.figure import orifices_figure
from plastigran.bulk.decks.uniaxial_test.figure import flow_function_figure
from plastigran.bulk.outcome import BulkRun
from plastigran.bulk.run import run_bulk
from plastigran.plot.frame_files import find_frames
from plastigran.plot.snapshot import draw
from plastigran.plot.style import save, title

#: Yield strengths of the compacted grains [Pa].
STRENGTHS = [5e4, 1e5, 2e5]
#: Settings of the cooling gas by law; the dissipative constant gives restitution 0.93 at 1 m/s.
COOLING = {
    "vu_quoc_zhang": {},
    "viscoelastic_hertz": {"dissipative_constant": 1e-7, "timestep": 7e-8},
}


def bulk(deck: str, **settings: object) -> BulkRun:
    """Run a bulk deck in a temporary folder. Stop if a check of the deck fails."""
    with tempfile.TemporaryDirectory() as folder:
        return run_bulk(deck, settings, Path(folder) / deck).raise_if_failed()


def cooling_gases() -> Figure:
    """Draw a plastic and a viscoelastic gas of the same grains. Takes four minutes."""
    runs = {law: bulk("cooling_gas", law=law, side=10, **given) for law, given in COOLING.items()}
    gas = runs["vu_quoc_zhang"].deck
    rate = gas.gas().cooling_rate(gas.temperature)
    return cooling_figure({title(law): run.series for law, run in runs.items()}, gas.stall, rate)


def compactions() -> Figure:
    """Draw grains of three strengths, compressed to the same density. Takes three minutes."""
    settings = {"die_radius": 0.0075, "layers": 9, "relative_density": 0.7, "release": 0.3}
    runs = {
        f"$\\sigma_Y$ = {strength / 1e3:g} kPa": bulk(
            "compaction", yield_strength=strength, **settings
        ).series
        for strength in STRENGTHS
    }
    return compaction_figure(runs, STRENGTHS)


def shot_figures() -> dict[str, Figure]:
    """Draw shots on a plate and on a bed with the defaults of the deck. Takes four minutes."""
    return {
        f"bed_impact_{target}": bulk("bed_impact", target=target).figures["bed_impact"]
        for target in ("plate", "bed")
    }


def hoppers() -> Figure:
    """Draw the discharge of a bed through each orifice. Takes one to four minutes per orifice."""
    runs = [bulk("hopper", orifice=orifice) for orifice in orifices()]
    courses = [(r.series, r.deck.discharge(r.series), r.deck.grains.mass) for r in runs]
    return orifices_figure(courses)


def draw_cooling_gas(folder: Path) -> None:
    save(cooling_gases(), folder / "cooling_gas", (".png",))


def draw_drum(folder: Path) -> None:
    save(bulk("drum").figures["drum"], folder / "drum", (".png",))


def draw_collision_spectra(folder: Path) -> None:
    """Draw the impacts in a drum. The run is too short for the check of the power."""
    settings = {"spectra": "on", "length": "0.03", "duration": "0.4"}
    with tempfile.TemporaryDirectory() as results:
        run = run_bulk("drum", settings, Path(results) / "drum")
    save(run.figures["collision_spectra"], folder / "collision_spectra", (".png",))


def draw_chute(folder: Path) -> None:
    save(bulk("chute").figures["chute"], folder / "chute", (".png",))


def draw_compaction(folder: Path) -> None:
    save(compactions(), folder / "compaction", (".png",))


def draw_uniaxial_test(folder: Path) -> None:
    save(bulk("uniaxial_test").figures["uniaxial_test"], folder / "uniaxial_test", (".png",))


def draw_flow_function(folder: Path) -> None:
    """Draw nine uniaxial tests. Takes five minutes."""
    with tempfile.TemporaryDirectory() as runs:
        table = flow_functions(Path(runs))
    save(flow_function_figure(table), folder / "flow_function", (".png",))


def draw_bed_impact(folder: Path) -> None:
    for name, figure in shot_figures().items():
        save(figure, folder / name, (".png",))


def draw_hopper(folder: Path) -> None:
    save(hoppers(), folder / "hopper", (".png",))


def draw_hopper_grains(folder: Path) -> None:
    """Draw the grains of a hopper after half of its run, colored by plastic work."""
    with tempfile.TemporaryDirectory() as run:
        run_bulk("hopper", {"layers": "10", "frames": "8"}, Path(run) / "run")
        frames = find_frames(Path(run) / "run")
        draw(frames[len(frames) // 2], folder / "hopper_grains.png", view="front")


BULK = {
    "cooling_gas": draw_cooling_gas,
    "drum": draw_drum,
    "collision_spectra": draw_collision_spectra,
    "chute": draw_chute,
    "compaction": draw_compaction,
    "uniaxial_test": draw_uniaxial_test,
    "flow_function": draw_flow_function,
    "bed_impact": draw_bed_impact,
    "hopper": draw_hopper,
    "hopper_grains": draw_hopper_grains,
}
