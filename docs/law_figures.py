# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw the figure of a law's page: force versus overlap, and restitution versus speed."""

from __future__ import annotations

from functools import partial
from itertools import pairwise
from pathlib import Path

import numpy as np
from attrs import evolve
from matplotlib.figure import Figure
from scipy.integrate import solve_ivp

from plastigran import laws
from plastigran.materials import RIGID, read_material
from plastigran.physics import central
from plastigran.plot.style import COLOURS, save, styled, subplots, title

RADIUS = 0.01  # m; the figures are dimensionless and do not depend on the radius


def sphere_law(name: str):
    """Return law, elastic law, and force [N], overlap [m] and speed [m/s] at yield, for a sphere.

    The material is the aluminum of Zhang & Vu-Quoc (2002). The speed is for a mass of 1 kg.
    """
    pair = laws.combine(read_material("aluminium_zv02").body(), RIGID)
    overlap_y = RADIUS * laws.yield_radius_ratio(pair) ** 2
    force_y = 4 / 3 * pair.youngs_modulus_eff * np.sqrt(RADIUS) * overlap_y**1.5
    yield_speed = central.yield_speed(pair, RADIUS, 1.0)
    return laws.LAWS[name](pair), laws.Hertz(pair), force_y, overlap_y, yield_speed


def cylinder_law(name: str):
    """Return the values of `sphere_law` for a rigid cylinder on glass.

    The length of the cylinder and the thickness of the glass are ten radii. The speed is for a
    cylinder of 1 kg.
    """
    glass = read_material("glass_kp10")
    pair, strong = (
        laws.combine(body.body(), RIGID) for body in (glass, evolve(glass, yield_strength=1e20))
    )
    lengths = {"cylinder_length": 10 * RADIUS, "body_thickness": 10 * RADIUS}
    law, elastic = (laws.LAWS[name](bodies, **lengths) for bodies in (pair, strong))
    force_y, overlap_y, work_y = central.line_yield(pair, RADIUS, *lengths.values())
    return law, elastic, force_y, overlap_y, np.sqrt(2 * work_y)


def law_figure(name: str) -> Figure:
    """Draw a path of loading, partial unloading, reloading and unloading, and the restitution."""
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
    """Draw impacts at three dissipative constants, and restitution versus impact speed."""
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
        left.set_xlabel("overlap / largest Hertz overlap")
        left.set_ylabel("force / largest Hertz force")
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


def powder_figure(name: str, **constants: float) -> Figure:
    """Draw a contact that is loaded and then pulled apart, and restitution versus impact speed.

    The body is a sphere of 2.45 µm with the constants of ammonium fluorescein, on silicon.
    """
    radius = 2.45e-6
    pair = laws.combine(laws.Body(1.2e9, 0.3, 35.3e6 / 1.6, 1.6), laws.Body(182e9, 0.3))
    law, mass = laws.LAWS[name](pair, **constants), 4 / 3 * np.pi * radius**3 * 1350
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(8.2, 3.4))
        for depth, color in zip((0.004, 0.012), COLOURS, strict=False):
            apart = law.pull_off_distance(radius)
            turns = [1e-12, depth * radius, -1.2 * apart - 2e-4 * radius]
            path = np.concatenate([np.linspace(a, b, 2000) for a, b in pairwise(turns)])
            force = law.follow(radius, path, law.State())["force"]
            left.plot(1e9 * path, 1e6 * force, color=color)
        left.set_xlabel("overlap (nm)")
        left.set_ylabel("force (µN)")
        speed = np.geomspace(0.1, 20, 200)
        restitution = law.central_impact(radius, mass, speed).coefficient_of_restitution
        right.semilogx(speed, restitution, color=COLOURS[0])
        right.set_ylim(0, 1.05)
        right.set_xlabel("impact speed (m/s)")
        right.set_ylabel("coefficient of restitution")
    return figure


# Figures of laws that show more than a path of overlaps.
OWN_FIGURES = {
    "viscoelastic_hertz": viscoelastic_figure,
    "jkr": partial(powder_figure, "jkr", surface_energy=0.2),
    "thornton_ning_1998": partial(powder_figure, "thornton_ning_1998", surface_energy=0.1),
    "walton_braun": partial(
        powder_figure, "walton_braun", loading_stiffness=500, unloading_stiffness=2000
    ),
    "edinburgh_2014": partial(
        powder_figure, "edinburgh_2014", stiffness_ratio=5, adhesion_ratio=0.05
    ),
    "luding_2008": partial(
        powder_figure,
        "luding_2008",
        loading_stiffness=500,
        unloading_stiffness=5000,
        adhesive_stiffness=500,
        plasticity_depth=0.01,
    ),
}


def draw_law(name: str, folder: Path) -> None:
    """Write a law's figure into a folder."""
    figure = OWN_FIGURES[name]() if name in OWN_FIGURES else law_figure(name)
    save(figure, folder / name, (".svg",))
