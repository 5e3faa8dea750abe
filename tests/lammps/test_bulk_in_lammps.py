# SPDX-License-Identifier: GPL-2.0-or-later
"""Bulk decks in LAMMPS: their checks, the same results as in LIGGGHTS, and restarts."""

from __future__ import annotations

import json
import shutil
import subprocess

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plastigran.bulk.checks import energy_input
from plastigran.bulk.decks import deck_class
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series
from plastigran.cli import main
from plastigran.engine.checkpoints import PATTERN, step_of
from plastigran.engine.lammps import lammps_path
from plastigran.engine.versions import HOSTS
from plastigran.plot.frame_files import DamagedFrame, find_frames, read_frame_file

#: Decks with the label of their short run, and changes of its settings. The work of the punch is
#: integrated over the rows of the log by the trapezoidal rule, so more rows reduce its error.
RUNS = {
    "cooling_gas": ("", {}),
    "compaction": ("", {"rows": 200}),
    "bed_impact-plate": ("plate", {}),
    "bed_impact-bed": ("bed", {}),
    "hopper": ("", {}),
    "ball_impact": ("", {}),
}


@pytest.fixture(scope="module")
def lammps_run(bulk_run):
    """`lammps_run(name)` returns the short run of a deck in LAMMPS, by its name in `RUNS`."""

    def run(name: str):
        deck, (label, changes) = name.partition("-")[0], RUNS[name]
        settings = deck_class(deck).briefs[label].settings
        return bulk_run(deck, {**settings, **changes, "host": "lammps"})

    return run


@pytest.mark.parametrize("name", RUNS)
def test_a_deck_passes_its_checks(name, lammps_run):
    run = lammps_run(name)
    assert run.passed and len(run.checks) > 2
    assert {name.partition("-")[0], "ledger"} <= run.figures.keys()
    record = json.loads((run.folder / "run.json").read_text())
    assert record["settings"]["host"] == record["versions"]["host"] == "lammps"
    release = record["versions"]["engine"].removeprefix("LAMMPS (").removesuffix(")")
    usage = subprocess.run([lammps_path(), "-h"], capture_output=True, text=True, check=True)
    assert usage.stdout.split("Simulator - ")[1].startswith(f"{release}\n")
    assert (run.folder / "log.lammps").exists()


@pytest.mark.parametrize(("deck", "label"), [("cooling_gas", ""), ("bed_impact", "plate")])
def test_both_hosts_give_the_same_series(deck, label, bulk_run):
    """The energies in both hosts differ by less than 1e-9 of the largest value. They are not
    identical, because the hosts write variables with different numbers of digits.
    """
    brief = deck_class(deck).briefs[label]
    settings = {**brief.settings, **(brief.start if deck == "cooling_gas" else {})}
    series = [bulk_run(deck, settings | {"host": host}).series for host in ("lammps", "liggghts")]
    for column in ("kinetic", "elastic", "plastic"):
        expected = series[1][column].to_numpy()
        assert expected.max() > 0
        assert_allclose(series[0][column], expected, rtol=0, atol=1e-9 * expected.max())


def test_the_bed_dissipates_as_in_liggghts(lammps_run, bulk_run):
    """The tangential springs of the hosts differ slightly, and a bed amplifies the difference. The
    energies dissipated by 125 grains and 16 shots in both hosts agree within 5 %, about the scatter
    between seeds.
    """
    settings = deck_class("bed_impact").briefs["bed"].settings
    lost = []
    for run in (lammps_run("bed_impact-bed"), bulk_run("bed_impact", settings)):
        last = run.series.iloc[-1]
        lost.append(last["plastic"] + last["friction"])
    assert_allclose(lost[0], lost[1], rtol=0.05)


@pytest.mark.parametrize("contact", [{"law": "thornton"}, {"law": "hertz", "ledger": "off"}])
def test_a_ball_moves_as_in_liggghts(contact, bulk_run):
    """Without friction, the displacements differ by less than 1e-9 of the largest one. Only
    round-off differs, because the hosts add the forces in different orders. With friction, the
    hosts compute the slip in contacts differently, so the displacements agree only within 1 %.
    Friction changes the displacement by more than three times this tolerance.
    """
    settings = {**deck_class("ball_impact").briefs[""].settings, **contact}
    settings |= {"ball_height": 0.0135, "duration": 0.0006, "rows": 10}
    displacements = {}
    for tangential, tolerance in ("off", 1e-9), ("history", 0.01):
        settings["tangential"] = tangential
        ours, expected = (
            bulk_run("ball_impact", settings | {"host": host}).series
            for host in ("lammps", "liggghts")
        )
        assert expected["velocity"].iloc[-1] > -4.0  # m/s; the bed has slowed the ball
        displacements[tangential] = expected["displacement"]
        scale = tolerance * expected["displacement"].abs().max()
        assert_allclose(ours["displacement"], expected["displacement"], rtol=0, atol=scale)
    change = (displacements["history"] - displacements["off"]).abs().max()
    assert change > 3 * scale  # the displacement depends on friction


