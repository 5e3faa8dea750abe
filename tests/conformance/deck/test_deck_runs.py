# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of every bulk deck: files, energy balance, restart, ranks, another law."""

from __future__ import annotations

import shutil

import numpy as np
import pandas as pd

from plastigran.bulk import open as open_run
from plastigran.bulk.checks import FLOWS, LEDGER_CHECKS, energy_input
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series
from plastigran.engine.checkpoints import PATTERN, step_of
from plastigran.engine.deck import read_deck
from plastigran.engine.log import read_thermo
from plastigran.engine.process import run_deck

#: Columns whose values are zero except for the round-off of sums.
ROUNDING = ["drift", "inserted", "flow"]


def test_run_leaves_series_checks_figures_and_frames(case, whole):
    assert (
        pd.read_csv(whole.folder / "checks.csv")["name"].tolist() == whole.checks["name"].tolist()
    )
    pd.testing.assert_frame_equal(
        pd.read_csv(whole.folder / "series.csv"), whole.series, check_exact=True, check_dtype=False
    )
    assert {case.name, "ledger"} <= whole.figures.keys()
    for name in whole.figures:
        drawn = whole.folder / "figures" / name
        assert drawn.with_suffix(".png").read_bytes().startswith(b"\x89PNG")
        assert "<svg" in drawn.with_suffix(".svg").read_text()
    meshes = [file for file in read_deck(case.name, {}, ".").files if file.suffix == ".stl"]
    for kind in ["grains", "contacts", *(["mesh"] if meshes else [])]:
        assert len(list((whole.folder / "frames").glob(f"{kind}_[0-9]*.vtk"))) >= 2


def test_run_is_read_again_without_inputs(case, whole, tmp_path, monkeypatch):
    """A moved folder of a run gives bitwise identical results, also without the input scripts."""
    shutil.copytree(whole.folder, tmp_path / "moved")
    monkeypatch.setenv("PLASTIGRAN_INPUTS", str(tmp_path / "none"))
    moved = open_run(tmp_path / "moved")
    pd.testing.assert_frame_equal(moved.series, whole.series, check_exact=True, check_dtype=False)
    pd.testing.assert_frame_equal(moved.checks, whole.checks, check_exact=True)
    assert moved.passed == whole.passed and case.name in repr(moved)


def test_energy_balance_closes_and_grains_are_counted(whole):
    checks = whole.checks.set_index("name")
    assert checks.loc[list(LEDGER_CHECKS), "passed"].all()
    counted = checks[checks.index.str.startswith("grains ")]
    assert (counted["value"] == 0).all() and len(counted) == 1


def test_failed_checks_keep_the_analysis(case, whole):
    """If the last row has a large balance error and one grain too few, two checks fail.

    The analysis still returns its series and draws its figures.
    """
    series = read_series(whole.folder)
    grown = np.arange(len(series)) == len(series) - 1  # the first row may be zero
    allowed = whole.deck.ledger_limit(whole.series) * energy_input(whole.series)
    series.loc[grown, "drift"] += 2 * allowed
    series.loc[grown, "held" if "held" in series else "atoms"] -= 1
    analysis = whole.deck.analyse(series)
    failed = [check.name for check in analysis.failed]
    assert LEDGER_CHECKS[0] in failed and any(name.startswith("grains ") for name in failed)
    assert case.name in analysis.figures and len(analysis.series) == len(whole.series)


def test_killed_run_has_its_rows(whole, tmp_path):
    """A killed run keeps the rows of its log, but it has no checks and does not pass.

    The test removes the last log lines and the files with results.
    """
    shutil.copytree(whole.folder, tmp_path / "killed")
    for name in ("series.csv", "checks.csv"):
        (tmp_path / "killed" / name).unlink()
    log = tmp_path / "killed" / "log.liggghts"
    *before, last, _ = log.read_text().split("Loop time")
    log.write_text("Loop time".join([*before, "\n".join(last.splitlines()[:-3])]))
    killed = open_run(tmp_path / "killed")
    assert 0 < len(killed.series) < len(whole.series)
    assert killed.checks.empty and not killed.figures and not killed.passed
    assert "not finished" in repr(killed)


def test_restart_continues(case, whole, tmp_path):
    """A run that continues from the middle checkpoint agrees to the tolerance of its deck.

    If the tolerance is zero, results are bitwise identical, but sums over grains may differ by
    round-off, 1e-12.
    """
    stopped = tmp_path / "stopped"
    shutil.copytree(whole.folder, stopped)
    checkpoints = sorted(stopped.glob(PATTERN), key=step_of)
    for file in checkpoints[len(checkpoints) // 2 :]:
        file.unlink()
    step = step_of(checkpoints[len(checkpoints) // 2 - 1])
    rest = run_bulk(case.name, {}, tmp_path / "rest", restart=stopped, show=False)
    expected, continued = read_series(whole.folder), read_series(rest.folder)
    assert expected["step"].iloc[0] <= step < expected["step"].iloc[-1]
    assert continued["step"].tolist() == expected["step"].tolist()
    assert len(rest.checks) == len(whole.checks)
    columns = [name for name in expected if name not in ROUNDING]
    sums = [name for name in FLOWS if name in columns]
    scale = expected[columns].abs().max()
    scale[sums] = energy_input(expected)
    difference = (continued - expected)[columns].abs()
    if case.brief.restart == 0:
        exact = [name for name in columns if name not in sums]
        assert (difference[exact] == 0).all(axis=None)
    assert (difference <= max(case.brief.restart, 1e-12) * scale).all(axis=None)


def test_ranks_agree_on_the_first_impacts(case, tmp_path):
    """The energies of the first yielding impacts agree on one and on four MPI ranks.

    The tolerance is 1e-9 of the kinetic energy. Four ranks sum forces in another order, and each
    impact multiplies this difference by about ten.
    """
    settings, logs = {**case.brief.settings, **case.brief.start}, []
    for ranks in (1, 4):
        folder = tmp_path / str(ranks)
        folder.mkdir()
        case.deck_type.read(case.settings(**case.brief.start)).write_inputs(folder)
        run_deck(f"bulk/{case.name}.in", settings, folder, ranks)
        assert f"on {ranks} procs for" in (folder / "log.liggghts").read_text()
        logs.append(read_thermo(folder / "log.liggghts"))
    one, four = logs
    assert one["plastic"].max() > 1e-4 * one["kinetic"].max(), "no impacts yet"
    assert four["step"].tolist() == one["step"].tolist()
    for name in ("kinetic", "gravity", "elastic", "plastic", "friction"):
        scale = max(one[name].abs().max(), one["kinetic"].max())
        assert (four[name] - one[name]).abs().max() <= 1e-9 * scale


def test_another_law_runs(case, tmp_path):
    """A deck runs with LIGGGHTS' `hertz` without energy balance, or with `thornton`.

    The law is `thornton` if the deck does not allow `hertz`.
    """
    changes = {"law": "hertz", "ledger": "off"}
    try:
        case.deck_type.read(case.settings(**changes))
    except ValueError:
        changes = {"law": "thornton"}
    run = run_bulk(case.name, {**case.brief.settings, **changes}, tmp_path / "run", show=False)
    assert run.finished and run.deck.law == changes["law"] and case.name in run.figures
    assert np.ptp(run.series["kinetic"]) > 0
    with_ledger = "ledger" not in changes
    assert ("ledger" in run.figures) is with_ledger
    assert run.checks["name"].isin(LEDGER_CHECKS).any() == with_ledger
