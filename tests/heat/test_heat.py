# SPDX-License-Identifier: GPL-2.0-or-later
"""Heat from contact dissipation, compared with the energy balance, theory, ranks and restarts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import EngineError, run_deck
from plastigran.materials import RIGID

DECKS = Path(__file__).parent / "decks"
LEDGER_DECKS = DECKS.parents[1] / "ledger" / "decks"
CAPACITY = 900.0  # heat capacity of the particles in the decks [J/kg/K]
HEATS = ["heat", "hplastic", "hfric", "hwalls", "hstored"]
EVERY_MODEL = {"tangential": "history", "rolling": "epsd2", "damping": "on"}
FILE_ERROR = 1e-9  # relative to the total heat; ranks and restarts sum in another order


def warm(deck: str, folder: Path, ranks: int = 1, **variables) -> pd.DataFrame:
    """Run a deck; return the terms of energy balance and heat [J] by line of the log."""
    variables = {"decks": LEDGER_DECKS, "heat_decks": DECKS, **variables}
    run_deck(DECKS / f"{deck}.in", variables, folder, ranks=ranks)
    return read_thermo(folder / "log.liggghts")


def temperatures(folder: Path) -> pd.Series:
    """Return the temperature rise of the particles [K] by ID, at the last output."""
    table = read_dump(folder / "warmth.dump")
    return table[table["step"] == table["step"].max()].set_index("id")["Temp"]


def dissipated(table: pd.DataFrame) -> pd.Series:
    return table["plastic"] + table["friction"] + table["viscous"]


@pytest.mark.parametrize("geometry", ["pair", "plane", "mesh", "pushing", "shearing"])
def test_an_impact_warms_by_its_work(geometry, tmp_path):
    """All work that an impact dissipates becomes heat of the bodies or is stored in the material.

    Heats computed from temperatures have a relative tolerance of 1e-9, because temperatures
    accumulate round-off over the steps.
    """
    end = warm("impact", tmp_path, geometry=geometry, **EVERY_MODEL).iloc[-1]
    work = dissipated(end)
    assert min(end["plastic"], end["viscous"]) > 0.1 * work and end["friction"] > 0.01 * work
    given = end["hplastic"] + end["hfric"]
    assert given + end["hwalls"] + end["hstored"] == pytest.approx(work, rel=1e-12)
    assert end["heat"] == pytest.approx(given, rel=1e-9)
    mass = read_dump(tmp_path / "warmth.dump")["mass"].iloc[0]
    assert CAPACITY * mass * temperatures(tmp_path).sum() == pytest.approx(given, rel=1e-9)
    # The rigid wall takes half of the work that is not plastic.
    lossy, all_plastic = end["friction"] + end["viscous"], 0.9 * end["plastic"]
    assert end["hplastic"] == pytest.approx(all_plastic, rel=1e-12)
    assert end["hfric"] == pytest.approx(lossy if geometry == "pair" else lossy / 2, rel=1e-12)


def test_the_rise_of_temperature_is_the_predicted_one(law_between, aluminium, tmp_path):
    """An impact at speed v on a rigid wall heats a sphere by 0.9 v^2 (1 - e^2)/(2 c), for any size.

    0.9 is the Taylor-Quinney factor, e the restitution of the law, and c the heat capacity
    [J/kg/K]. The relative tolerance 1e-3 is the error of restitution due to the time step.
    """
    warm("impact", tmp_path, geometry="plane", tangential="off", slip=0.0, law="thornton")
    law = law_between("thornton", laws.combine(aluminium.body(), RIGID))
    restitution = law.central_impact(0.1, 11.3, 0.1).coefficient_of_restitution
    rise = 0.9 * 0.1**2 * (1 - restitution**2) / (2 * CAPACITY)
    assert temperatures(tmp_path)[1] == pytest.approx(rise, rel=1e-3)


def test_equal_bodies_share_the_heat(tmp_path):
    """Each of two equal bodies gets half of the heat, also in a moving frame of reference.

    The temperatures in both frames agree to 1e-6, because the round-off of positions and velocities
    differs.
    """
    warm("impact", tmp_path / "rest", **EVERY_MODEL)
    warm("impact", tmp_path / "drift", common=1.0, **EVERY_MODEL)
    for folder in ("rest", "drift"):
        rise = temperatures(tmp_path / folder)
        assert rise[1] == pytest.approx(rise[2], rel=1e-9)
    same = temperatures(tmp_path / "rest")[1]
    assert temperatures(tmp_path / "drift")[1] == pytest.approx(same, rel=1e-6)


def test_the_weaker_body_takes_the_plastic_work(tmp_path):
    """Plastic work, times the Taylor-Quinney factor of the weaker body, heats the weaker body.

    Friction heats both bodies.
    """
    table = warm("impact", tmp_path, other_type=2, factors="0.8 0.5", capacity="900 900")
    end, rise = table.iloc[-1], temperatures(tmp_path)
    assert end["hstored"] == pytest.approx(0.2 * end["plastic"], rel=1e-12)
    masses = read_dump(tmp_path / "warmth.dump").groupby("id")["mass"].first()
    heats = CAPACITY * masses * rise
    assert heats[2] == pytest.approx(end["friction"] / 2, rel=1e-9)
    assert heats[1] == pytest.approx(end["friction"] / 2 + 0.8 * end["plastic"], rel=1e-9)


def test_heating_changes_no_motion(tmp_path):
    """The motion is bitwise identical with heat and energy balance and without both."""
    for case, changes in {
        "none": {"warming": "off", "ledger": "off"},
        "warm": {"warming": "on"},
    }.items():
        variables = {"decks": LEDGER_DECKS, "heat_decks": DECKS, "every": 10, **changes}
        run_deck(DECKS / "impact.in", variables, tmp_path / case)
    motions = [(tmp_path / case / "motion.dump").read_bytes() for case in ("none", "warm")]
    assert motions[0] == motions[1] and len(motions[0]) > 5000


@pytest.fixture(scope="module")
def bed(tmp_path_factory) -> tuple[Path, pd.DataFrame]:
    """A bed of 80 grains that comes to rest, with friction, damping and conduction."""
    folder = tmp_path_factory.mktemp("bed")
    return folder, warm("bed", folder)


def test_a_bed_warms_by_its_work(bed):
    """In a bed, the heat equals the dissipated work at every line of the log.

    The heat of the grains agrees to 1e-9 of its largest value, because temperatures are summed over
    steps and grains.
    """
    folder, table = bed
    work = dissipated(table)
    heat = table[HEATS[1:]].sum(axis=1)
    assert (heat - work).abs().max() < 1e-12 * work.max()
    given = table["hplastic"] + table["hfric"]
    assert (table["heat"] - given).abs().max() < 1e-9 * given.max()
    assert given.iloc[-1] > 0.5 * work.max() and table["hwalls"].iloc[-1] > 0.05 * work.max()
    assert (temperatures(folder) > 0).all()


@pytest.mark.parametrize(("ranks", "grid"), [(2, "2 1"), (4, "2 2")])
def test_ranks_warm_alike(bed, ranks, grid, tmp_path):
    """A bed heats alike on one, two and four ranks during the first 1000 steps.

    Ranks sum in another order. Later, collisions multiply this round-off.
    """
    table = warm("bed", tmp_path, ranks, grid=grid, before=1000, after=0)
    table = table[table["run"] == 0]
    whole = bed[1].iloc[: len(table)]
    assert table["hplastic"].iloc[-1] > 0 and table["hfric"].iloc[-1] > 0
    scale = whole["heat"].max()
    assert np.abs(table[HEATS] - whole[HEATS]).to_numpy().max() < FILE_ERROR * scale
    given = table["hplastic"] + table["hfric"]
    assert (table["heat"] - given).abs().max() < FILE_ERROR * scale


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_restart_keeps_the_heat(bed, ranks, tmp_path):
    folder, whole = bed
    restart = folder / "middle.restart"
    table = warm("bed_restart", tmp_path, ranks, restart=restart, after=1000)
    second = whole[whole["run"] == 1].iloc[: len(table)]
    assert len(table) == 3
    scale = whole["heat"].max()
    difference = table[HEATS].to_numpy() - second[HEATS].to_numpy()
    assert np.abs(difference).max() < FILE_ERROR * scale


def run_bed_with(lines: str, folder: Path) -> str:
    """Run one step of the bed with `lines` instead of its commands for heat; return the log."""
    head = (DECKS / "bed.in").read_text().split("timestep        ${timestep}")[0]
    deck = folder / "changed.in"
    deck.write_text(f"{head}\n{lines}\nrun 1\n")
    return run_deck(deck, {"decks": LEDGER_DECKS, "heat_decks": DECKS}, folder)


def test_a_misspelt_factor_is_named(tmp_path):
    """A misspelt name of the Taylor-Quinney factor gives a warning.

    Without it, the user would not notice that the default factor 0.9 is used.
    """
    factor = "fix f all property/global taylorQuinneyFaktor peratomtype 0.5"
    log = run_bed_with(factor + "\ninclude ${heat_decks}/warming_on.in", tmp_path)
    message = (
        "property taylorQuinneyFaktor is not used. Possible misspelling of taylorQuinneyFactor"
    )
    assert log.count(message) == 1


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("fix w all heat/dissipation 0.9", "fix w heat/dissipation: unknown word 0.9"),
        ("fix w some heat/dissipation", "its group is some; it must be all"),
        (
            "fix w all heat/dissipation\nfix v all heat/dissipation",
            "fix w heat/dissipation: fix v heats the particles already",
        ),
        ("fix w all heat/dissipation", "Add `fix ID all heat/gran initial_temperature T`"),
        (
            "fix f all property/global taylorQuinneyFactor peratomtype 1.2\n"
            "fix w all heat/dissipation",
            "taylorQuinneyFactor is 1.2; it must be between 0 and 1 (atom type 1)",
        ),
    ],
)
def test_a_wrong_line_is_named(line, words, tmp_path):
    with pytest.raises(EngineError) as error:
        run_bed_with(f"group some id 1\n{line}", tmp_path)
    assert words in str(error.value)
