# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of a hopper: discharged mass versus time, and discharge rate versus orifice diameter."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.physics.beverloo import Discharge, fit_constants
from plastigran.plot.style import COLOURS, styled, subplots


def discharge_figure(series: pd.DataFrame, discharge: Discharge | None, mass: float) -> Figure:
    """Draw the discharged mass versus time, the line of the steady part, and Beverloo's law.

    Args:
        series: Columns time [s] and counted, the number of discharged grains.
        discharge: Steady part of the discharge, or None if no part is steady.
        mass: Mass of a grain [kg].
    """
    with styled():
        figure, axes = subplots(figsize=(6.4, 4.4))
        label = "discharge (thick: steady part)" if discharge else "discharge"
        _draw_course(axes, series, discharge, mass, COLOURS[0], label)
        if discharge:
            time = np.array([discharge.start, discharge.stop])
            begin = mass * np.interp(discharge.start, series["time"], series["counted"])
            low, high = (begin + edge * (time - time[0]) for edge in discharge.band)
            law = begin + discharge.predicted * (time - time[0])
            axes.plot(time, law, "--", color="0.4", label="Beverloo's law")
            band = {
                "color": "0.85",
                "lw": 0,
                "label": "Beverloo's law within the scatter of C and k",
            }
            axes.fill_between(time, low, high, **band)
            rate = f"{discharge.rate:.3g} ± {discharge.rate_error:.1g} kg/s"
            headline = f"{rate}, {discharge.rate / discharge.predicted:.2f} times Beverloo's law"
        else:
            headline = "rate not measured: no steady discharge"
        axes.set_title(headline, fontsize=10)
        axes.legend(loc="upper left")
    return figure


def orifices_figure(runs: list[tuple[pd.DataFrame, Discharge, float]]) -> Figure:
    """Draw discharged mass versus time for several orifices, and rate^(2/5) versus diameter.

    Args:
        runs: Series, steady discharge and mass of a grain [kg], for three or more orifices.
    """
    discharges = [discharge for _, discharge, _ in runs]
    fit, law = fit_constants(discharges), discharges[0]
    diameter = law.diameter
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(9.6, 4.2))
        for colour, (series, discharge, mass) in zip(COLOURS, runs, strict=False):
            width, reduced = discharge.orifice / diameter, discharge.reduced
            _draw_course(left, series, discharge, mass, colour, f"{width:.3g} d")
            error = 2 * reduced * 0.4 * discharge.rate_error / discharge.rate / diameter
            point = {"fmt": "o", "color": colour, "mfc": "white", "zorder": 3}
            right.errorbar(width, reduced / diameter, error, **point)
        left.legend(title="orifice", loc="lower right")
        widest = max(discharge.orifice for discharge in discharges) / diameter
        width = np.linspace(fit.empty_annulus, 1.05 * widest)
        line = fit.coefficient**0.4 * (width - fit.empty_annulus)
        constants = (
            f"fit of Beverloo's law: C = {fit.coefficient:.3f} ± {fit.coefficient_error:.3f}, "
            f"k = {fit.empty_annulus:.2f} ± {fit.empty_annulus_error:.2f}"
        )
        right.plot(width, line, color="0.2", lw=1.3, label=constants)
        line = np.clip(law.coefficient**0.4 * (width - law.empty_annulus), 0, None)
        constants = f"Beverloo's law: C = {law.coefficient}, k = {law.empty_annulus}"
        right.plot(width, line, "--", color="0.5", lw=1.3, label=constants)
        right.set(xlim=0, ylim=0, xlabel="orifice / grain diameter, $D_0/d$")
        right.set_ylabel(r"$(W/\rho_b \sqrt{g})^{2/5}/d$")
        right.legend(loc="upper left")
    return figure


def _draw_course(
    axes: Axes,
    series: pd.DataFrame,
    discharge: Discharge | None,
    mass: float,
    colour: str,
    label: str,
) -> None:
    """Draw discharged mass versus time, with a thick line while the rate is measured."""
    out = mass * series["counted"]
    axes.plot(series["time"], out, color=colour, lw=1, label=label)
    if discharge:
        steady = series["time"].between(discharge.start, discharge.stop)
        axes.plot(series["time"][steady], out[steady], color=colour, lw=3)
    axes.set(xlabel="time since the orifice opened (s)", ylabel="discharged mass (kg)")
