# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of die compactions: pressure versus relative density, and Heckel's plot of the loading."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from plastigran.physics.heckel import STRAIGHT, heckel_line
from plastigran.plot.style import COLOURS, styled, subplots


def compaction_figure(runs: dict[str, pd.DataFrame], yield_strengths: list[float]) -> Figure:
    """Draw pressure versus relative density, and Heckel's plot of the loading with fitted lines.

    Args:
        runs: Tables by label: columns relative_density [-] and pressure [Pa], in order of time.
        yield_strengths: Yield strength sigma_Y of the grains of each run [Pa]. A dashed line shows
            the slope 1/(3 sigma_Y), unless this slope is almost zero.
    """
    with styled():
        figure, (loops, heckel) = subplots(1, 2, figsize=(9.2, 4.0))
        for colour, (label, table), strength in zip(
            COLOURS, runs.items(), yield_strengths, strict=False
        ):
            density, pressure = table["relative_density"], table["pressure"] / 1e3
            line, dashes = {"color": colour, "lw": 1.5, "label": label}, {"color": colour, "lw": 1}
            loops.plot(density, pressure, **line)
            loading = slice(0, int(np.argmax(pressure)) + 1)
            heckel.plot(pressure[loading], -np.log1p(-density[loading]), **line)
            slope, intercept = heckel_line(density, table["pressure"])
            ends = np.array(STRAIGHT) * pressure.max()
            fitted = intercept + slope * ends * 1e3
            heckel.plot(ends, fitted, "o:", color=colour, mfc="white")
            ideal = 1e3 / (3 * strength)
            if ideal * pressure.max() > 0.01:
                heckel.plot(ends, fitted[0] + ideal * (ends - ends[0]), "--", **dashes)
        densities = pd.concat([table["relative_density"] for table in runs.values()])
        pressures = pd.concat([table["pressure"] for table in runs.values()])
        touched = densities[pressures > 0].min()
        loops.set(xlim=(touched - 0.01, densities.max() + 0.01), xlabel="relative density")
        loops.set_ylim(bottom=0)
        loops.set_ylabel("pressure on the punch (kPa)")
        loops.legend(loc="upper left")
        heckel.set_ylim(bottom=-np.log1p(-touched) - 0.02)
        heckel.set(xlabel="pressure on the punch (kPa)", ylabel="ln 1/(1 − relative density)")
        heckel.plot([], [], "o:", color="0.4", mfc="white", label="Heckel's line")
        heckel.plot([], [], "--", color="0.4", lw=1, label="slope $1/(3\\sigma_Y)$")
        handles, labels = heckel.get_legend_handles_labels()
        heckel.legend(handles[-2:], labels[-2:], loc="lower right")
    return figure
