# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of the benchmark impacts of Chung & Ooi (2011), with the quantities of their paper.

Points are results of LIGGGHTS, lines are theory.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from attrs import evolve
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.experiments.chung_ooi import TITLES, BenchmarkImpact, BenchmarkOutcome
from plastigran.physics import central
from plastigran.physics.oblique import Motion, ObliqueImpact
from plastigran.plot.style import COLOURS, MARKERS, styled, subplots

Entry = tuple[BenchmarkImpact, BenchmarkOutcome]


@dataclass(frozen=True)
class Quantity:
    """Quantity on an axis: label, and value for an impact and the motion after the impact."""

    label: str
    value: Callable[[ObliqueImpact, Motion], float]


def _friction(impact: ObliqueImpact) -> float:
    return impact.coefficient_of_friction * impact.before.normal


def _before(impact: ObliqueImpact) -> float:
    return impact.surface_speed(impact.before)


ANGLE = Quantity(
    "incident angle (°)",
    lambda impact, _: np.degrees(np.arctan2(impact.before.along, impact.before.normal)),
)
TANGENTIAL_RESTITUTION = Quantity(
    "tangential restitution $v_t'/v_t$", lambda impact, after: after.along / impact.before.along
)
SPIN_GAINED = Quantity("spin after the impact (rad/s)", lambda _, after: -after.spin)
SURFACE_ANGLE = Quantity(
    "rebound angle of the contact point (°)",
    lambda impact, after: np.degrees(np.arctan2(impact.surface_speed(after), after.normal)),
)
INCIDENT = Quantity(r"$v_t/(\mu v_n)$", lambda impact, _: impact.before.along / _friction(impact))
RECOIL = Quantity(
    r"surface speed after the impact, $v_s'/(\mu v_n')$",
    lambda impact, after: (
        impact.surface_speed(after) / (impact.coefficient_of_friction * after.normal)
    ),
)
SPIN_SCALED = Quantity(
    r"spin after the impact, $R\omega'/(\mu v_n)$",
    lambda impact, after: after.spin * impact.radius / _friction(impact),
)
SLIDING_SHARE = Quantity(
    r"$\frac{7}{2}\mu(1+e)\,v_n/v_s$",
    lambda impact, _: 3.5 * _friction(impact) * (1 + impact.restitution()) / _before(impact),
)
SURFACE_RESTITUTION = Quantity(
    "surface restitution $-v_s'/v_s$",
    lambda impact, after: -impact.surface_speed(after) / _before(impact),
)
TANGENT = Quantity("$v_s/v_n$", lambda impact, _: _before(impact) / impact.before.normal)
TANGENT_AFTER = Quantity(
    "$v_s'/v_n'$", lambda impact, after: impact.surface_speed(after) / after.normal
)
SPIN = Quantity("spin (rad/s)", lambda impact, _: impact.before.spin)
SPIN_AFTER = Quantity("spin after the impact (rad/s)", lambda _, after: after.spin)
ALONG = Quantity("tangential speed after the impact (m/s)", lambda _, after: after.along)

#: Quantities on the x and y axes of each panel, by the number of the benchmark. Benchmarks 4 to 8
#: are oblique impacts.
PANELS = {
    4: [(ANGLE, TANGENTIAL_RESTITUTION), (ANGLE, SPIN_GAINED), (ANGLE, SURFACE_ANGLE)],
    5: [(INCIDENT, RECOIL), (INCIDENT, SPIN_SCALED)],
    6: [(SLIDING_SHARE, SURFACE_RESTITUTION), (TANGENT, TANGENT_AFTER)],
    7: [(SPIN, ALONG), (SPIN, SPIN_AFTER)],
    8: [(SLIDING_SHARE, SURFACE_RESTITUTION), (TANGENT, TANGENT_AFTER)],
}


def _label(case: BenchmarkImpact) -> str:
    name = case.material.replace("_", " ")
    if case.modulus_ratio is None:
        return name
    return f"{name}, $E_2/E_1$ = {case.modulus_ratio:g}"


