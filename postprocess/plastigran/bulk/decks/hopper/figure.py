# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of a hopper: discharged mass over time, and rate over orifice diameter."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.physics.beverloo import Discharge, fit_constants
from plastigran.plot.style import COLOURS, styled, subplots


def discharge_figure(series: pd.DataFrame, discharge: Discharge | None, mass: float) -> Figure:
    """Draw the discharged mass over time, the line through its steady part, and Beverloo's law.

    Args:
        series: Columns time [s] and counted, the number of discharged grains.
        discharge: Steady discharge of the run, or None.
        mass: Mass of a grain [kg].
    """
    with styled():
        figure, axes = subplots(figsize=(6.4, 4.4))
        draw_course(
            axes,
            series,
            discharge,
            mass,
            COLOURS[0],
            "discharge, thick where its rate is measured" if discharge else "discharge",
        )
        if discharge:
            time = np.array([discharge.start, discharge.stop])
            begin = mass * np.interp(discharge.start, series["time"], series["counted"])
            low, high = (begin + edge * (time - time[0]) for edge in discharge.band)
            law = begin + discharge.predicted * (time - time[0])
            axes.plot(time, law, "--", color="0.4", label="Beverloo's law")
            axes.fill_between(
                time, low, high, color="0.85", lw=0, label="the same, with the scatter of C and k"
            )
            axes.set_title(
                f"{discharge.rate:.3g} ± {discharge.rate_error:.1g} kg/s, "
                f"{discharge.rate / discharge.predicted:.2f} of Beverloo's",
                fontsize=10,
            )
        else:
            axes.set_title("no steady part: the rate was not measured", fontsize=10)
        axes.legend(loc="upper left")
    return figure


def orifices_figure(runs: list[tuple[pd.DataFrame, Discharge, float]]) -> Figure:
    """Draw discharged mass over time for several orifices, and rate^(2/5) over the orifice.

    Args:
        runs: Series, discharge and mass of a grain [kg] for three or more orifices.
    """
    discharges = [discharge for _, discharge, _ in runs]
    constants = fit_constants(discharges)
    diameter = discharges[0].diameter
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(9.6, 4.2))
        for colour, (series, discharge, mass) in zip(COLOURS, runs, strict=False):
            label = f"{discharge.orifice / diameter:.3g} d"
            draw_course(left, series, discharge, mass, colour, label)
            right.errorbar(
                discharge.orifice / diameter,
                discharge.reduced / diameter,
                2 * discharge.reduced * 0.4 * discharge.rate_error / discharge.rate / diameter,
                fmt="o",
                color=colour,
                mfc="white",
                zorder=3,
            )
        left.legend(title="orifice", loc="lower right")
        widest = max(discharge.orifice for discharge in discharges) / diameter
        width = np.linspace(constants.empty_annulus, 1.05 * widest)
        slope = constants.coefficient**0.4
        right.plot(
            width,
            slope * (width - constants.empty_annulus),
            color="0.2",
            lw=1.3,
            label=f"fit: C = {constants.coefficient:.3f} ± {constants.coefficient_error:.3f}, "
            f"k = {constants.empty_annulus:.2f} ± {constants.empty_annulus_error:.2f}",
        )
        coefficient, annulus = discharges[0].coefficient, discharges[0].empty_annulus
        right.plot(
            width,
            np.clip(coefficient**0.4 * (width - annulus), 0, None),
            "--",
            color="0.5",
            lw=1.3,
            label=f"Beverloo: C = {coefficient}, k = {annulus}",
        )
        right.set_xlim(0)
        right.set_ylim(0)
        right.set_xlabel("orifice over grain, $D_0/d$")
        right.set_ylabel(r"$(W/\rho_b \sqrt{g})^{2/5}/d$")
        right.legend(loc="upper left")
    return figure


def draw_course(
    axes: Axes,
    series: pd.DataFrame,
    discharge: Discharge | None,
    mass: float,
    colour: str,
    label: str,
) -> None:
    """Draw discharged mass over time, thick where the rate is measured."""
    out = mass * series["counted"]
    axes.plot(series["time"], out, color=colour, lw=1, label=label)
    if discharge:
        steady = series["time"].between(discharge.start, discharge.stop)
        axes.plot(series["time"][steady], out[steady], color=colour, lw=3)
    axes.set_xlabel("time since the orifice opened (s)")
    axes.set_ylabel("mass out (kg)")
