# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the restitution of laws of this project and of other codes with finite elements.

Pairs of equal spheres of one metal collide head-on in each host, one pair per speed. By symmetry,
each sphere behaves as on a rigid plane, as in plastigran.validation.spheres. `hooke/hysteresis` has
no material parameters. The plastic unloading of this model is fitted to the restitution of the
finite elements at v/v_Y = 100.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.lammps import run_lammps
from plastigran.engine.process import PROJECT, run_deck
from plastigran.physics.central import yield_speed
from plastigran.plot.style import MARKERS, law_colour, law_number, save, styled, subplots
from plastigran.validation.spheres import table
from plastigran.validation.spheres.metals import METALS

DECKS = Path(__file__).resolve().parent / "peers"
FIGURE = PROJECT / "docs" / "figures" / "peers.svg"
METAL = METALS["s0.0012-nu0.3-perfect"]
SPEED_RATIOS = np.geomspace(1.2, 500, 24)  # impact speeds / yield speed
#: Duration of the fastest impact if it were elastic, divided by the time step.
IMPACT_STEPS = 4000
#: Speed ratio v/v_Y at which hooke/hysteresis is fitted, and largest ratio of unloading to loading
#: stiffness of this law.
AGREES, STIFFEST = 100.0, 5.0
MATERIALS = {"LAMMPS mdr": "mdr {modulus} {nu} {strength} 0 0.5 0 tangential mindlin NULL 1 0.3 "
             "damping mdr 1"}  # fmt: skip
OTHERS = ("hooke/hysteresis", "thornton_ning", "LAMMPS mdr")
OURS = ("thornton", "vu_quoc_zhang", "kogut_etsion", "universal")


class Spheres:
    """Pairs of spheres; `speed_y` is the speed of each sphere at first yield [m/s]."""

    def __init__(self) -> None:
        material = METAL.material
        self.modulus, self.nu = material.youngs_modulus, material.poissons_ratio
        self.strength = METAL.yield_strength_ratio * self.modulus / (1 - self.nu**2)
        self.radius, self.density = 0.01, material.density
        self.mass = 4 / 3 * np.pi * self.radius**3 * self.density
        body = laws.Body(
            youngs_modulus=self.modulus, poissons_ratio=self.nu, yield_strength=self.strength
        )
        self.pair = laws.combine(body, body)
        self.speed_y = yield_speed(self.pair, self.radius / 2, self.mass / 2) / 2
        self.speeds = self.speed_y * SPEED_RATIOS

    def elastic_time(self, speed: float) -> float:
        """Return the duration of an elastic impact at a given speed of each sphere [s].

        The duration is 2.94 times the largest overlap divided by the closing speed.
        """
        scale = 15 / 16 * (self.mass / 2) * (2 * speed) ** 2
        overlap = (scale / (self.pair.youngs_modulus_eff * (self.radius / 2) ** 0.5)) ** 0.4
        return 2.94 * overlap / (2 * speed)

    def write(self, file: Path) -> None:
        """Write a data file for both hosts: pairs of touching spheres, side by side along x."""
        count, apart = len(self.speeds), 4 * self.radius
        lines = ["pairs of spheres\n", f"{2 * count} atoms", "2 atom types\n"]
        lines += [f"{-apart:.9g} {apart * count:.9g} xlo xhi"]
        lines += [f"{-apart:.9g} {apart:.9g} {axis}lo {axis}hi" for axis in "yz"]
        atoms, velocities = [], []
        for k, speed in enumerate(self.speeds):
            for number, side in ((2 * k + 1, 1), (2 * k + 2, -1)):
                size = f"{2 * self.radius:.9g} {self.density:.9g}"
                atoms += [f"{number} 1 {size} {apart * k:.9g} 0 {side * self.radius:.9g}"]
                velocities += [f"{number} 0 0 {-side * speed:.17g} 0 0 0"]
        parts = [*lines, "\nAtoms\n", *atoms, "\nVelocities\n", *velocities, ""]
        file.write_text("\n".join(parts))

    def hysteresis(self, folder: Path) -> Path:
        """Write a deck with the fitted constants of hooke/hysteresis; return its path."""
        speed = 2 * AGREES * self.speed_y
        radius, mass, modulus = self.radius / 2, self.mass / 2, self.pair.youngs_modulus_eff
        scale = radius**0.5 * modulus
        stiffness = 16 / 15 * scale * (15 / 16 * mass * speed**2 / scale) ** 0.2
        overlap = speed * (mass / stiffness) ** 0.5
        reference = finite_elements()
        restitution = np.interp(AGREES, reference["speed_ratio"], reference["restitution"])
        # `limit` is the overlap at which the stiffness ratio reaches STIFFEST.
        limit = overlap * (STIFFEST - 1) / (1 / restitution**2 - 1)
        depth = limit * (STIFFEST - 1) / STIFFEST / (2 * radius)
        values = {
            "characteristicVelocity scalar": speed,
            "coefficientMaxElasticStiffness peratomtypepair 2": STIFFEST,
            "coefficientAdhesionStiffness peratomtypepair 2": 0.0,
            "coefficientPlasticityDepth peratomtypepair 2": depth,
        }
        deck = folder / "hysteresis.in"
        deck.write_text(
            "".join(
                f"fix hysteresis_{k} all property/global {name} "
                f"{' '.join([repr(float(value))] * (4 if '2' in name else 1))}\n"
                for k, (name, value) in enumerate(values.items())
            )
        )
        return deck


