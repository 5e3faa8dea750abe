# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of the fit of the law `universal`: collapse of the metals, and errors."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.calibration.expected_errors import KINDS
from plastigran.plot.style import COLOURS, save, styled, subplots
from plastigran.validation.spheres.forms import Constants, Metals, depth, errors, peak, work_ratio
from plastigran.validation.spheres.regimes import kind


def write(constants: Constants, rows: pd.DataFrame, folder: Path) -> list[Path]:
    """Draw both figures into a folder and return the files."""
    figures = {
        "universal_fit": collapse_figure(constants, rows),
        "universal_errors": errors_figure(constants, rows),
    }
    return [path for name, made in figures.items() for path in save(made, folder / name, (".svg",))]


def collapse_figure(constants: Constants, rows: pd.DataFrame) -> Figure:
    """Draw force, contact radius and released energy over the depth S, compared with Hertz.

    The Hertz contact has the same overlap, or the same force and radius. Lines are the equations
    for
    small a/R without hardening.
    """
    metals, t = Metals.of(rows), np.sqrt(rows["overlap_ratio"].to_numpy())
    s = depth(constants, metals, t)
    narrow = Metals(np.ones(1), np.zeros(1), np.zeros(1))
    line = np.geomspace(0.05, 1.1 * s.max(), 300)
    form = peak(constants, narrow, 1 + line)
    drawn = (
        ("Hertz' force over force", t**3 / rows["force_ratio"], (1 + line) ** 3 / form.force),
        (
            "contact radius over Hertz'",
            rows["contact_radius_ratio"] / t,
            form.contact_radius / (1 + line),
        ),
        (
            "released energy over Hertz'",
            work_ratio(
                rows["work_unloading_ratio"], rows["force_ratio"], rows["contact_radius_ratio"]
            ),
            work_ratio(form.work_unloading, form.force, form.contact_radius),
        ),
    )
    with styled():
        figure, panels = subplots(1, 3, figsize=(11, 3.9))
        for axes, (label, values, curve) in zip(panels, drawn, strict=True):
            _points(axes, rows, s, values.to_numpy())
            axes.plot(line, curve, "k", lw=1)
            axes.set(xscale="log", xlabel="S", ylabel=label)
        panels[0].set_yscale("log")
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=3, fontsize=8)
    return figure


def errors_figure(constants: Constants, rows: pd.DataFrame) -> Figure:
    """Draw the error of the law in force and restitution over speed."""
    off = errors(constants, rows)
    speed = rows["speed_ratio"].to_numpy()
    with styled():
        figure, panels = subplots(1, 2, figsize=(9.4, 4.2), sharex=True)
        for axes, (name, label) in zip(
            panels, (("force", "peak force"), ("restitution", "restitution")), strict=True
        ):
            _points(axes, rows, speed, off[name].to_numpy())
            axes.axhline(0, color="k", lw=0.8)
            axes.set(xscale="log", xlabel="speed over that at yield", ylabel=f"{label}, % off")
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=3, fontsize=8)
    return figure


def _points(axes: Axes, rows: pd.DataFrame, x: np.ndarray, y: np.ndarray) -> None:
    """Draw points by kind of contact; those of held-out metals are open."""
    kinds, held = kind(rows), (rows["set"] == "held").to_numpy()
    for sort, colour, marker in zip(KINDS, COLOURS, "osD", strict=False):
        for out in (False, True):
            shown = (kinds == sort) & (held == out)
            axes.plot(
                x[shown],
                y[shown],
                marker,
                color=colour,
                mfc="white" if out else colour,
                ms=3,
                mew=0.7,
                label=sort + (", held out" if out else ""),
            )
