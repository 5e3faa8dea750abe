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
from plastigran.fem.sphere.results import Pressing
from plastigran.materials import RIGID
from plastigran.plot.style import COLOURS, styled, subplots, title


def figure(metal: CalibratedMetal, progress: bool = False) -> Figure:
    """Draw the law and the data of its calibration: drops, or else finite elements.

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
    raise ValueError("there is nothing to draw without a drop test or finite elements")


def drops_figure(metal: CalibratedMetal) -> Figure:
    """Draw measured restitution over impact speed, with the law and its 95 % band."""
    drops = metal.drops
    speeds = np.geomspace(drops.speed.min() / 2, drops.speed.max() * 2, 60)

    def law(strength: float) -> np.ndarray:
        if strength == inf:
            return np.ones_like(speeds)
        body = attrs.evolve(metal.material, yield_strength=strength)
        impact = drops.contact(metal.law, body).impact(speeds)
        return impact.coefficient_of_restitution

    with styled():
        drawn, axes = subplots(figsize=(6, 4))
        least, largest = metal.yield_strength_interval
        axes.fill_between(speeds, law(least), law(largest), color=COLOURS[0], alpha=0.2, lw=0)
        label = f"{title(metal.law)}, {metal.yield_strength / 1e6:.4g} MPa"
        axes.plot(speeds, law(metal.yield_strength), color=COLOURS[0], label=label)
        axes.plot(drops.speed, drops.restitution, "o", color="black", mfc="white", label="drops")
        axes.plot([], [], color=COLOURS[0], alpha=0.2, lw=8, label="95 % interval of the strength")
        _restitution_axes(axes)
    return drawn


def finite_elements_figure(metal: CalibratedMetal, progress: bool = False) -> Figure:
    """Draw the law, and `vu_quoc_zhang` with fitted constants, with finite elements.

    The panels are force over approach, contact radius over force, and restitution over impact
    speed.
    """
    pressing = metal.pressed.pressing
    released = metal.pressed.unloadings(progress)
    contacts = {
        name: Contact(name, metal.material, RIGID, radius=pressing.radius, **constants)
        for name, constants in {metal.law: {}, "vu_quoc_zhang": metal.constants}.items()
    }
    if metal.law == "vu_quoc_zhang":
        contacts = {metal.law: contacts[metal.law]}
    with styled():
        drawn, (loop, radius, restitution) = subplots(1, 3, figsize=(12, 4))
        for (name, contact), colour in zip(contacts.items(), COLOURS, strict=False):
            path = _path(contact, pressing)
            loop.plot(path["overlap"] * 1e6, path["force"], color=colour)
            up = path.iloc[: path["force"].to_numpy().argmax() + 1]
            radius.plot(up["force"], up["contact_radius"] * 1e3, color=colour)
            speeds = np.geomspace(released["speed"].min() / 3, released["speed"].max(), 40)
            restitution.plot(
                speeds,
                contact.impact(speeds).coefficient_of_restitution,
                color=colour,
                label=title(name) + (", fitted" if name == "vu_quoc_zhang" else ""),
            )
        history, points = pressing.history, {"color": "black", "mfc": "white", "ms": 4}
        loop.plot(history["approach"] * 1e6, history["force"], "o", **points)
        loading = history[history["branch"] == 0]
        radius.plot(loading["force"], loading["contact_radius"] * 1e3, "o", **points)
        restitution.plot(
            released["speed"], released["coefficient_of_restitution"], "o", **points,
            label="finite elements",
        )  # fmt: skip
        loop.set(xlabel="overlap (µm)", ylabel="force (N)")
        radius.set(xlabel="force (N)", ylabel="contact radius (mm)")
        _restitution_axes(restitution)
    return drawn


def _path(contact: Contact, pressing: Pressing) -> pd.DataFrame:
    """Return the law along the path of the finite elements: loading and unloading."""
    reached = pressing.history["force"].max()
    high = 2 * pressing.history["approach"].max()
    trial = contact.law.follow(contact.radius_eff, np.linspace(0, high, 2000))
    top = np.interp(reached, trial["force"], np.linspace(0, high, 2000))
    up = np.linspace(0, top, 200)
    there_and_back = np.concatenate([up, up[-2::-1]])
    answer = contact.law.follow(contact.radius_eff, there_and_back)
    found = pd.DataFrame({name: answer[name] for name in ("force", "contact_radius")})
    found.insert(0, "overlap", there_and_back)
    touching = (found["force"] > 0) | (found.index <= len(up))
    return found[touching]


def _restitution_axes(axes: Axes) -> None:
    axes.set(xscale="log", xlabel="impact speed (m/s)", ylabel="coefficient of restitution")
    axes.set_ylim(0, 1.05)
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter("")
    axes.legend(fontsize="small", loc="lower left")
