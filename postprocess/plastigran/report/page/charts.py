# SPDX-License-Identifier: GPL-2.0-or-later
"""Interactive charts, drawn with plotly. The script of the page sets the colors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import attrs
import numpy as np
import plotly.graph_objects as go
from plotly.subplots import make_subplots

from plastigran.plot.chart import DASHES, Curve, Panel, is_below

#: In a chart of two panels: height of the upper panel / height of the chart.
UPPER = 0.76
#: Settings of plotly for each value of `Curve.look`: mode, marker and line.
LOOKS = {
    "line": ("lines", None, {"width": 1.6}),
    "area": ("lines", None, {"width": 0.5}),
    "joined": ("lines+markers", {"size": 6, "line": {"width": 1.6}}, {"width": 1}),
    "points": ("markers", {"size": 8, "line": {"width": 1.6}}, None),
    "dashes": ("markers", {"size": 22, "line": {"width": 1.6}, "symbol": "line-ew"}, None),
    "cross": ("markers", {"size": 9, "line": {"width": 1.6}, "symbol": "x-thin"}, None),
}


@attrs.frozen(eq=False, kw_only=True)
class Chart:
    """Chart with a caption. If there are several views, the reader chooses one in a menu.

    Attributes:
        name: Name of the chart, unique in its section.
        views: Views of the chart, by their names in the menu. A view has one or two panels, which
            share the x axis.
        description: Description for screen readers.
        caption: One or two sentences below the chart.
        menu: Label of the menu.
        start: View that the page shows first; by default the first of `views`.
        height: Height of the chart [px].
        by_time: Whether a box shows the values of all curves at the time under the mouse pointer.
    """

    name: str
    views: Mapping[str, Sequence[Panel]]
    description: str
    caption: str
    menu: str = ""
    start: str = attrs.Factory(lambda self: next(iter(self.views)), takes_self=True)
    height: int = 400
    by_time: bool = False

    def to_json(self) -> dict[str, Any]:
        """Return the plotly traces and layout of each view, for the script of the page."""
        views = {}
        for name, panels in self.views.items():
            drawn = draw(panels, self.by_time).to_plotly_json()
            layout = {key: value for key, value in drawn["layout"].items() if key != "template"}
            views[name] = {"data": list(drawn["data"]), "layout": layout}
        return {"views": views, "height": self.height}


def draw(panels: Sequence[Panel], by_time: bool = False) -> go.Figure:
    """Draw panels one below the other with plotly; `by_time` is explained in `Chart`."""
    heights = [UPPER, 1 - UPPER] if len(panels) == 2 else None
    figure = make_subplots(
        len(panels), 1, shared_xaxes=True, row_heights=heights, vertical_spacing=0.07
    )
    figure.update_layout(template="none")
    if by_time:
        figure.update_layout(hovermode="x unified")
    for row, panel in enumerate(panels, 1):
        place = {"row": row, "col": 1}
        for curve in panel.curves:
            figure.add_trace(_trace(panel, curve, by_time), **place)
        for limit in panel.limits:
            line = {"dash": "dot", "width": 1, "color": "gray"}
            figure.add_hline(limit * panel.y.factor, line=line, **place)
        if row > 1:
            figure.update_traces(showlegend=False, **place)
        if "x" in panel.logarithmic:
            figure.update_xaxes(**_logarithmic(), **place)
        figure.update_yaxes(title=panel.y.axis, **place)
        if "y" in panel.logarithmic:
            figure.update_yaxes(**_logarithmic(), **place)
        if panel.y_range:
            ends = np.log10(panel.y_range) if "y" in panel.logarithmic else panel.y_range
            figure.update_yaxes(range=list(ends), **place)
        elif any(curve.look == "area" for curve in panel.curves):
            figure.update_yaxes(rangemode="tozero", **place)
    figure.update_xaxes(title=panels[-1].x.axis, row=len(panels), col=1)
    return figure


def _logarithmic() -> dict[str, Any]:
    """Return the settings of a logarithmic axis with a grid line for each decade."""
    minor = {"ticks": "outside", "ticklen": 3}
    return {"type": "log", "dtick": 1, "tickformat": "~g", "minor": minor}


def _trace(panel: Panel, curve: Curve, by_time: bool) -> go.Scatter:
    """Return the plotly trace of a curve.

    Its field `meta` contains the law or the color index of the curve, for the script of the page.
    """
    numeric = curve.x.dtype.kind in "iuf"
    mode, marker, line = LOOKS[curve.look]
    if curve.look == "line":
        line = line | {"dash": DASHES[curve.dash][0]}
    return go.Scatter(
        x=curve.x * panel.x.factor if numeric else curve.x,
        y=np.asarray(curve.y) * panel.y.factor,
        name=curve.name,
        meta={"law": curve.law} if curve.law else {"colour": curve.colour},
        hovertemplate=_hover(panel, curve, by_time, numeric),
        customdata=list(curve.remarks) or None,
        mode=mode,
        marker=marker,
        line=line,
        stackgroup=(("below" if is_below(curve) else "above") if curve.look == "area" else None),
    )


def _hover(panel: Panel, curve: Curve, by_time: bool, numeric: bool) -> str:
    value = f"%{{y:.5g}} {panel.y.unit}".strip()
    if by_time:
        return value
    if curve.remarks:
        return f"<b>{curve.name}</b><br>%{{customdata}}<extra></extra>"
    at = f"{panel.x.title} %{{x:.4g}} {panel.x.unit}".strip() if numeric else "%{x}"
    return f"<b>{curve.name}</b><br>{at}<br>{panel.y.title} {value}<extra>{curve.source}</extra>"
