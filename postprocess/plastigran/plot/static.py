# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw a chart with matplotlib."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes

from plastigran.plot.chart import DASHES, INK, Curve, Panel, is_below
from plastigran.plot.style import COLOURS, MARKERS, law_number


def draw(axes: Axes, panel: Panel, colours: Sequence[object] = ()) -> None:
    """Draw the curves of a panel and label the axes.

    Args:
        axes: Axes to draw in.
        panel: Data to draw.
        colours: One color for each curve. By default, `Curve.law` or `Curve.colour` sets the color.
    """
    areas = [curve for curve in panel.curves if curve.look == "area"]
    for below in (False, True):
        if chosen := [area for area in areas if is_below(area) == below]:
            _stack(axes, panel, chosen)
    entries: dict[str, dict] = {}
    for k, curve in enumerate(panel.curves):
        if curve.look == "area":
            continue
        style = _style(curve)
        if len(colours):
            style["color"] = colours[k]
        axes.plot(curve.x * panel.x.factor, curve.y * panel.y.factor, **style)
        entry = entries.setdefault(curve.name, dict(style))
        entry |= style | {"ls": style["ls"] or entry["ls"]}
    for name, style in entries.items():
        axes.plot([], [], label=name, **style)
    for limit in panel.limits:
        axes.axhline(limit * panel.y.factor, color="0.4", ls=":")
    axes.set(xlabel=panel.x.axis, ylabel=panel.y.axis)
    for axis in panel.logarithmic:
        axes.set(**{f"{axis}scale": "log"})
    if panel.y_range:
        axes.set_ylim(panel.y_range)


def _style(curve: Curve) -> dict[str, object]:
    number = law_number(curve.law) if curve.law else curve.colour
    colour = "black" if number == INK else COLOURS[number]
    style = {"color": colour, "ls": "", "lw": 1.3}
    if curve.look in ("line", "joined"):
        style["ls"] = DASHES[curve.dash][1]
    if curve.look == "cross":
        style |= {"marker": "x", "ms": 8, "mew": 2}
    elif curve.look != "line":
        marker = MARKERS[number] if number != INK else "o"
        style |= {"marker": marker, "ms": 6, "mfc": colour if curve.dash else "white"}
    return style


def _stack(axes: Axes, panel: Panel, areas: Sequence[Curve]) -> None:
    axes.stackplot(
        areas[0].x * panel.x.factor,
        [area.y * panel.y.factor for area in areas],
        labels=[area.name for area in areas],
        colors=[COLOURS[area.colour] for area in areas],
        alpha=0.75,
        lw=0,
    )
    axes.set_axisbelow(True)