@pytest.mark.parametrize(
    "name", ["cooling_gas", "bed_impact-plate", "hopper", "compaction", "ball_impact"]
)
def test_a_run_continues(name, lammps_run, tmp_path):
    """The energies after a restart agree with the run without restart. For the gas and for impacts
    on a plate, the tolerance is 1e-9 of the energy input, because sums have round-off. In beds,
    contacts amplify round-off, so only the first row after the restart is compared, with the
    tolerance 1e-6.
    """
    whole, deck = lammps_run(name), name.partition("-")[0]
    stopped = shutil.copytree(whole.folder, tmp_path / "stopped")
    checkpoints = sorted(stopped.glob(PATTERN), key=step_of)
    last = checkpoints[3 * len(checkpoints) // 4 - 1]
    for file in checkpoints[checkpoints.index(last) + 1 :]:
        file.unlink()
    rest = run_bulk(deck, {}, tmp_path / "rest", restart=stopped, show=False)
    assert rest.passed and len(rest.checks) == len(whole.checks)
    expected, continued = read_series(whole.folder), read_series(rest.folder)
    assert continued["step"].tolist() == expected["step"].tolist()
    rows = expected["step"] > step_of(last)
    if name in ("hopper", "compaction", "ball_impact"):
        rows &= rows.cumsum() == 1
    for column in ("kinetic", "plastic", "friction"):
        scale = (1e-9 if rows.sum() > 1 else 1e-6) * energy_input(expected)
        assert_allclose(continued[column][rows], expected[column][rows], rtol=0, atol=scale)


def test_frames_contain_the_grains_as_in_liggghts(bulk_run, tmp_path):
    """The grains in the frames of both hosts agree to 1e-5, because the files have at least six
    digits. A truncated frame of LAMMPS is rejected."""
    brief = deck_class("cooling_gas").briefs[""]
    settings = {**brief.settings, **brief.start, "frames": 2}
    runs = {host: bulk_run("cooling_gas", settings | {"host": host}) for host in HOSTS}
    frames = {host: find_frames(run.folder) for host, run in runs.items()}
    assert [f.step for f in frames["lammps"]] == [f.step for f in frames["liggghts"]]
    grains = {}
    for host, (*_, last) in frames.items():
        data = read_frame_file(last.grains)
        order = np.argsort(data["id"])
        columns = [data.points, data["v"], data["radius"], data["type"], data["f_plastic_work"]]
        grains[host] = [np.asarray(column, float)[order] for column in columns]
    for ours, theirs in zip(*grains.values(), strict=True):
        assert_allclose(ours, theirs, rtol=0, atol=1e-5 * abs(theirs).max())
    work = runs["lammps"].series["plastic"].iloc[-1]
    assert_allclose(grains["lammps"][-1].sum(), work, rtol=1e-6)
    whole, cut = frames["lammps"][-1].grains.read_bytes(), tmp_path / "grains_1.dump"
    for length in (0, 100, len(whole) - 200, len(whole) - 3, len(whole) - 1):
        cut.write_bytes(whole[:length])
        with pytest.raises(DamagedFrame):
            read_frame_file(cut)


def test_ranks_agree_on_the_first_impacts(bulk_run, tmp_path):
    """The energies on one and on two ranks differ by less than 1e-9 of the kinetic energy. The
    number of ranks changes the order in which forces are added, and so the round-off.
    """
    brief = deck_class("cooling_gas").briefs[""]
    settings = {**brief.settings, **brief.start, "host": "lammps"}
    one = bulk_run("cooling_gas", settings).series
    two = run_bulk("cooling_gas", settings, tmp_path / "run", ranks=2, show=False).series
    scale = 1e-9 * one["kinetic"].max()
    assert_allclose(two["kinetic"], one["kinetic"], rtol=0, atol=scale)
    assert_allclose(two["plastic"], one["plastic"], rtol=0, atol=scale)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (
            "drum --host lammps",
            "drum runs only in LIGGGHTS. Decks that run in LAMMPS: ball_impact, bed_impact,",
        ),
        (
            "hopper --host lammps -v contact_history=1",
            "contact_history is 1; in LAMMPS, it must be 0",
        ),
        (
            "hopper --host lammps -v tangential=no_history",
            "tangential is no_history; in LAMMPS, it must be off or history",
        ),
    ],
)
def test_settings_of_liggghts_are_refused(line, message, tmp_path, capsys):
    assert main(["bulk", *line.split(), "--output", str(tmp_path / "run")]) == 1
    assert message in capsys.readouterr().err
    assert not (tmp_path / "run").exists()