def finite_elements() -> pd.DataFrame:
    """Return the restitution of METAL by finite elements: columns speed_ratio and restitution."""
    rows = table().query("metal == @METAL.name")
    return rows.rename(columns={"coefficient_of_restitution": "restitution"})[
        ["speed_ratio", "restitution"]
    ]


def restitution(folder: Path, names: Iterable[str] = (*OTHERS, *OURS)) -> pd.DataFrame:
    """Run the impacts of the pairs of spheres with every law.

    Args:
        folder: Folder of the files of the hosts.
        names: Names of the laws.

    Returns:
        Columns law, speed_ratio and restitution. The finite elements have the law
        `finite elements`.
    """
    spheres = Spheres()
    folder.mkdir(parents=True, exist_ok=True)
    spheres.write(folder / "pairs.data")
    timestep = spheres.elastic_time(spheres.speeds[-1]) / IMPACT_STEPS
    variables: dict[str, object] = {
        "pairs": folder / "pairs.data",
        "skin": spheres.radius / 10,
        "timestep": timestep,
        "steps": int(1.5 * spheres.elastic_time(spheres.speeds[0]) / timestep),
    }
    metal = {
        "youngs_modulus": spheres.modulus,
        "poissons_ratio": spheres.nu,
        "yield_strength": spheres.strength,
    }
    properties = {
        "hooke/hysteresis": spheres.hysteresis(folder),
        "thornton_ning": DECKS / "thornton_ning.in",
    }
    parts = [finite_elements().assign(law="finite elements")]
    for law in names:
        if law in MATERIALS:
            material = MATERIALS[law].format(
                modulus=spheres.modulus, nu=spheres.nu, strength=spheres.strength
            )
            run_lammps(DECKS / "throws.lammps", variables | {"material": material}, folder)
        else:
            case = variables | metal | {"law": law}
            if law in properties:
                case |= {"properties": properties[law], "yield_pressure_factor": 1.6}
            run_deck(DECKS / "throws.in", case, folder)
        dump = read_dump(folder / "speeds.dump").query("step > 0").sort_values("id")
        after = dump["vz"].to_numpy()[::2]
        parts.append(
            pd.DataFrame(
                {"law": law, "speed_ratio": SPEED_RATIOS, "restitution": after / spheres.speeds}
            )
        )
    return pd.concat(parts, ignore_index=True)


@styled()
def draw(restitutions: pd.DataFrame, target: Path = FIGURE) -> None:
    """Draw restitution versus speed of all laws and of the finite elements."""
    figure, axes = subplots(figsize=(7, 4.5))
    for law, rows in restitutions.groupby("law", sort=False):
        if law == "finite elements":
            style = {"color": "black", "linewidth": 0, "marker": "o", "markersize": 7}
        elif law in OTHERS:
            dashes, marker = (("--", "+"), (":", "x"), ("-.", "s"))[OTHERS.index(law)]
            style = {"color": law_colour(law), "ls": dashes, "lw": 1, "marker": marker, "ms": 4}
        else:
            marker = MARKERS[law_number(law)]
            style = {"color": law_colour(law), "ls": "-", "lw": 1, "marker": marker, "ms": 3}
        axes.plot(rows["speed_ratio"], rows["restitution"], label=law, **style)
    axes.set(xscale="log", xlabel="$v/v_Y$", ylim=(0, 1.02))
    axes.set_ylabel("coefficient of restitution")
    axes.legend(ncols=2, fontsize=9)
    save(figure, target, (target.suffix,))
