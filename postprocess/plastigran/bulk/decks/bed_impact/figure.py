# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of shots on a plate, compared with the law's restitution, and on a bed."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, styled, subplots

#: Number of shots that are drawn as points. All points lie on one curve, so more points would
#: overlap.
SHOWN = 30


def plate_figure(shot: pd.DataFrame) -> Figure:
    """Draw the restitution of shots and of the law, and the distributions of the speeds.

    Args:
        shot: Columns impact_speed, rebound_speed, rebound_predicted [m/s], one row per shot.
    """
    shown = np.unique(np.linspace(0, len(shot) - 1, SHOWN).astype(int))
    share = (np.arange(len(shot)) + 0.5) / len(shot)
    impact, rebound, predicted = (
        np.sort(shot[name]) for name in ("impact_speed", "rebound_speed", "rebound_predicted")
    )
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(9.2, 3.8))
        ordered = shot.sort_values("impact_speed")
        _restitution(left, ordered, ordered.iloc[shown])
        left.set_ylim(top=1.01)
        points = {"color": COLOURS[1], "mfc": "white", "ms": 5}
        right.plot(impact, share, color="0.5", lw=1.3, label="impact")
        right.plot(predicted, share, color=COLOURS[0], lw=1.3, label="$v\\,e(v)$")
        right.plot(rebound[shown], share[shown], "o", label="rebound", **points)
        right.set(xlabel="speed (m/s)", ylabel="fraction of shots with a lower speed")
        right.legend(loc="upper left")
    return figure


def bed_figure(shot: pd.DataFrame, by_depth: pd.DataFrame, diameter: float) -> Figure:
    """Draw rebound / impact speed with the law's curve on a plate, and plastic work by depth.

    Args:
        shot: Columns impact_speed, rebound_speed, rebound_predicted [m/s], one row per shot.
        by_depth: Columns depth [m] and plastic_work [J], one row per layer of the bed.
        diameter: Grain diameter [m].
    """
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(9.2, 3.8))
        _restitution(left, shot.sort_values("impact_speed"), shot)
        left.set_ylim(-0.02, 1)
        work, total = by_depth["plastic_work"], by_depth["plastic_work"].sum()
        bars = {"height": 0.85, "color": COLOURS[0], "alpha": 0.75}
        right.barh(by_depth["depth"] / diameter, work / total, **bars)
        right.invert_yaxis()
        right.set_xlabel(f"fraction of the total plastic work of {total:.2g} J")
        right.set_ylabel("depth (grain diameters)")
    return figure


def _restitution(axes: Axes, ordered: pd.DataFrame, shown: pd.DataFrame) -> None:
    """Draw rebound speed / impact speed of shots and of the law.

    `shown` has the shots that are drawn as points. `ordered` has all shots, sorted by impact speed,
    for the line of the law.
    """
    speed, points = shown["impact_speed"], {"color": COLOURS[1], "mfc": "none", "ms": 5}
    axes.plot(speed, shown["rebound_speed"] / speed, "o", alpha=0.8, label="shot", **points)
    speed, line = ordered["impact_speed"], {"color": COLOURS[0], "lw": 1.3}
    label = "law: central impact on a plate"
    axes.plot(speed, ordered["rebound_predicted"] / speed, label=label, **line)
    axes.set(xlabel="impact speed (m/s)", ylabel="rebound speed / impact speed")
    axes.legend(loc="best")
