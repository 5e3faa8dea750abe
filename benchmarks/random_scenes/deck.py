# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the decks of a scene: a first deck, and one deck for each restart."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
from events import AXES, CREATED_RADIUS, Event
from frames import COLUMNS
from scene import Scene

from plastigran.laws import hertz_yield_pressure_factor

#: Particles whose distance from a random place is below this radius are deleted [m].
NEAR = 0.13
# Variables that Plastigran sets in every deck.
_VARIABLES = ("variable inputs index inputs", "variable output index .")
MESH_CELLS = 3  # number of cells of the meshed wall along each side


def write_decks(scene: Scene, folder: Path) -> list[tuple[Path, tuple[int, int, int]]]:
    """Write the decks, and the mesh of the wall.

    Returns:
        Each deck with its numbers of ranks along x, y and z, in the order of the runs.
    """
    if scene.meshed:
        (folder / "floor.stl").write_text(_plane(scene))
    decks: list[tuple[list[str], tuple[int, int, int]]] = [
        (list(_begin(scene)), scene.events[0].grid)
    ]
    for number, event in enumerate(scene.events):
        if event.action.startswith("restart"):
            decks[-1][0].append("write_restart middle.restart")
            decks.append((list(_again(scene, event)), event.grid))
        else:
            decks[-1][0].extend(_do(scene, event))
        decks[-1][0].extend(_run(scene, event, number))
    written = []
    for number, (lines, grid) in enumerate(decks):
        path = folder / f"part_{number}.in"
        path.write_text("\n".join(lines) + "\n")
        written.append((path, grid))
    return written


def _style(scene: Scene) -> tuple[str, str]:
    words = " ".join(f"{n} {w}" for n, w in scene.options.items() if isinstance(w, str))
    return f"model {scene.law_name} tangential off", f"energy_ledger on {words}"


def _pair_style(scene: Scene) -> Iterator[str]:
    yield f"pair_style gran {' '.join(_style(scene))}"
    yield "pair_coeff * *"


def _head(scene: Scene, grid: tuple[int, int, int]) -> Iterator[str]:
    yield from _VARIABLES
    yield "units si"
    yield "atom_style granular"
    yield "atom_modify map array"
    yield f"atom_modify sort {scene.sort} 0.2"
    yield "boundary " + " ".join("f" if axis in scene.walled else "p" for axis in AXES)
    yield "newton off"
    yield f"processors {grid[0]} {grid[1]} {grid[2]}"


def _begin(scene: Scene) -> Iterator[str]:
    yield from _head(scene, scene.events[0].grid)
    sides = np.column_stack([scene.low, scene.high]).ravel()
    yield f"region box block {_words(sides)} units box"
    yield f"create_box {len(scene.bodies)} box"
    yield "communicate single vel yes"
    yield "neighbor 0.02 bin"
    yield "neigh_modify delay 0"
    particles = zip(scene.types, scene.positions, scene.radius, scene.velocities, strict=True)
    for number, (atom_type, place, radius, velocity) in enumerate(particles, 1):
        yield f"create_atoms {atom_type} single {_words(place)} units box"
        density = scene.densities[atom_type - 1]
        moving = " ".join(f"v{axis} {v:.17g}" for axis, v in zip(AXES, velocity, strict=True))
        yield f"set atom {number} diameter {2 * radius:.17g} density {density:.17g} {moving}"
    yield from _properties(scene)
    yield from _pair_style(scene)
    yield from _surroundings(scene)
    yield from _thermo()


def _again(scene: Scene, event: Event) -> Iterator[str]:
    yield from _VARIABLES
    yield "newton off"
    yield f"processors {event.grid[0]} {event.grid[1]} {event.grid[2]}"
    yield "atom_modify map array"
    yield "read_restart middle.restart"
    yield "communicate single vel yes"
    yield "neighbor 0.02 bin"
    yield "neigh_modify delay 0"
    yield from _properties(scene)
    if event.action == "restart with its line":
        yield from _pair_style(scene)
    yield from _surroundings(scene)
    if event.action == "restart":
        yield "run 0"  # reads the energy balance from the restart file
    yield from _thermo()


