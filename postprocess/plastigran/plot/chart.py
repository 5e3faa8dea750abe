# SPDX-License-Identifier: GPL-2.0-or-later
"""Data of a chart. `plot.static` draws charts in figures, `report.page.charts` in HTML pages."""

from __future__ import annotations

from collections.abc import Sequence

import attrs
import numpy as np

from plastigran.plot.quantities import Scale

#: Value of `Curve.colour` for black on a light page and white on a dark page.
INK = -1
#: Line styles: name in plotly, style in matplotlib, and word for captions.
DASHES = (
    ("solid", "-", "solid"),
    ("dash", "--", "dashed"),
    ("dot", ":", "dotted"),
    ("dashdot", "-.", "dash-dotted"),
    ("longdash", (0, (8, 3)), "long-dashed"),
    ("longdashdot", (0, (8, 3, 2, 3)), "long-dash-dotted"),
)


@attrs.frozen(eq=False, kw_only=True)
class Curve:
    """One curve of a chart.

    Attributes:
        x, y: Coordinates of the points (N,) in SI units; x may also be N texts.
        name: Name in the legend. Curves with equal names share an entry of the legend.
        law: Law whose color the curve has; "" if `colour` sets the color.
        colour: Index of the color in `plastigran.plot.style.COLOURS`, for a curve without law.
        look: "line", "points", "joined" (points joined by a line), "dashes" or "cross" (a dash or
            cross at each point), or "area". Areas are stacked in the order of the curves; areas
            with negative values are stacked below zero.
        dash: Index of the line style in `DASHES`.
        source: Source of the values, for example "theory", which interactive charts show.
        remarks: N texts that an interactive chart shows at the points instead of x and y.
    """

    x: np.ndarray
    y: np.ndarray
    name: str
    law: str = ""
    colour: int = INK
    look: str = "line"
    dash: int = 0
    source: str = ""
    remarks: Sequence[str] = ()


def is_below(area: Curve) -> bool:
    """Return whether an area is stacked below zero."""
    return bool(np.min(area.y) < 0)


@attrs.frozen(eq=False, kw_only=True)
class Panel:
    """Curves on one pair of axes.

    Attributes:
        x, y: Titles and units of the axes.
        curves: Curves, in the order of the legend.
        logarithmic: Axes with logarithmic scale: "", "x", "y" or "xy".
        y_range: Lower and upper end of the y axis in the unit of `y`; None to fit the curves.
        limits: Values of y that horizontal dotted lines mark, in SI units.
    """

    x: Scale
    y: Scale
    curves: Sequence[Curve]
    logarithmic: str = ""
    y_range: tuple[float, float] | None = None
    limits: Sequence[float] = ()
