# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of a calibration: the law compared with drops or finite elements."""

from __future__ import annotations

from math import inf

import attrs
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator

from plastigran.calibration.metal import CalibratedMetal
from plastigran.contact import Contact
from plastigran.materials import RIGID
from plastigran.plot.chart import Curve, Panel
from plastigran.plot.quantities import Scale
from plastigran.plot.static import draw
from plastigran.plot.style import COLOURS, styled, subplots, title

SPEED = Scale("impact speed", "m/s", 1)
RESTITUTION = Scale("coefficient of restitution", "", 1)
OVERLAP, FORCE = Scale("overlap", "µm", 1e6), Scale("force", "N", 1)
CONTACT_RADIUS = Scale("contact radius", "mm", 1e3)


def figure(metal: CalibratedMetal, progress: bool = False) -> Figure:
    """Draw the law and the data of its calibration: drops or, if there are none, finite elements.

    Args:
        metal: Result of `calibrate`.
        progress: Whether to show a bar while further unloadings are computed.

    Raises:
        ValueError: There are neither drops nor finite elements.
    """
    if metal.drops is not None:
        return drops_figure(metal)
    if metal.pressed is not None:
        return finite_elements_figure(metal, progress)
    raise ValueError(
        "the figure shows a drop test or finite elements, but the calibration has neither. Give "
        "drops or force_ratio to calibrate"
    )


def drops_figure(metal: CalibratedMetal) -> Figure:
    """Draw measured restitution versus impact speed, with the law and its 95 % band."""
    drops = metal.drops
    speeds = np.geomspace(drops.speed.min() / 2, drops.speed.max() * 2, 60)

    def restitution(strength: float) -> np.ndarray:
        if strength == inf:
            return np.ones_like(speeds)
        body = attrs.evolve(metal.material, yield_strength=strength)
        return drops.contact(metal.law, body).impact(speeds).coefficient_of_restitution

    law = f"{title(metal.law)}, {metal.yield_strength / 1e6:.4g} MPa"
    curves = [
        Curve(x=speeds, y=restitution(metal.yield_strength), name=law, colour=0),
        Curve(x=drops.speed, y=drops.restitution, name="drops", look="points"),
    ]
    with styled():
        drawn, axes = subplots(figsize=(6, 4))
        band = (restitution(strength) for strength in metal.yield_strength_interval)
        axes.fill_between(speeds, *band, color=COLOURS[0], alpha=0.2, lw=0)
        _draw_restitution(axes, curves)
        axes.plot([], [], color=COLOURS[0], alpha=0.2, lw=8, label="95 % interval of the strength")
        axes.legend(fontsize="small", loc="lower left")
    return drawn


def finite_elements_figure(metal: CalibratedMetal, progress: bool = False) -> Figure:
    """Draw two laws and the finite elements of the calibration.

    The laws are the law of the metal, and `vu_quoc_zhang` with fitted constants. The panels show
    force versus overlap, contact radius versus force, and restitution versus impact speed.
    """
    pressing = metal.pressed.pressing
    unloadings = metal.pressed.unloadings(progress)
    speed = unloadings["speed"]
    constants = {metal.law: {}, "vu_quoc_zhang": metal.constants}
    forces, radii, restitutions = [], [], []
    for k, (law, values) in enumerate(constants.items()):
        contact = Contact(law, metal.material, RIGID, radius=pressing.radius, **values)
        fitted = ", fitted" if law == "vu_quoc_zhang" else ""
        line = {"name": f"{title(law)}{fitted}", "colour": k}
        path = _compress(contact, pressing.history)
        forces.append(Curve(x=path["overlap"], y=path["force"], **line))
        loading = path.iloc[: path["force"].to_numpy().argmax() + 1]
        radii.append(Curve(x=loading["force"], y=loading["contact_radius"], **line))
        speeds = np.geomspace(speed.min() / 3, speed.max(), 40)
        restitution = contact.impact(speeds).coefficient_of_restitution
        restitutions.append(Curve(x=speeds, y=restitution, **line))
    points = {"name": "finite elements", "look": "points"}
    history = pressing.history
    forces.append(Curve(x=history["approach"], y=history["force"], **points))
    loading = history[history["branch"] == 0]
    radii.append(Curve(x=loading["force"], y=loading["contact_radius"], **points))
    restitutions.append(Curve(x=speed, y=unloadings["coefficient_of_restitution"], **points))
    with styled():
        drawn, (left, middle, right) = subplots(1, 3, figsize=(12, 4))
        draw(left, Panel(x=OVERLAP, y=FORCE, curves=forces))
        draw(middle, Panel(x=FORCE, y=CONTACT_RADIUS, curves=radii))
        _draw_restitution(right, restitutions)
        right.legend(fontsize="small", loc="lower left")
    return drawn


def _compress(contact: Contact, history: pd.DataFrame) -> pd.DataFrame:
    """Return the response of the law up to the largest force of the finite elements, and back."""
    trial = np.linspace(0, 2 * history["approach"].max(), 2000)
    forces = contact.law.follow(contact.radius_eff, trial)["force"]
    loading = np.linspace(0, np.interp(history["force"].max(), forces, trial), 200)
    overlaps = np.concatenate([loading, loading[-2::-1]])
    response = contact.law.follow(contact.radius_eff, overlaps)
    path = pd.DataFrame(
        {"overlap": overlaps} | {n: response[n] for n in ("force", "contact_radius")}
    )
    return path[(path["force"] > 0) | (path.index <= len(loading))]


def _draw_restitution(axes: Axes, curves: list[Curve]) -> None:
    draw(axes, Panel(x=SPEED, y=RESTITUTION, curves=curves, logarithmic="x", y_range=(0, 1.05)))
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter("")
