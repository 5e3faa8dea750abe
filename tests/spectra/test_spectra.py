# SPDX-License-Identifier: GPL-2.0-or-later
"""Collision spectra, compared with a replay of every step, the energy balance, ranks and
restarts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from replay import Motion, impacts, spectra

from plastigran.engine.dumps import DumpError, read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import EngineError, run_deck
from plastigran.engine.spectra import QUANTITIES, read_spectra, spectrum

DECKS = Path(__file__).parent / "decks"
TIMESTEP, PER_DECADE = 5e-6, 5  # values of the decks


def count(deck: str, folder: Path, ranks: int = 1, **variables) -> pd.DataFrame:
    """Run a deck; return its log."""
    run_deck(DECKS / f"{deck}.in", {"decks": DECKS, **variables}, folder, ranks=ranks)
    return read_thermo(folder / "log.liggghts")


def counted(folder: Path) -> pd.DataFrame:
    """Return the spectra that a run wrote, as counts and sums in the format of `replay.spectra`."""
    table = read_spectra(folder / "spectra.csv")
    positive = table["lower"].where(table["lower"] > 0)
    table["bin"] = np.round(PER_DECADE * np.log10(positive)).fillna(-np.inf)
    keys = ["step", "quantity", "with", "type", "other_type", "bin"]
    return table.set_index(keys)[["count", "sum"]].sort_index()


def compare(folder: Path, every: int, *dumps: Path) -> pd.DataFrame:
    """Check the spectra of a run against impacts from its recorded motion; return these impacts.

    Counts are equal. Sums agree to a relative 1e-9: positions have 17 digits, and a law may amplify
    an error of 1e-16 of the radius.
    """
    found = impacts(Motion(*(dumps or [folder / "motion.dump"])), TIMESTEP)
    expected = spectra(found, every, PER_DECADE)
    table = counted(folder)
    pd.testing.assert_index_equal(table.index, expected.index)
    assert (table["count"] == expected["size"]).all()
    assert table["sum"].to_numpy() == pytest.approx(expected["sum"].to_numpy(), rel=1e-9)
    return found


@pytest.fixture(scope="module")
def gas(tmp_path_factory) -> tuple[Path, pd.DataFrame]:
    """Folder and log of a run of a gas of 64 smooth spheres."""
    folder = tmp_path_factory.mktemp("gas")
    return folder, count("gas", folder)


def test_a_gas_is_counted_as_it_is_replayed(gas):
    folder, log = gas
    found = compare(folder, 400)
    assert len(found) == log["impacts"].iloc[-1] > 100
    assert set(found["with"]) == {"particle", "left", "right", "front", "back"}
    assert set(zip(found["type"], found["other_type"], strict=True)) >= {(1, 1), (1, 2), (2, 2)}
    assert found["normal_speed"].max() > 10 * found["normal_speed"].min()


@pytest.mark.parametrize(("ranks", "grid"), [(2, "1 1 2"), (4, "2 2 1")])
def test_ranks_count_what_happens(ranks, grid, tmp_path):
    """Several ranks count the impacts that `replay` finds in the recorded motion, also if grains
    change rank during contact.
    """
    count("gas", tmp_path, ranks, grid=grid, before=400, after=0)
    compare(tmp_path, 400)


@pytest.mark.parametrize("ranks", [1, 2])
def test_renumbered_grains_keep_their_impacts(ranks, tmp_path):
    """An impact counts once, also if LIGGGHTS renumbers its grains because others are deleted."""
    count("gas", tmp_path, ranks, between="removal", every=300)
    found = compare(tmp_path, 300)
    assert ((found["begin"] <= 600) & (found["end"] > 600)).sum() > 5


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_restart_continues_the_count(gas, ranks, tmp_path):
    """After a restart, the count continues with the current impacts and the unfinished table. The
    restarted run replaces the tables that the first run wrote after the restart point. Sums agree
    to a relative 1e-6: the restarted run adds forces in another order, and impacts amplify this
    round-off.
    """
    folder, _ = gas
    whole = (folder / "spectra.csv").read_text()
    (tmp_path / "spectra.csv").write_text(whole)
    count("gas_restart", tmp_path, ranks, restart=folder / "middle.restart")
    table, expected = counted(tmp_path), counted(folder)
    pd.testing.assert_index_equal(table.index, expected.index)
    assert (table["count"] == expected["count"]).all()
    assert table["sum"].to_numpy() == pytest.approx(expected["sum"].to_numpy(), rel=1e-6)


def test_the_energies_are_the_ledgers(tmp_path):
    """The dissipated energies of impacts and current contacts add up to the energy balance.

    The spheres have friction and damping. The relative difference is 3e-4: the last dashpot force
    and rolling torque of a contact also do work in the step after it.
    """
    models = {"tangential": "history", "rolling": "epsd2", "damping": "on"}
    log = count("gas", tmp_path, every=1200, **models)
    end = log.iloc[-1]
    lost = end["plastic"] + end["friction"] + end["viscous"]
    assert min(end["friction"], end["viscous"]) > 0.1 * lost
    assert end["enimpact"] + end["enother"] == pytest.approx(lost, rel=3e-4)
    table = spectrum(read_spectra(tmp_path / "spectra.csv"), "dissipated_energy")
    assert table["sum"].sum() == pytest.approx(end["enimpact"], rel=1e-12)
    assert end["enother"] > 0 and end["underway"] > 0


def test_a_mesh_is_one_wall(tmp_path):
    """A mesh counts as one wall: a sphere that slides from triangle to triangle has one contact.

    The sphere bounces some times before it slides.
    """
    run_deck(DECKS / "slide.in", {}, tmp_path)
    log = read_thermo(tmp_path / "log.liggghts")
    motion = read_dump(tmp_path / "motion.dump")
    touching = (motion["z"] < 0.005).to_numpy().astype(int)
    begins, ends = (np.flatnonzero(np.diff(touching) == sign) for sign in (1, -1))
    assert len(begins) == len(ends) + 1 and motion["x"].iloc[begins[-1]] < -0.01
    assert motion["x"].iloc[-1] > 0.02  # beyond the common edge of the triangles
    assert log["impacts"].iloc[-1] == len(ends) >= 2
    assert log["underway"].iloc[-1] == 1


def test_counting_changes_no_motion(tmp_path):
    """The motion is bitwise identical with and without collision spectra."""
    for state in ("on", "off"):
        count("gas", tmp_path / state, counted=state, before=300, after=0, tangential="history")
    on, off = ((tmp_path / name / "motion.dump").read_bytes() for name in ("on", "off"))
    assert on == off


def test_every_impact_has_every_quantity(gas):
    table = read_spectra(gas[0] / "spectra.csv")
    counts = {name: spectrum(table, name)["count"].sum() for name in QUANTITIES}
    assert set(counts.values()) == {gas[1]["impacts"].iloc[-1]}
    speeds = spectrum(table, "normal_speed")
    assert (speeds["lower"] * speeds["count"] <= speeds["sum"]).all()
    assert (speeds["sum"] <= speeds["upper"] * speeds["count"]).all()
    with pytest.raises(ValueError, match="one of normal_speed, dissipated_energy, largest_force"):
        spectrum(table, "speed")


def test_another_file_is_named(tmp_path):
    path = tmp_path / "other.csv"
    path.write_text("step,speed\n1,2\n")
    with pytest.raises(DumpError, match=r"other\.csv is not a table of collision spectra"):
        read_spectra(path)


def run_gas_with(lines: str, folder: Path) -> None:
    """Run the deck of the gas with `lines` instead of its commands for collision spectra."""
    deck = folder / "changed.in"
    gas = (DECKS / "gas.in").read_text().split("include         ${decks}/counting")[0]
    deck.write_text(f"{gas}\n{lines}\n")
    run_deck(deck, {"decks": DECKS}, folder)


def test_the_last_line_of_a_killed_run_is_dropped_when_it_is_cut(tmp_path):
    """An incomplete last line of a killed run is deleted from the file of the spectra.

    The step in it may be incomplete, too: `12` may be the beginning of 120000.
    """
    heading = "step,quantity,with,type,other_type,lower,upper,count,sum\n"
    row = "0,normal_speed,particle,1,1,0.1,0.2,3,0.5\n"
    (tmp_path / "spectra.csv").write_text(heading + row + row.rstrip())
    run_gas_with("fix s all collision_spectra 10 file spectra.csv", tmp_path)
    assert (tmp_path / "spectra.csv").read_text() == heading + row


def test_another_file_is_not_overwritten(tmp_path):
    (tmp_path / "spectra.csv").write_text("my own notes\n")
    with pytest.raises(EngineError, match=r"spectra\.csv is not a table of collision spectra"):
        run_gas_with("fix s all collision_spectra 10 file spectra.csv", tmp_path)
    assert (tmp_path / "spectra.csv").read_text() == "my own notes\n"


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        ("all collision_spectra", "EVERY is missing"),
        ("all collision_spectra 0 file x.csv", "EVERY is 0; it must be a positive number"),
        ("all collision_spectra 10", "`file FILE` is missing"),
        ("all collision_spectra 10 bins 5", "unknown word bins; possible: file, per_decade"),
        ("all collision_spectra 10 file x.csv per_decade -1", "per_decade is -1"),
        (
            "all collision_spectra 10 file x.csv per_decade 1001",
            "per_decade is 1001; it must be a whole number from 1",
        ),
        ("all collision_spectra 10 file no/such/x.csv", "cannot write no/such/x.csv (No such"),
        (
            "all collision_spectra 10 file x.csv\nfix t all collision_spectra 20 file x.csv",
            "fix s writes the file x.csv already",
        ),
        ("second collision_spectra 10 file x.csv", "its group is second; it must be all"),
    ],
)
def test_a_wrong_line_is_named(words, complaint, tmp_path):
    with pytest.raises(EngineError) as error:
        run_gas_with(f"fix s {words}", tmp_path)
    assert f"collision_spectra: {complaint}" in str(error.value)


def test_contacts_that_were_there_before_are_no_impacts(tmp_path):
    """A contact that exists when counting begins is not an impact."""
    deck = tmp_path / "two.in"
    deck.write_text(
        """
atom_style      granular
boundary        f f f
newton          off
communicate     single vel yes
region          box block -0.05 0.05 -0.05 0.05 -0.05 0.05 units box
create_box      1 box
fix youngs  all property/global youngsModulus peratomtype 2e11
fix poisson all property/global poissonsRatio peratomtype 0.3
fix strength all property/global yieldStrength peratomtype 3e8
pair_style      gran model thornton
pair_coeff      * *
create_atoms    1 single 0 0 0
create_atoms    1 single 0.00999 0 0
set group all diameter 0.01 density 7800
fix integrate   all nve/sphere
timestep        1e-7
run             200
fix spectra     all collision_spectra 10 file spectra.csv
thermo_style    custom step f_spectra[1] f_spectra[2]
thermo_modify   norm no
thermo          1000
run             1200
"""
    )
    run_deck(deck, {}, tmp_path)
    log = read_thermo(tmp_path / "log.liggghts")
    counted = log[log["step"] >= 200].drop_duplicates("step", keep="last")
    assert counted.iloc[:, -1].tolist() == [1, 0, 0]  # current contacts
    assert counted.iloc[:, -2].tolist() == [0, 0, 0]  # impacts
