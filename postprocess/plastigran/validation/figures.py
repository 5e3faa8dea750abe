# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of the validation pages."""

from __future__ import annotations

from math import ceil

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from plastigran.calibration.expected_errors import KINDS
from plastigran.plot.style import COLOURS, MARKERS, law_colour, styled, subplots, title
from plastigran.validation import oblique

#: Number of panels beside each other in a figure.
COLUMNS = 5
#: Largest error that a panel shows [%]. Larger errors are drawn at the edge of the panel.
REACH = 40
#: Incident angles of the theoretical curves [degrees].
FINE_ANGLES = np.linspace(1, 86, 52)


@styled({"font.size": 8})
def spheres_figure(compared: pd.DataFrame, quantity: str) -> Figure:
    """Draw the error of each law versus impact speed / yield speed, in one panel per law.

    Args:
        compared: Table of `laws_on_spheres.compare`.
        quantity: One of `laws_on_spheres.QUANTITIES`.
    """
    names = sorted(compared["law"].unique())
    rows = ceil(len(names) / COLUMNS)
    size = (10.4, 2.0 * rows + 0.4)
    figure, grid = subplots(rows, COLUMNS, figsize=size, sharex=True, sharey=True)
    for axes in grid.flat[len(names) :]:
        axes.set_visible(False)
    for axes, name in zip(grid.flat, names, strict=False):
        for contact, colour, marker in zip(KINDS, COLOURS, "os^", strict=False):
            part = compared[(compared["law"] == name) & (compared["kind"] == contact)]
            error = np.clip(100 * part[quantity], -REACH, REACH)
            style = {"color": colour, "ms": 2.5, "mfc": "none", "label": contact}
            axes.plot(part["speed_ratio"], error, marker, **style)
        axes.axhline(0, color="0.4", lw=0.6)
        axes.set(xscale="log", ylim=(-1.05 * REACH, 1.05 * REACH), title=title(name))
    grid.flat[0].legend(fontsize=7)
    figure.supxlabel("$v/v_Y$", fontsize=9)
    figure.supylabel("law / finite elements − 1 (%)", fontsize=9)
    return figure


@styled()
def rebound_figure(rebounds: pd.DataFrame) -> Figure:
    """Draw the restitution of steel and the error of each law versus Vickers hardness.

    Args:
        rebounds: Table of `steel.rebounds`.
    """
    figure, (left, right) = subplots(1, 2, figsize=(10.4, 4.6))
    for number, (name, part) in enumerate(rebounds.groupby("law")):
        line = {"color": law_colour(name), "ls": "-" if number < 7 else "--", "lw": 1.2}
        left.plot(part["HV"], part["restitution"], **line)
        right.plot(part["HV"], 100 * part["error"], label=title(name), **line)
    left.plot(part["HV"], part["HLD"] / 1000, "ko", ms=3, label="Leeb D")
    share = np.where(part["HLD"] >= 450, 5.0, 9.0)
    label = "uncertainty of the conversion HLD to HV"
    right.fill_between(part["HV"], -share, share, color="0.9", label=label)
    right.axhline(0, color="0.3", lw=0.8)
    for axes in (left, right):
        axes.set(xscale="log", xlabel="Vickers hardness (HV)")
        axes.set_xticks([100, 200, 400, 800], ["100", "200", "400", "800"])
    left.set(ylabel="restitution", ylim=(0, 1))
    left.legend()
    right.set(ylabel="error of restitution (%)", ylim=(-60, 60))
    figure.legend(*right.get_legend_handles_labels(), loc="outside right center", fontsize=8)
    return figure


@styled()
def budget_figure(parts: pd.DataFrame, law: str, mean: float) -> Figure:
    """Draw how much each uncertainty changes the restitution that a law predicts for steel.

    Args:
        parts: Table of `offset.budget`.
        law: Name of the law.
        mean: Mean error of the law [%].
    """
    figure, axes = subplots(figsize=(7.4, 4.4))
    places = np.arange(len(parts))[::-1]
    ends = parts[["at 80 HV (%)", "at 940 HV (%)"]].to_numpy()
    axes.barh(places, parts["mean (%)"], color=COLOURS[0], height=0.6, label="mean")
    line = {"color": "0.2", "lw": 1.5, "label": "80 to 940 HV"}
    axes.hlines(places, ends.min(axis=1), ends.max(axis=1), **line)
    axes.axvline(-mean, color=COLOURS[1], ls="--", label="change that would remove the mean error")
    axes.axvline(0, color="0.4", lw=0.8)
    axes.set_yticks(places, parts["source"] + ", " + parts["change"])
    axes.tick_params(axis="y", labelsize=7.5)
    axes.set(xlabel=f"change of the restitution of {title(law)} (%)")
    axes.legend(fontsize=8)
    return figure


@styled()
def errors_figure(table: pd.DataFrame, head: str) -> Figure:
    """Draw the errors of the laws as points, with one line of the figure for each law.

    Args:
        table: Column law, and columns of errors whose names end in "(%)".
        head: Title of the figure.
    """
    columns = [name for name in table.columns if name.endswith("(%)")]
    figure, axes = subplots(figsize=(7.4, 1.2 + 0.3 * len(table)))
    places = np.arange(len(table))[::-1]
    for name, colour, marker in zip(columns, COLOURS, MARKERS, strict=False):
        style = {"ls": "", "marker": marker, "color": colour, "mfc": "none"}
        axes.plot(table[name], places, **style, label=name.removesuffix(" (%)"))
    axes.axvline(0, color="0.4", lw=0.8)
    axes.set_yticks(places, [title(name) for name in table["law"]])
    axes.set(xlabel="error (%)", title=head)
    figure.legend(loc="outside lower center", fontsize=8, ncols=2)
    return figure


@styled()
def oblique_figure(computed: pd.DataFrame) -> Figure:
    """Draw the measured quantities of oblique impacts, and the values computed by each method.

    Args:
        computed: Table of `oblique.computed`.
    """
    figure, panels = subplots(1, 3, figsize=(11, 3.8))
    impacts = [oblique.impact(float(angle)) for angle in FINE_ANGLES]
    for axes, (name, (label, _)) in zip(panels, oblique.QUANTITIES.items(), strict=True):
        part = computed[computed["quantity"] == name].sort_values("incident_angle")
        for (method, theory), line, colour in zip(
            oblique.THEORIES.items(), ("-", "--"), COLOURS, strict=False
        ):
            values = [oblique.quantity(name, impact, theory(impact)) for impact in impacts]
            axes.plot(FINE_ANGLES, values, line, color=colour, label=method)
        for method, marker, colour in zip(oblique.IN_LIGGGHTS, "s^D", COLOURS[2:], strict=False):
            open_marker = {"color": colour, "mfc": "none", "label": method}
            axes.plot(part["incident_angle"], part[method], marker, **open_marker)
        axes.plot(part["incident_angle"], part["value"], "ko", ms=4, label="measured")
        axes.set(xlabel="incident angle (°)", ylabel=label)
    panels[0].legend(fontsize=8)
    return figure
