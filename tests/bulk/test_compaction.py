# SPDX-License-Identifier: GPL-2.0-or-later
"""Die compaction in the engine: the punch's work, permanent densification, the elastic limit."""

from __future__ import annotations

import make_punch
import numpy as np
import pandas as pd
import pytest

from plastigran.bulk.decks.compaction import analyse, stroke
from plastigran.bulk.run import CheckError, finish, read_record, read_series, run_bulk
from plastigran.physics.heckel import Loop, heckel_line, measure_loop, punch_work

#: Sixty grains, in a die ten radii wide.
SMALL = {"layers": 5, "die_radius": 0.005, "duration": 0.15, "filling": 0.1}
SMALL |= {"rows": 100, "checkpoints": 10, "relative_density": 0.7, "release": 0.25}


def run(folder, ranks: int = 1, **changes) -> pd.DataFrame:
    return run_bulk("compaction", SMALL | changes, folder, ranks=ranks, show=False).table


def loop_of(table: pd.DataFrame) -> Loop:
    return measure_loop(table["relative_density"], table["pressure"])


@pytest.fixture(scope="module")
def pressed(tmp_path_factory):
    """Folder of a run whose checks, the punch's work among them, have passed."""
    folder = tmp_path_factory.mktemp("compaction") / "run"
    run(folder)
    return folder


@pytest.fixture(scope="module")
def table(pressed) -> pd.DataFrame:
    return pd.read_csv(pressed / "series.csv")


def test_loop(table):
    """Pressed to the density asked for; most of the densification stays, some springs back."""
    loop = loop_of(table)
    assert loop.peak == pytest.approx(0.7, abs=2e-3)  # the highest pressure, a row off the turn
    assert loop.touch < loop.released < loop.peak
    assert loop.permanent > 0.05 and loop.spring_back > 0.05
    # Of the punch's work at its lowest, a share comes back; the rest is plastic and friction.
    work = table["wallwork"]
    assert 0.5 * work.max() < work.iloc[-1] < 0.9 * work.max()
    taken = table["plastic"] + table["friction"]
    assert taken.iloc[-1] == pytest.approx(work.iloc[-1], rel=0.01)  # 1 %: gravity, motion


def test_stronger_grains_spring_back_more(table, tmp_path):
    """At the same density: higher pressure, more spring back, less stays, less plastic work."""
    weak = loop_of(table)
    other = run(tmp_path / "run", yield_strength=2e5)
    strong = loop_of(other)
    assert strong.pressure > 1.2 * weak.pressure
    assert strong.spring_back > 1.3 * weak.spring_back
    assert strong.permanent < 0.8 * weak.permanent
    share = [(t["plastic"] / t["wallwork"].max()).iloc[-1] for t in (table, other)]
    assert share[1] < 0.8 * share[0]


def test_elastic_smooth_grains_come_back(tmp_path):
    """Without yield and friction the loop closes: the punch gets its work back.

    All but what grains keep as motion that nothing damps, which breaks the check of slowness: 5 %,
    against 75 % that stay with grains that yield.
    """
    changes = {"yield_strength": 1e18, "coefficient_of_friction": 0, "release": 0.6}
    with pytest.raises(CheckError, match="kinetic over elastic energy"):
        run(tmp_path / "run", **changes)
    table = pd.read_csv(tmp_path / "run" / "series.csv")
    work = table["wallwork"]
    assert table["plastic"].max() == 0
    assert abs(work.iloc[-1]) < 0.05 * work.max()
    assert loop_of(table).permanent < 0.01


def test_ledger_may_be_off(tmp_path):
    """The engine's own hertz keeps no ledger; pressure and density are measured all the same."""
    table = run(tmp_path / "run", law="hertz", ledger="off", release=0.7)
    assert loop_of(table).pressure > 1e4


def test_wrong_force_is_noticed(pressed, tmp_path):
    """The punch's work misses by 1 % when its force does."""
    series = read_series(pressed)
    series["force"] *= 1.01
    with pytest.raises(CheckError, match="work of the punch against its force times travel"):
        finish(analyse(read_record(pressed)["settings"], series), tmp_path)


def test_fast_punch_is_noticed(tmp_path):
    with pytest.raises(CheckError, match="kinetic over elastic energy under load"):
        run(tmp_path / "run", duration=0.02, law="thornton", frames=1)
    for kind in ("grains", "contacts", "mesh"):
        assert list((tmp_path / "run" / "frames").glob(f"{kind}_*.vtk"))


def test_punch_that_stays_is_noticed(pressed, tmp_path):
    series = read_series(pressed)
    loaded = series.iloc[: int(series["force"].argmax()) + 2]
    with pytest.raises(CheckError, match="pressure left at the end"):
        finish(analyse(read_record(pressed)["settings"], loaded), tmp_path)


