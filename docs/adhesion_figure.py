# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw restitution versus speed, and pull-off force versus largest load, of laws with adhesion.

.venv/bin/python docs/adhesion_figure.py     # the tables of docs/adhesion.md; some seconds
"""

from __future__ import annotations

from math import pi

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from plastigran import laws
from plastigran.physics.adhesion import plastic_pull_off_force, sticking_speed
from plastigran.plot.style import law_colour, styled, subplots

#: Sphere of ammonium fluorescein on silicon (Pasha et al. 2014, Granular Matter 16:151).
POWDER = laws.combine(laws.Body(1.2e9, 0.3, 35.3e6 / 1.6, 1.6), laws.Body(182e9, 0.3))
POWDER_RADIUS, POWDER_DENSITY = 2.45e-6, 1350.0
POWDER_MASS = 4 / 3 * pi * POWDER_RADIUS**3 * POWDER_DENSITY
SURFACE_ENERGIES = (0.02, 0.1, 0.2)  # J/m2
SPEEDS = np.geomspace(0.1, 20, 20)  # m/s
#: Steel sphere on a rigid plane.
STEEL = laws.combine(laws.Body(2.1e11, 0.3, 3e8), laws.Body(1e30, 0.3))
STEEL_RADIUS, STEEL_SURFACE_ENERGY = 1e-5, 0.5
OVERLAPS = np.geomspace(5e-4, 0.05, 30)  # divided by the radius


def adhesive(law: str, pair: laws.MaterialPair, surface_energy: float) -> laws.Law:
    """Return a law with adhesion."""
    return laws.ADHESIVE_LAWS.get(law, laws.LAWS[law])(pair, surface_energy=surface_energy)


def impacts() -> pd.DataFrame:
    """Return restitution and sticking speed [m/s] of powder by law, surface energy and speed."""
    rows = []
    for gamma in SURFACE_ENERGIES:
        for name in ("thornton_ning_1998", "thornton", "universal"):
            law = adhesive(name, POWDER, gamma)
            impact = law.central_impact(POWDER_RADIUS, POWDER_MASS, SPEEDS)
            sticking = sticking_speed(law, POWDER_RADIUS, POWDER_MASS)
            rows.append(
                pd.DataFrame(
                    {
                        "law": name,
                        "surface_energy": gamma,
                        "speed": SPEEDS,
                        "restitution": impact.coefficient_of_restitution,
                        "sticking_speed": sticking,
                    }
                )
            )
    return pd.concat(rows, ignore_index=True)


def pull_off() -> pd.DataFrame:
    """Return load and pull-off force [N] of steel, by law and overlap.

    The column `reference` has the pull-off force of a fully plastic contact with the same pressure
    and contact radius at the largest load.
    """
    modulus = STEEL.youngs_modulus_eff
    rows = []
    for name in ("thornton", "universal"):
        law = adhesive(name, STEEL, STEEL_SURFACE_ENERGY)
        for overlap in OVERLAPS * STEEL_RADIUS:
            state = law.State()
            response = law.respond(STEEL_RADIUS, overlap, state)
            radius = response.contact_radius
            tension = np.sqrt(8 * pi * modulus * STEEL_SURFACE_ENERGY * radius**3)
            pressure = (response.force + tension) / (pi * radius**2)
            reference = plastic_pull_off_force(STEEL_SURFACE_ENERGY, modulus, pressure, radius)
            force = law.pull_off_force(STEEL_RADIUS, overlap, state)
            rows.append((name, overlap / STEEL_RADIUS, response.force, force, reference))
    return pd.DataFrame(rows, columns=["law", "overlap", "load", "pull_off_force", "reference"])


@styled()
def adhesion_figure() -> Figure:
    """Draw restitution versus impact speed, and pull-off force versus the largest load."""
    figure, (left, right) = subplots(1, 2, figsize=(8.6, 3.6))
    styles = {"thornton_ning_1998": ("black", "-"), "thornton": (law_colour("thornton"), "--")}
    styles["universal"] = law_colour("universal"), ":"
    for (name, gamma), rows in impacts().groupby(["law", "surface_energy"]):
        colour, line = styles[name]
        label = name if name == "thornton_ning_1998" else f"{name} adhesion jkr"
        first = gamma == SURFACE_ENERGIES[0]
        left.semilogx(rows["speed"], rows["restitution"], line, color=colour,
                      label=label if first else None)  # fmt: skip
    left.set_xlabel("impact speed (m/s)")
    left.set_ylabel("coefficient of restitution")
    left.set_ylim(0, 1)
    left.legend(fontsize=8, loc="lower right")
    forces = pull_off()
    elastic = 1.5 * pi * STEEL_SURFACE_ENERGY * STEEL_RADIUS
    for name, rows in forces.groupby("law"):
        right.loglog(rows["load"], rows["pull_off_force"] / elastic, color=styles[name][0],
                     label=f"{name} adhesion jkr")  # fmt: skip
    rows = forces[forces["law"] == "universal"]
    right.loglog(rows["load"], rows["reference"] / elastic, "k--", label="full plasticity")
    ticks = [1, 2, 5, 10, 20]
    right.set_yticks(ticks, [str(tick) for tick in ticks])
    right.yaxis.set_minor_formatter(NullFormatter())
    right.set_xlabel("largest load (N)")
    right.set_ylabel("pull-off force / JKR pull-off force")
    right.legend(fontsize=8)
    return figure


def main() -> None:
    """Print the tables of docs/adhesion.md."""
    table = impacts()
    print(table.pivot_table("sticking_speed", "surface_energy", "law").to_string())
    rows = table.pivot_table("restitution", ["surface_energy", "speed"], "law")
    rows = rows[rows["thornton_ning_1998"] > 0]
    difference = rows["thornton"] / rows["thornton_ning_1998"] - 1
    print(difference.groupby("surface_energy").agg(["min", "max"]).to_string())
    forces = pull_off()
    forces["ratio"] = forces["pull_off_force"] / forces["reference"]
    print(forces.iloc[::5].to_string())


if __name__ == "__main__":
    main()
