# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of the fit of the law `universal`: all metals on one curve, and the errors."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.calibration.expected_errors import KINDS
from plastigran.plot.style import COLOURS, save, styled, subplots
from plastigran.validation.spheres import contact_kinds
from plastigran.validation.spheres.forms import Constants, Metals, depth, errors, peak, work_ratio


def write(constants: Constants, rows: pd.DataFrame, folder: Path) -> list[Path]:
    """Draw both figures of the fit, save them in a folder and return the files."""
    figures = {
        "universal_fit": collapse_figure(constants, rows),
        "universal_errors": errors_figure(constants, rows),
    }
    return [save(figure, folder / name, (".svg",))[0] for name, figure in figures.items()]


@styled()
def collapse_figure(constants: Constants, rows: pd.DataFrame) -> Figure:
    """Draw force, contact radius and released energy, relative to Hertz, versus the depth S.

    S measures how far a contact is beyond yield; see `forms.depth`. For force and contact radius,
    the Hertz contact has the same overlap. For the released energy, the Hertz contact has the same
    force and contact radius. Lines are the equations of the law for small a/R without hardening.
    """
    metals, t = Metals.of(rows), np.sqrt(rows["overlap_ratio"])
    s = depth(constants, metals, t.to_numpy())
    small_radius = Metals(np.ones(1), np.zeros(1), np.zeros(1))
    line = np.geomspace(0.05, 1.1 * s.max(), 300)
    form = peak(constants, small_radius, 1 + line)
    force, contact_radius = rows["force_ratio"], rows["contact_radius_ratio"]
    figure, panels = subplots(1, 3, figsize=(11, 3.9))
    for axes, (label, values, curve) in zip(
        panels,
        (
            ("force of Hertz / force", t**3 / force, (1 + line) ** 3 / form.force),
            (
                "contact radius / contact radius of Hertz",
                contact_radius / t,
                form.contact_radius / (1 + line),
            ),
            (
                "released energy / released energy of Hertz",
                work_ratio(rows["work_unloading_ratio"], force, contact_radius),
                work_ratio(form.work_unloading, form.force, form.contact_radius),
            ),
        ),
        strict=True,
    ):
        _points(axes, rows, s, values.to_numpy())
        axes.plot(line, curve, "k", lw=1)
        axes.set(xscale="log", xlabel="S", ylabel=label)
    panels[0].set_yscale("log")
    _legend(figure)
    return figure


@styled()
def errors_figure(constants: Constants, rows: pd.DataFrame) -> Figure:
    """Draw the errors of the law `universal` in force and restitution versus impact speed."""
    error = errors(constants, rows)
    figure, panels = subplots(1, 2, figsize=(9.4, 4.2), sharex=True)
    for axes, name in zip(panels, ("force", "restitution"), strict=True):
        _points(axes, rows, rows["speed_ratio"].to_numpy(), error[name].to_numpy())
        axes.axhline(0, color="k", lw=0.8)
        axes.set(xscale="log", xlabel="$v/v_Y$", ylabel=f"error of {name} (%)")
    _legend(figure)
    return figure


def _points(axes: Axes, rows: pd.DataFrame, x: np.ndarray, y: np.ndarray) -> None:
    """Draw points with a color for each kind of contact; held-out metals have open markers."""
    kinds, held_out = contact_kinds(rows), (rows["set"] == "held").to_numpy()
    for contact, colour, marker in zip(KINDS, COLOURS, "osD", strict=False):
        for is_open, face, ending in ((False, colour, ""), (True, "white", ", held out")):
            shown = (kinds == contact) & (held_out == is_open)
            style = {"color": colour, "mfc": face, "ms": 3, "mew": 0.7}
            axes.plot(x[shown], y[shown], marker, **style, label=contact + ending)


def _legend(figure: Figure) -> None:
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3, fontsize=8)