def test_restart(pressed, gone_on, tmp_path):
    """Gone on from half way: the punch to every digit, bed and ledger to rounding.

    1e-8: forces on a grain are summed in another order, and the bed multiplies that a thousandfold.
    """
    expected, found, step = gone_on(pressed, kept=6)
    assert 20 < (expected["step"] > step).sum() < 80
    scale = expected.abs().max().clip(lower=expected["wallwork"].max())
    assert ((found - expected).abs() <= 1e-8 * scale).all(axis=None)
    assert found["height"].tolist() == expected["height"].tolist()
    # The mesh is where its height says: else the punch's work would not be its force times travel.
    assert pd.read_csv(tmp_path / "rest" / "checks.csv")["passed"].all()


def test_ranks(table, tmp_path):
    """One bed on 1 and 2 ranks: as it lies, to 1e-6 of its energy; later, to its rearrangements.

    3 %: grains that slide do so a little earlier or later once rounding has grown.
    """
    other = run(tmp_path / "run", ranks=2)
    assert other["elastic"].iloc[0] == pytest.approx(table["elastic"].iloc[0], rel=1e-5)
    for name in ("plastic", "wallwork"):
        assert other[name].iloc[-1] == pytest.approx(table[name].iloc[-1], rel=0.03)
    assert loop_of(other).pressure == pytest.approx(loop_of(table).pressure, rel=0.03)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"law": "lim_stronge"}, "no law 'lim_stronge' for spheres"),
        ({"die_radius": 0.004}, r"die_radius is 0.004; it must lie between 0.004 and inf \[m\]"),
        ({"layers": 2}, "layers is 2; it must be 3 or more"),
        ({"relative_density": 0.5}, "relative_density is 0.5; it must lie between 0.5236 and 1"),
        ({"relative_density": 1}, "relative_density is 1; it must lie between 0.5236 and 1"),
        ({"release": 0}, "release is 0; it must lie between 0 and 1"),
        ({"duration": -1}, r"duration is -1; it must lie between 0 and inf \[s\]"),
        ({"gravitational_acceleration": 0}, "gravitational_acceleration is 0; it must lie between"),
        ({"rows": 10, "checkpoints": 3}, "checkpoints is 3; it must divide rows, 10"),
        ({"tangential": "on"}, "tangential is 'on'; it must be off, no_history, history"),
        ({"speed": 1}, "has no setting 'speed'; it takes law"),
    ],
)
def test_impossible_settings_are_refused_before_anything_runs(change, said, tmp_path):
    with pytest.raises(ValueError, match=said):
        run_bulk("compaction", change, tmp_path / "run", show=False)
    assert not (tmp_path / "run").exists()


def test_heckels_line_is_found():
    """Through data that lie on one."""
    pressure = np.linspace(0, 1e5, 50)
    density = 1 - np.exp(-(0.8 + 4e-6 * pressure))
    line = heckel_line(density, pressure)
    assert line.slope == pytest.approx(4e-6, rel=1e-9)
    assert line.intercept == pytest.approx(0.8, rel=1e-9)
    assert line.correlation == pytest.approx(1, abs=1e-9)


def test_loop_of_a_triangle():
    """Up from 0.5 to 0.7 and down to 0.6, all straight: touched and released at 1 % of the peak."""
    density = np.array([0.5, 0.5, 0.7, 0.6, 0.5])
    loop = measure_loop(density, [0.0, 0.0, 100.0, 0.0, 0.0])
    assert (loop.touch, loop.peak, loop.released) == pytest.approx((0.502, 0.7, 0.601))
    assert np.isnan(measure_loop(density[:3], [0.0, 0.0, 100.0]).released)
    with pytest.raises(ValueError, match="the punch meets no grain"):
        measure_loop(density, np.zeros(5))


def test_punch_work_of_a_spring():
    """k x^2/2, and nothing after the way back."""
    travel = np.concatenate([np.linspace(0, 1, 1001), np.linspace(1, 0, 1001)])
    work = punch_work(-travel, 5 * travel)
    assert work[1000] == pytest.approx(2.5)
    assert work[-1] == pytest.approx(0, abs=1e-12)


def test_punch_covers_the_die():
    """Its sides touch the circle it is scaled to: the die's rim lies on or within the triangle."""
    corners = make_punch.triangle()
    assert np.linalg.norm((corners + np.roll(corners, 1, axis=0)) / 2, axis=1) == pytest.approx(1)


def test_stroke_begins_at_nothing(pressed):
    """What filling has dissipated, and its drag, are not the stroke's."""
    first = stroke(read_record(pressed)["settings"], read_series(pressed)).iloc[0]
    assert first[["time", "plastic", "friction", "wallwork", "drift", "punch_work"]].eq(0).all()
