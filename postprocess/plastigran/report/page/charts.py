# SPDX-License-Identifier: GPL-2.0-or-later
"""Interactive charts: plotly figures without colors, which the page adds for light or dark."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import attrs
import numpy as np
import plotly.graph_objects as go
from plotly.subplots import make_subplots

from plastigran.plot.chart import DASHES, Curve, Panel

#: Share of the height that the upper of two panels takes.
UPPER = 0.76
#: Marker of the look "dashes".
DASH = {"symbol": "line-ew", "size": 22}


@attrs.frozen(eq=False)
class Chart:
    """A figure with its caption, or several figures of which the reader chooses one.

    Attributes:
        name: ID of the element of the page.
        views: Figures by the words in the menu.
        said: Description of the chart for screen readers.
        caption: One or two sentences below it.
        choice: Label of the menu; "" for a single figure.
        start: View that is shown first; by default the first of `views`.
        height: Height of the figure [px].
    """

    name: str
    views: Mapping[str, go.Figure]
    said: str
    caption: str
    choice: str = ""
    start: str = attrs.Factory(lambda self: next(iter(self.views)), takes_self=True)
    height: int = 400

    def to_json(self) -> dict[str, Any]:
        """Return traces and layouts of the views for the script of the page."""
        views = {}
        for name, figure in self.views.items():
            parts = figure.to_plotly_json()
            layout = {key: value for key, value in parts["layout"].items() if key != "template"}
            views[name] = {"data": list(parts["data"]), "layout": layout}
        return {"views": views, "height": self.height}


def chart_name(*parts: object) -> str:
    """Return the ID of an element, made of words."""
    return re.sub(r"[^a-z0-9]+", "-", "-".join(map(str, parts)).lower()).strip("-")


def interactive(*panels: Panel, by_time: bool = False) -> go.Figure:
    """Draw panels, one below the other, with plotly.

    Args:
        panels: One or two panels, with the same x axis.
        by_time: Whether a box shows the values of all curves at the time under the pointer.
    """
    heights = [UPPER, 1 - UPPER] if len(panels) == 2 else None
    figure = make_subplots(
        len(panels), 1, shared_xaxes=True, row_heights=heights, vertical_spacing=0.07
    )
    figure.update_layout(template="none")
    if by_time:
        figure.update_layout(hovermode="x unified")
    for row, panel in enumerate(panels, 1):
        for curve in panel.curves:
            figure.add_trace(_trace(panel, curve, by_time, row), row=row, col=1)
        for limit in panel.limits:
            look = {"dash": "dot", "width": 1, "color": "gray"}
            figure.add_hline(limit * panel.y.factor, row=row, col=1, line=look)
        _axes(figure, panel, row)
    figure.update_xaxes(title=panels[-1].x.axis, row=len(panels), col=1)
    return figure


def _axes(figure: go.Figure, panel: Panel, row: int) -> None:
    for axis, update in (("x", figure.update_xaxes), ("y", figure.update_yaxes)):
        if axis in panel.logarithmic:  # a line for each decade
            minor = {"ticks": "outside", "ticklen": 3}
            update(type="log", dtick=1, tickformat="~g", minor=minor, row=row, col=1)
    ends = panel.y_range
    if ends and "y" in panel.logarithmic:
        ends = np.log10(ends)
    figure.update_yaxes(title=panel.y.axis, row=row, col=1)
    if ends is not None:
        figure.update_yaxes(range=list(ends), row=row, col=1)
    elif any(curve.look == "area" for curve in panel.curves):
        figure.update_yaxes(rangemode="tozero", row=row, col=1)


def _trace(panel: Panel, curve: Curve, by_time: bool, row: int) -> go.Scatter:
    """Return the trace of a curve. Its `meta` gives the law or color number to the page."""
    words = curve.x.dtype.kind not in "iuf"
    trace = go.Scatter(
        x=curve.x if words else curve.x * panel.x.factor,
        y=np.asarray(curve.y) * panel.y.factor,
        name=curve.name,
        meta={"law": curve.law} if curve.law else {"colour": curve.colour},
        hovertemplate=_hover(panel, curve, by_time, words),
    )
    if curve.remarks:
        trace.customdata = list(curve.remarks)
    if curve.look in ("line", "area"):
        trace.mode = "lines"
    else:
        trace.mode = "lines+markers" if curve.look == "joined" else "markers"
        size = {"joined": {"size": 6}, "dashes": DASH, "cross": {"symbol": "x-thin", "size": 9}}
        trace.marker = {"size": 8, "line": {"width": 1.6}} | size.get(curve.look, {})
    if curve.look == "line":
        trace.line = {"width": 1.6, "dash": DASHES[curve.dash][0]}
    elif curve.look == "joined":
        trace.line = {"width": 1}
    elif curve.look == "area":
        trace.stackgroup, trace.line = "energy", {"width": 0.5}
    if row > 1:
        trace.showlegend = False
    return trace


def _hover(panel: Panel, curve: Curve, by_time: bool, words: bool) -> str:
    value = f"%{{y:.5g}} {panel.y.unit}".strip()
    if by_time:
        return value
    if curve.remarks:
        return f"<b>{curve.name}</b><br>%{{customdata}}<extra></extra>"
    at = "%{x}" if words else f"{panel.x.title} %{{x:.4g}} {panel.x.unit}".strip()
    return f"<b>{curve.name}</b><br>{at}<br>{panel.y.title} {value}<extra>{curve.source}</extra>"
