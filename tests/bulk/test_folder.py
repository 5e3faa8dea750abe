# SPDX-License-Identifier: GPL-2.0-or-later
"""Folder of a bulk run: its files, overwriting of an earlier run, and damaged files."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

import plastigran as pg
from plastigran.bulk.decks import deck_class
from plastigran.bulk.folder import carry_files
from plastigran.bulk.run import run_bulk
from plastigran.engine.deck import read_deck
from plastigran.engine.dumps import DumpError
from plastigran.engine.process import EngineError, inputs_folder

SHORT = deck_class("cooling_gas").briefs[""].settings | {"frames": 2}


@pytest.fixture
def whole(bulk_run) -> Path:
    return bulk_run("cooling_gas", SHORT).folder


def test_folder_contains_deck_record_and_results(whole):
    record = json.loads((whole / "run.json").read_text())
    assert record["settings"]["side"] == "6" and record["settings"]["youngs_modulus"] == "9.6e10"
    assert record["versions"]["engine"].startswith("LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0")
    assert "sha256" in record["versions"]["plugin"] and record["versions"]["plastigran"]
    for file in read_deck("cooling_gas", SHORT, whole).files:
        kept = whole / "deck" / file.relative_to(inputs_folder())
        assert kept.read_text() == file.read_text()
    for name in (
        "log.liggghts",
        "screen.txt",
        "series.csv",
        "checks.csv",
        "figures/cooling_gas.svg",
    ):
        assert (whole / name).stat().st_size > 0


def test_frames_up_to_the_checkpoint_are_copied(tmp_path):
    """A continued run copies the complete frames before the step of its checkpoint.

    LIGGGHTS writes the later frames again.
    """
    box = "ITEM: BOX BOUNDS ff ff ff\n" + 3 * "0 1\n"
    frames = [
        f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n2\n{box}"
        f"ITEM: ATOMS id x\n1 0\n2 0.{step}\n"
        for step in (0, 50, 100)
    ]
    for name in ("earlier", "rest"):
        (tmp_path / name).mkdir()
    earlier, rest = (tmp_path / name / "grains.dump" for name in ("earlier", "rest"))
    earlier.write_text("".join(frames) + "ITEM: TIME")
    carry_files(earlier.parent, rest.parent, last=100)
    assert rest.read_text() == "".join(frames[:2])
    for length in range(1, len(frames[1])):  # a kill may cut the second frame anywhere
        earlier.write_text(frames[0] + frames[1][:-length])
        carry_files(earlier.parent, rest.parent, last=100)
        assert rest.read_text() == frames[0]


def test_results_are_not_overwritten_unless_forced(whole, tmp_path, monkeypatch):
    (tmp_path / "papers" / "figures").mkdir(parents=True)
    with pytest.raises(
        ValueError, match=r"contains files but no run.json, so --force does not overwrite it"
    ):
        run_bulk("cooling_gas", SHORT, tmp_path / "papers", force=True)
    folder = tmp_path / "run"
    shutil.copytree(whole, folder)
    (folder / "notes.txt").write_text("mine")
    (folder / "checkpoint.999999999.restart").write_bytes(b"of a longer run")
    (folder / "collision_spectra.csv").write_text("step\n")
    with pytest.raises(ValueError, match=r"contains results\. Choose another folder"):
        run_bulk("cooling_gas", SHORT, folder)
    assert (folder / "series.csv").read_bytes() == (whole / "series.csv").read_bytes()
    monkeypatch.setattr(
        "plastigran.bulk.run.run_deck", lambda *_, **__: (_ for _ in ()).throw(EngineError("stop"))
    )
    with pytest.raises(EngineError, match="stop"):
        run_bulk("cooling_gas", SHORT, folder, force=True)
    assert sorted(file.name for file in folder.iterdir()) == ["deck", "notes.txt", "run.json"]


@pytest.mark.parametrize(
    ("file", "damage", "message"),
    [
        ("run.json", lambda text: text.replace('"radius"', '"width"'), "run.json: .* radius"),
        ("log.liggghts", lambda text: None, "contains no log.liggghts"),
        ("log.liggghts", lambda text: text[:200], "log.liggghts: no thermodynamic output"),
        ("log.liggghts", lambda text: text.replace(" Atoms ", " Grains "), "log.liggghts .*atoms"),
        ("before.csv", lambda text: "time\n1\n", "before.csv is damaged: .*step"),
        ("before.csv", lambda text: "", "before.csv is damaged: No columns"),
    ],
)
def test_damaged_folder_is_refused(file, damage, message, whole, tmp_path):
    folder = tmp_path / "run"
    shutil.copytree(whole, folder)
    path = folder / file
    left = damage(path.read_text() if path.exists() else "")
    path.unlink() if left is None else path.write_text(left)
    with pytest.raises((DumpError, EngineError), match=f"{folder}.*{message}"):
        pg.open(folder)
