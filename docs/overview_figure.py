# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw the first figure of README and docs: computed and measured restitution versus speed."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from plastigran import laws
from plastigran.calibration.hardness import flow_stress, leeb_table
from plastigran.physics.central import yield_speed
from plastigran.physics.rebound_hardness import TESTERS
from plastigran.plot.style import law_colour, styled, subplots
from plastigran.validation.spheres import table
from plastigran.validation.spheres.metals import METALS
from plastigran.validation.steel import speed_ratio

#: Perfectly plastic metal of the finite elements, which the fit of `universal` did not use.
METAL = "s0.0008-nu0.35-perfect"
#: Example of a restitution that a deck prescribes for LIGGGHTS' own `hertz`.
TYPED_RESTITUTION = 0.6


def finite_elements() -> tuple[laws.MaterialPair, np.ndarray, np.ndarray]:
    """Return the pair of metal and rigid plane, v/v_Y, and restitution by finite elements."""
    rows = table()
    rows = rows[rows["metal"] == METAL]
    return (
        METALS[METAL].pair,
        rows["speed_ratio"].to_numpy(),
        rows["coefficient_of_restitution"].to_numpy(),
    )


def measured_steel() -> tuple[np.ndarray, np.ndarray]:
    """Return v/v_Y and the restitution that Leeb testers measured on steel of known hardness."""
    readings = leeb_table()
    ratio = [speed_ratio(TESTERS["D"], strength) for strength in flow_stress(readings["HV"])]
    return np.array(ratio), readings["HLD"].to_numpy() / 1000


def restitution(law: str, pair: laws.MaterialPair, ratio: np.ndarray) -> np.ndarray:
    """Return the restitution of a law at speeds `ratio` times the yield speed."""
    radius, mass = 1.0, 1.0  # restitution depends on v/v_Y alone
    speed = ratio * yield_speed(pair, radius, mass)
    return laws.LAWS[law](pair).central_impact(radius, mass, speed).coefficient_of_restitution


@styled()
def overview_figure() -> Figure:
    """Draw finite elements, measurements, `universal`, `thornton` and a prescribed restitution."""
    pair, computed_ratio, computed = finite_elements()
    measured_ratio, measured = measured_steel()
    ratio = np.geomspace(0.3, measured_ratio.max(), 200)
    figure, axes = subplots(figsize=(7.2, 3.8))
    axes.axhline(TYPED_RESTITUTION, color="0.5", linestyle="--")
    axes.plot(ratio, restitution("thornton", pair, ratio), color=law_colour("thornton"))
    axes.plot(ratio, restitution("universal", pair, ratio), color=law_colour("universal"), lw=2)
    axes.plot(measured_ratio, measured, "o", color="0.55", markersize=4, markerfacecolor="none")
    axes.plot(computed_ratio, computed, "s", color="black", markersize=4.5)
    axes.set_xscale("log")
    axes.set_xlim(ratio[0], ratio[-1])
    axes.set_ylim(0, 1.05)
    axes.set_xlabel("impact speed / yield speed of the contact")
    axes.set_ylabel("coefficient of restitution")
    for x, y, text, colour in (
        (0.35, TYPED_RESTITUTION - 0.02, f"hertz: {TYPED_RESTITUTION:g}, prescribed", "0.4"),
        (10, 0.45, "thornton", law_colour("thornton")),
        (18, 0.88, "measured on steel", "0.45"),
        (2.8, 1.01, "finite elements", "black"),
        (50, 0.52, "universal", law_colour("universal")),
    ):
        axes.text(x, y, text, color=colour, va="top")
    return figure
