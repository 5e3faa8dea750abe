# SPDX-License-Identifier: GPL-2.0-or-later
"""Charts of a page: plotly figures without colours, which the page gives them as it is lit."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

import attrs
import plotly.graph_objects as go

#: Traces of no law that a page leaves in the colour of its text.
INK = -1


@attrs.frozen(eq=False)
class Chart:
    """A figure with what is said of it, or several of which a reader chooses one.

    Attributes:
        name: Of the element of the page.
        views: Figures by what they show; the first is shown.
        said: What it shows, for those who do not see it.
        caption: A sentence or two below it.
        choice: What the views differ in; "" where there is one.
        start: The view that is shown first, by default the first.
        height: Of the figure [px].
    """

    name: str
    views: Mapping[str, go.Figure]
    said: str
    caption: str
    choice: str = ""
    start: str = attrs.Factory(lambda self: next(iter(self.views)), takes_self=True)
    height: int = 400

    def to_json(self) -> dict[str, Any]:
        """Traces and layouts of the views, for the page's script."""
        views = {}
        for name, figure in self.views.items():
            parts = figure.to_plotly_json()
            layout = {key: value for key, value in parts["layout"].items() if key != "template"}
            views[name] = {"data": list(parts["data"]), "layout": layout}
        return {"views": views, "height": self.height}


def chart_name(*parts: object) -> str:
    """An element's name made of words."""
    return re.sub(r"[^a-z0-9]+", "-", "-".join(map(str, parts)).lower()).strip("-")


def of_law(law: str) -> dict[str, Any]:
    """What a trace says of the law it belongs to: the page switches it and gives it its colour."""
    return {"law": law}


def figure(x: str, y: str, **layout: Any) -> go.Figure:
    """An empty figure with titles of its axes."""
    made = go.Figure(layout={"template": "none", **layout})
    made.update_xaxes(title=x)
    made.update_yaxes(title=y)
    return made


def decades(axes: Callable[..., Any]) -> None:
    """Make axes logarithmic, with a line a decade; `axes` is a figure's update_xaxes or so."""
    axes(type="log", dtick=1, tickformat="~g", minor={"ticks": "outside", "ticklen": 3})


def line(x: Any, y: Any, name: str, colour: dict[str, Any], hover: str, **more: Any) -> go.Scatter:
    """A line.

    Args:
        x, y: Its points.
        name: Of the trace.
        colour: `of_law`, or {"colour": number}.
        hover: What is said of a point, a template of plotly's.
        more: Of the trace.
    """
    style = {"width": 1.6} | more.pop("line", {})
    given = {"mode": "lines", "line": style, "meta": colour, "hovertemplate": hover}
    return go.Scatter(x=x, y=y, name=name, **given | more)


def points(
    x: Any, y: Any, name: str, colour: dict[str, Any], hover: str, **more: Any
) -> go.Scatter:
    """Points, arguments as for `line`."""
    marker = {"size": 8, "line": {"width": 1.6}} | more.pop("marker", {})
    given = {"mode": "markers", "marker": marker, "meta": colour, "hovertemplate": hover}
    return go.Scatter(x=x, y=y, name=name, **given | more)