def figure(number: int, outcomes: dict[BenchmarkImpact, BenchmarkOutcome]) -> Figure:
    """Draw the figure of one benchmark.

    Args:
        number: Number of the benchmark, 1 to 8.
        outcomes: Outcomes of impacts, also of other benchmarks, as in `Runs.outcomes`.

    Raises:
        ValueError: `outcomes` contains no impact of this benchmark.
    """
    series: dict[str, list[Entry]] = {}
    for case, outcome in outcomes.items():
        if case.benchmark == number:
            series.setdefault(_label(case), []).append((case, outcome))
    if not series:
        raise ValueError(f"the outcomes contain no impact of benchmark {number}")
    columns = len(PANELS.get(number, [0, 0] if number < 3 else [0]))
    with styled():
        page, panels = subplots(1, columns, figsize=(4.0 * columns + 0.4, 3.8), squeeze=False)
        page.suptitle(f"{number}. {TITLES[number]}", fontsize=11)
        for k, (label, entries) in enumerate(series.items()):
            style = {"color": COLOURS[k], "marker": MARKERS[k], "label": label}
            if number < 3:
                _loops(panels[0], entries, style)
            elif number == 3:
                _restitutions(panels[0][0], entries, style, last=k == len(series) - 1)
            else:
                for axes, panel in zip(panels[0], PANELS[number], strict=True):
                    _oblique(axes, panel, entries, style)
        first = panels[0][0]
        first.plot([], [], color="0.3", lw=1.3, label="theory")
        shown = (case for entries in series.values() for case, _ in entries)
        if number in PANELS and any(case.impact().slides() for case in shown):
            first.plot([], [], ":", color="0.3", lw=1.3, label="rigid bodies, sliding")
        first.legend(title="points: LIGGGHTS", fontsize=8, title_fontsize=8)
    return page


def _loops(panels: np.ndarray, entries: list[Entry], style: dict) -> None:
    """Draw force versus overlap and versus time, with the curves of Hertz's theory."""
    for case, outcome in entries:
        impact, collision = case.impact(), outcome.collision
        radius, modulus = impact.radius_eff, impact.pair.youngs_modulus_eff
        speed = impact.before.normal
        overlap = np.linspace(0, collision.overlap_max, 100)
        time, history = central.hertz_history(radius, impact.mass_eff, modulus, speed)
        loop = collision.loop[collision.loop["overlap"] >= 0]
        points = loop.iloc[:: max(1, len(loop) // 24)]
        for axes, column, label, x, overlaps in (
            (panels[0], "overlap", "overlap (µm)", overlap, overlap),
            (panels[1], "time", "time (µs)", time, history),
        ):
            force = central.hertz_force(radius, modulus, overlaps)
            axes.plot(x * 1e6, force / 1e3, color=style["color"], lw=1.3)
            axes.plot(points[column] * 1e6, points["force"] / 1e3, ls="", mfc="none", **style)
            axes.set(xlabel=label, ylabel="force (kN)")


def _restitutions(axes: Axes, entries: list[Entry], style: dict, last: bool) -> None:
    """Draw the restitution versus the value for which the dashpot is set.

    If `last` is True, draw the lines of theory, too.
    """
    impacts = [case.impact() for case, _ in entries]
    nominal = [impact.coefficient_of_restitution for impact in impacts]
    measured = [
        outcome.after.normal / impact.before.normal
        for impact, (_, outcome) in zip(impacts, entries, strict=True)
    ]
    if last:
        line = np.linspace(0.02, 1, 200)
        axes.plot(line, central.restitution_without_pull(line), color="0.3", lw=1.3)
        axes.plot(
            line, line, ":", color="0.3", lw=1.3, label="dashpot with attractive forces allowed"
        )
    axes.plot(nominal, measured, ls="", mfc="none", ms=7 if last else 10, **style)
    axes.set(xlabel="nominal restitution of the dashpot", ylabel="restitution", xlim=(0, 1.03))
    axes.set_ylim(0, 1.03)


def _oblique(
    axes: Axes, panel: tuple[Quantity, Quantity], entries: list[Entry], style: dict
) -> None:
    """Draw simulated impacts as points, and both theories (spring and slider, rigid) as lines."""
    values = [case.value for case, _ in entries]
    ends = min(values), max(values)
    fine = np.union1d(np.geomspace(*ends, 50), np.linspace(*ends, 50))
    swept = [evolve(entries[0][0], value=float(value)).impact() for value in fine]
    measured = [(case.impact(), outcome.after) for case, outcome in entries]
    theory = [(impact, impact.spring_slider()) for impact in swept]
    sliding = [(impact, impact.rigid_sliding()) for impact in swept if impact.slides()]
    for motions, look in (
        (measured, {"ls": "", "mfc": "none", "ms": 5, **style}),
        (theory, {"color": style["color"], "lw": 1.1}),
        (sliding, {"ls": ":", "color": "0.3", "lw": 1.6}),
    ):
        x, y = ([quantity.value(*motion) for motion in motions] for quantity in panel)
        axes.plot(x, y, **look)
    across, up = panel
    axes.set(xlabel=across.label, ylabel=up.label)
    if across is SLIDING_SHARE:
        axes.set_xlim(0, 10)
    if up is ALONG:  # scale the axis by the impact speed, because the values are only round-off
        normal = measured[0][0].before.normal
        axes.set_ylim(-normal, normal)