def _properties(scene: Scene) -> Iterator[str]:
    # LIGGGHTS stops if no particle and no template has atom type 1. A scene may delete all
    # particles of this type, so this template has type 1.
    yield (
        "fix first all particletemplate/sphere 15485863 atom_type 1 density constant 1000 "
        "radius constant 0.05"
    )
    yield "fix kinds all particledistribution/discrete 49979687 1 first 1"
    fields = {
        "youngsModulus": "youngs_modulus",
        "poissonsRatio": "poissons_ratio",
        "yieldStrength": "yield_strength",
        "yieldPressureFactor": "yield_pressure_factor",
        "tangentModulus": "tangent_modulus",
        "rateCoefficient": "rate_coefficient",
        "referenceRate": "reference_rate",
    }
    for name, attribute in fields.items():
        values = [getattr(body, attribute) for body in scene.bodies]
        if not np.isfinite(values).all():
            continue
        if name == "yieldPressureFactor":
            values = [
                v or hertz_yield_pressure_factor(body.poissons_ratio)
                for v, body in zip(values, scene.bodies, strict=True)
            ]
        yield f"fix {name} all property/global {name} peratomtype {_words(values)}"
    count = len(scene.bodies)
    for name, value in scene.options.items():
        if not isinstance(value, str):
            head, *tail = name.split("_")
            camel = head + "".join(word.capitalize() for word in tail)
            yield (
                f"fix {camel} all property/global {camel} peratomtypepair {count} "
                + " ".join([f"{value:.17g}"] * count**2)
            )


def _surroundings(scene: Scene) -> Iterator[str]:
    model, rest = _style(scene)
    for axis in scene.walled:
        for name, corner in (("low", scene.low), ("high", scene.high)):
            place = corner[AXES.index(axis)]
            surface = f"primitive type {scene.wall_type} {axis}plane {place:.17g}"
            if scene.meshed and axis == "z" and name == "low":
                yield f"fix floor all mesh/surface file floor.stl type {scene.wall_type}"
                surface = "mesh n_meshes 1 meshes floor"
            yield f"fix {axis}_{name} all wall/gran {model} {surface} {rest}"
    yield "fix integrate all nve/sphere"
    yield f"timestep {scene.timestep:.17g}"


def _thermo() -> Iterator[str]:
    yield "thermo_style custom step ke f_energy_ledger[3] f_energy_ledger[4] f_energy_ledger[9]"
    yield "thermo_modify norm no lost error format float %.17g"
    yield "thermo 1000000"


def _do(scene: Scene, event: Event) -> Iterator[str]:
    if "delete" in event.action:
        yield f"region gone sphere {_words(event.where[0])} {NEAR} units box"
        yield "group gone region gone"
        yield f"delete_atoms group gone compress {event.compress}"
        yield "group gone delete"
        yield "region gone delete"
    if "create" in event.action:
        yield f"create_atoms 1 single {_words(event.where[1])} units box"
        yield f"region new sphere {_words(event.where[1])} 1e-6 units box"
        yield "group new region new"
        yield (
            f"set group new diameter {2 * CREATED_RADIUS} density {scene.densities[0]:.17g} "
            "vx 0.1 vy 0 vz 0"
        )
        yield "group new delete"
        yield "region new delete"
    if event.action == "displace":
        yield f"displace_atoms all move {_words(event.shift)} units box"
    if event.action == "reset steps":
        yield "reset_timestep 5000000"
    if event.action == "pair_style again":
        yield from _pair_style(scene)


def _run(scene: Scene, event: Event, number: int) -> Iterator[str]:
    yield f"dump frames all custom 1 run_{number}.dump {COLUMNS}"
    yield 'dump_modify frames first yes sort id format "%d %d' + " %.17g" * 11 + '"'
    yield f"run {event.steps}"
    yield "undump frames"


def _words(values) -> str:
    return " ".join(f"{value:.17g}" for value in values)


def _plane(scene: Scene) -> str:
    """Return the text of an STL file with the lower z wall."""
    edges = np.linspace(scene.low, scene.high, MESH_CELLS + 1)
    lines = ["solid floor"]
    for x, x_next in pairwise(edges[:, 0]):
        for y, y_next in pairwise(edges[:, 1]):
            for corners in (
                ((x, y), (x_next, y), (x_next, y_next)),
                ((x, y), (x_next, y_next), (x, y_next)),
            ):
                lines += ["facet normal 0 0 1", "outer loop"]
                lines += [f"vertex {a:.17g} {b:.17g} {scene.low[2]:.17g}" for a, b in corners]
                lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid floor", ""])
