# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw the figures of the docs: one per law, found and never listed, and the README's, the rod's,
the cylinder study's, the bulk decks' and of calibration.

Run it with `./run figures`; the files in docs/figures are its output.
"""

from __future__ import annotations

import sys
import tempfile
from itertools import pairwise
from pathlib import Path

import numpy as np
from attrs import evolve
from matplotlib.figure import Figure
from scipy.integrate import solve_ivp

from plastigran import laws
from plastigran.bulk.decks.compaction.figure import compaction_figure
from plastigran.bulk.decks.cooling_gas.figure import cooling_figure
from plastigran.bulk.decks.hopper import orifices
from plastigran.bulk.decks.hopper.figure import orifices_figure
from plastigran.bulk.run import BulkRun, run_bulk
from plastigran.calibration import DropTest, calibrate
from plastigran.calibration.figures import figure as calibration_figure
from plastigran.experiments import find_experiments
from plastigran.materials import RIGID, read_material
from plastigran.physics import central
from plastigran.plot.snapshot import draw, find_frames
from plastigran.plot.style import COLOURS, save, styled, subplots, title

FOLDER = Path(__file__).parent / "figures"
RADIUS = 0.01  # the figures are dimensionless; any size gives the same


def sphere_law(name: str):
    """A law for the paper's sphere, its elastic limit, and force and overlap at yield."""
    pair = laws.combine(read_material("aluminium_zv02").body(), RIGID)
    overlap_y = RADIUS * laws.yield_radius_ratio(pair) ** 2
    force_y = 4 / 3 * pair.youngs_modulus_eff * np.sqrt(RADIUS) * overlap_y**1.5
    yield_speed = central.yield_speed(pair, RADIUS, 1.0)
    return laws.LAWS[name](pair), laws.Hertz(pair), force_y, overlap_y, yield_speed


def cylinder_law(name: str):
    """The same for a cylinder ten radii long on a body ten radii thick."""
    glass = read_material("glass_kp10")
    pair, strong = (
        laws.combine(body.body(), RIGID) for body in (glass, evolve(glass, yield_strength=1e20))
    )
    lengths = {"cylinder_length": 10 * RADIUS, "body_thickness": 10 * RADIUS}
    law, elastic = (laws.LAWS[name](bodies, **lengths) for bodies in (pair, strong))
    force_y, overlap_y, work_y = central.line_yield(pair, RADIUS, *lengths.values())
    return law, elastic, force_y, overlap_y, np.sqrt(2 * work_y)


def law_figure(name: str) -> Figure:
    """A load, partial unload, reload, unload path, and restitution over impact speed."""
    setting = {"sphere": sphere_law, "cylinder": cylinder_law}[laws.LAWS[name].shape]
    law, unyielding, force_y, overlap_y, yield_speed = setting(name)
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(8.2, 3.4))
        turns = [0, 12, 9, 20, 0]
        path = np.concatenate([np.linspace(a, b, 400) for a, b in pairwise(turns)])
        force = law.follow(RADIUS, path * overlap_y, law.State())["force"] / force_y
        if name != "hertz":
            x = np.linspace(0, 8, 100)
            elastic = unyielding.follow(RADIUS, x * overlap_y, unyielding.State())["force"]
            left.plot(x, elastic / force_y, ":", color="0.5", label="elastic")
        left.plot(path, force, color=COLOURS[0], label=title(name))
        left.set_xlabel("overlap / overlap at yield")
        left.set_ylabel("force / force at yield")
        left.legend(loc="upper left")
        ratio = np.geomspace(0.3, 120, 120)
        restitution = law.central_impact(
            RADIUS, 1.0, ratio * yield_speed
        ).coefficient_of_restitution
        right.semilogx(ratio, restitution, color=COLOURS[0])
        right.set_ylim(0, 1.05)
        right.set_xlabel("impact speed / yield speed")
        right.set_ylabel("coefficient of restitution")
    return figure


def viscoelastic_figure() -> Figure:
    """Impacts of one speed at three dissipative constants, and restitution over impact speed."""
    ice, speed = read_material("ice"), 0.01
    pair = laws.combine(ice.body(), RIGID)
    mass = 4 / 3 * np.pi * RADIUS**3 * ice.density
    bodies = RADIUS, mass, pair.youngs_modulus_eff
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(8.2, 3.4))
        overlap_max = central.hertz_overlap_max(*bodies, speed)
        force_max = central.hertz_force_max(*bodies, speed)
        for number, colour in zip((0, 0.3, 0.6, 1.0), ["0.5", *COLOURS], strict=False):
            unit = central.viscoelastic_number(1.0, *bodies, speed)
            law = laws.ViscoelasticHertz(pair, dissipative_constant=(number / unit) ** 2)

            def motion(_, y, law=law):
                force = law.respond(RADIUS, y[0], law.State(), y[1]).force
                return [y[1], -force / mass]

            moments = np.linspace(0, 3.3 * overlap_max / speed, 2000)
            span = (0, moments[-1])
            course = solve_ivp(
                motion, span, [0, speed], t_eval=moments, rtol=1e-8, atol=1e-6 * overlap_max
            )
            force = law.follow(RADIUS, course.y[0].copy(), law.State(), course.y[1].copy())["force"]
            label = f"$v^*$ = {number:g}" if number else "Hertz"
            touching = course.y[0] >= 0
            left.plot(
                course.y[0][touching] / overlap_max,
                force[touching] / force_max,
                ":" if number == 0 else "-",
                color=colour,
                label=label,
            )
        left.set_xlabel("overlap / largest of Hertz")
        left.set_ylabel("force / largest of Hertz")
        left.legend(loc="upper left")
        speeds = np.geomspace(1e-5, 1, 60)
        for radius, colour in zip((1e-3, 1e-2, 1e-1), COLOURS, strict=False):
            mass_eff = 4 / 3 * np.pi * radius**3 * ice.density
            law = laws.ViscoelasticHertz(pair, dissipative_constant=2e-6)
            right.semilogx(
                speeds,
                law.central_impact(radius, mass_eff, speeds).coefficient_of_restitution,
                color=colour,
                label=f"R = {1e3 * radius:g} mm",
            )
            number = central.viscoelastic_number(
                2e-6, radius, mass_eff, pair.youngs_modulus_eff, speeds
            )
            pade = central.viscoelastic_restitution(number)
            right.plot(speeds[::6], pade[::6], "o", color=colour, mfc="white", ms=4)
        right.plot([], [], "o", color="0.4", mfc="white", ms=4, label="Padé form")
        right.set_ylim(0, 1.05)
        right.set_xlabel("impact speed (m/s)")
        right.set_ylabel("coefficient of restitution")
        right.legend(loc="lower left", title="ice's moduli, A = 2 µs")
    return figure


# Laws whose page needs another figure than a path of overlaps.
OWN_FIGURES = {"viscoelastic_hertz": viscoelastic_figure}


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
        figure = OWN_FIGURES[name]() if name in OWN_FIGURES else law_figure(name)
        save(figure, FOLDER / name, (".svg",))


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
