# SPDX-License-Identifier: GPL-2.0-or-later
"""Die compaction in LIGGGHTS: work of the punch, permanent densification, elastic limit."""

from __future__ import annotations

import make_punch
import numpy as np
import pandas as pd
import pytest

from plastigran.bulk.decks.compaction import TOUCH
from plastigran.bulk.outcome import BulkRun
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series
from plastigran.physics.heckel import heckel_line


def loop_of(run: BulkRun) -> tuple[float, float, float]:
    """Return the relative density at the start of loading, at the peak, and after unloading."""
    pressed = run.series[run.series["pressure"] > TOUCH * run.series["pressure"].max()]
    density = pressed["relative_density"]
    return density.iloc[0], density.loc[pressed["pressure"].idxmax()], density.iloc[-1]


@pytest.fixture(scope="module")
def pressed(brief_run) -> BulkRun:
    """A run with sixty grains in a die that is ten radii wide."""
    return brief_run("compaction")


@pytest.fixture
def press(pressed, tmp_path):
    """`press(ranks, **changes)` runs the deck with changed settings."""

    def run(ranks: int = 1, **changes) -> BulkRun:
        settings = {**pressed.deck.briefs[""].settings, **changes}
        return run_bulk("compaction", settings, tmp_path / "run", ranks, show=False)

    return run


def test_loop(pressed):
    """The punch compacts the grains to the set relative density.

    Most of the densification is permanent; a part springs back.
    """
    assert pressed.passed  # one check compares the work of the punch with force times travel
    touch, peak, released = loop_of(pressed)
    # The relative density changes by up to 2e-3 between two rows of the series, and the lowest
    # position of the punch lies between two rows.
    assert peak == pytest.approx(0.7, abs=2e-3)
    assert released - touch > 0.05
    assert released < 0.95 * peak
    # A part of the work of the punch is recovered; the rest is plastic and friction work.
    table = pressed.series
    work = table["wallwork"]
    assert 0.5 * work.max() < work.iloc[-1] < 0.9 * work.max()
    dissipation = table["plastic"] + table["friction"]
    # The remaining 1 % is work of gravity and kinetic energy.
    assert dissipation.iloc[-1] == pytest.approx(work.iloc[-1], rel=0.01)


def test_stronger_grains_spring_back_more(pressed, press):
    """At the same density, stronger grains have more pressure and spring-back, and less plastic
    work."""
    other = press(yield_strength=2e5)
    weak, strong = loop_of(pressed), loop_of(other)
    assert other.series["pressure"].max() > 1.2 * pressed.series["pressure"].max()
    spring_back = [1 - released / peak for _, peak, released in (weak, strong)]
    assert spring_back[1] > 1.3 * spring_back[0]
    permanent = [released - touch for touch, _, released in (weak, strong)]
    assert permanent[1] < 0.8 * permanent[0]
    share = [
        (run.series["plastic"] / run.series["wallwork"].max()).iloc[-1] for run in (pressed, other)
    ]
    assert share[1] < 0.8 * share[0]


def test_elastic_smooth_grains_recover(press):
    """Without yield and friction the loop closes, and the work of the punch is recovered.

    Without damping, up to 5 % of the work remains as motion, so the check of a quasi-static stroke
    fails. With yield, 75 % of the work is not recovered.
    """
    run = press(yield_strength=1e18, coefficient_of_friction=0, release=0.6)
    assert any("kinetic energy / elastic energy" in check.name for check in run.analysis.failed)
    work = run.series["wallwork"]
    assert run.series["plastic"].max() == 0
    assert abs(work.iloc[-1]) < 0.05 * work.max()
    touch, _, released = loop_of(run)
    assert released - touch < 0.01


def test_wrong_force_is_noticed(pressed):
    """A force that is wrong by 1 % fails the check of the work of the punch."""
    series = read_series(pressed.folder)
    series["force"] *= 1.01
    (check,) = pressed.deck.analyse(series).failed
    assert check.name == "relative difference between the work of the punch and force times travel"


def test_punch_that_stays_is_noticed(pressed):
    series = read_series(pressed.folder)
    loaded = series.iloc[: int(series["force"].argmax()) + 2]
    failed = pressed.deck.analyse(loaded).failed
    assert any("pressure at the end" in check.name for check in failed)


def test_heckels_line():
    """The fit of Heckel's equation ln(1/(1 - D)) = K p + A recovers K and A from exact data.

    D is the relative density and p the pressure.
    """
    pressure = np.linspace(0, 1e5, 50)
    density = 1 - np.exp(-(0.8 + 4e-6 * pressure))
    assert heckel_line(density, pressure) == pytest.approx((4e-6, 0.8), rel=1e-9)


def test_punch_that_never_touches_is_noticed(pressed):
    series = read_series(pressed.folder).assign(force=0.0)
    with pytest.raises(ValueError, match="the punch does not touch"):
        pressed.deck.analyse(series)


def test_punch_covers_the_die():
    """The punch is a triangle; the midpoints of its sides lie on the circle of the die."""
    corners = make_punch.triangle()
    assert np.linalg.norm((corners + np.roll(corners, 1, axis=0)) / 2, axis=1) == pytest.approx(1)


def test_stroke_begins_at_zero(pressed):
    """Time and energies count from the start of the stroke, without the filling of the die."""
    first: pd.Series = pressed.series.iloc[0]
    assert first[["time", "plastic", "friction", "wallwork", "drift", "punch_work"]].eq(0).all()
