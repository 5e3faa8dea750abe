# SPDX-License-Identifier: GPL-2.0-or-later
"""Readers of complete and truncated files of LIGGGHTS."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from plastigran.engine.dumps import DumpError, TruncatedFileWarning, read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import inputs_folder, run_deck
from plastigran.experiments.collision import CollisionError, measure


@pytest.fixture(scope="module")
def pair_run(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("pair")
    run_deck("collision/two_spheres.in", {}, folder)
    return folder


@pytest.fixture(scope="module")
def mesh_run(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("mesh")
    run_deck("collision/sphere_mesh.in", {}, folder)
    return folder


def test_the_columns_of_a_dump_are_those_of_the_deck(pair_run):
    table = read_dump(pair_run / "trajectory.dump")
    deck = (inputs_folder() / "collision/parts/record.in").read_text().replace("&\n", " ")
    named = re.search(r"trajectory\.dump\s+(.*)", deck)[1].split()
    assert list(table.columns) == ["step", *(name.removeprefix("v_") for name in named)]
    assert (table.groupby("step").size() == 2).all()
    assert table["time"].to_numpy() == pytest.approx(table["step"].to_numpy() * 4e-6, rel=1e-12)
    assert table.loc[0, "radius"] == 0.1  # all digits are kept


def test_pair_contacts_match_the_trajectory(pair_run):
    """Overlap and force of the contact dump agree with the trajectory."""
    contacts = read_dump(pair_run / "contacts.dump").set_index("step")
    assert list(contacts.columns) == [f"contacts[{k}]" for k in range(1, 14)]
    atom = read_dump(pair_run / "trajectory.dump").query("id == 1").set_index("step")
    loop = measure(pair_run / "trajectory.dump").loop
    touching = (loop["force"] > 0).to_numpy()
    shared = atom.index[touching]
    assert np.isin(shared, contacts.index).all()
    force, overlap = contacts.loc[shared, "contacts[10]"], contacts.loc[shared, "contacts[13]"]
    assert force.abs().to_numpy() == pytest.approx(atom.loc[shared, "fx"].abs().to_numpy())
    assert overlap.to_numpy() == pytest.approx(loop["overlap"].to_numpy()[touching], rel=1e-9)


def test_wall_contacts(mesh_run):
    contacts = read_dump(mesh_run / "contacts.dump")
    assert (contacts["contacts[9]"] == 1).all()  # ID of the sphere
    assert contacts["contacts[1]"].to_numpy() == pytest.approx(0, abs=1e-12)  # contact point
    force = contacts["contacts[10]"]
    assert force.max() == pytest.approx(measure(mesh_run / "trajectory.dump").force_max)


@pytest.mark.parametrize("part", ["pair_contacts.in", "wall_contacts.in"])
def test_labels_repeat_the_fields_of_the_compute(part):
    text = (inputs_folder() / "collision/parts" / part).read_text()
    fields = re.search(r"/gran/local (.*)", text)[1].split()
    kind, *labelled = re.search(r'label "(.*?)"', text)[1].split()
    assert labelled == fields
    assert kind.lower() in part


def test_thermo(pair_run):
    table = read_thermo(pair_run / "log.liggghts")
    assert {"run", "step", "timestep", "kinetic_energy"} <= set(table.columns)
    assert table["step"].iloc[0] == 0
    before, after = table["kinetic_energy"].iloc[[0, -1]]
    restitution = measure(pair_run / "trajectory.dump").coefficient_of_restitution
    assert after / before == pytest.approx(restitution**2, rel=1e-9)


@pytest.mark.parametrize("keep", [0.31, 0.5, 0.77, 0.998])
def test_truncated_dump_is_read_as_far_as_it_is_whole(pair_run, tmp_path, keep):
    text = (pair_run / "trajectory.dump").read_text()
    cut = tmp_path / "cut.dump"
    cut.write_text(text[: int(keep * len(text))])
    with pytest.warns(TruncatedFileWarning, match="Only the frames before it were read"):
        table = read_dump(cut)
    whole = read_dump(pair_run / "trajectory.dump")
    assert 0 < len(table) < len(whole)
    assert table.equals(whole.iloc[: len(table)])
    assert (table.groupby("step").size() == 2).all()


def test_every_cut_is_noticed(pair_run, tmp_path):
    """If the file ends anywhere in the third frame, two frames are read, with a warning."""
    text = (pair_run / "trajectory.dump").read_text()
    starts = [match.start() for match in re.finditer("ITEM: TIMESTEP", text)]
    cut = tmp_path / "cut.dump"
    for end in range(starts[2] + 1, starts[3]):
        cut.write_text(text[:end])
        with pytest.warns(TruncatedFileWarning):
            assert len(read_dump(cut)) == 4


def test_truncated_log(pair_run, tmp_path):
    text = (pair_run / "log.liggghts").read_text()
    cut = tmp_path / "cut.liggghts"
    cut.write_text(text[: text.index("Loop time")])
    with pytest.warns(TruncatedFileWarning, match="ends within run 0"):
        assert len(read_thermo(cut)) > 1


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no complete frame"),
        ("id x y\n1 2 3\n", r"line 1: expected 'ITEM: TIMESTEP', found 'id x y'"),
        ("ITEM: TIMESTEP\nnought\n", "a frame header is unreadable"),
        ("ITEM: TIMESTEP\n0\nITEM: ATOMS id\n", "line 3: expected 'ITEM: NUMBER OF'"),
    ],
)
def test_not_a_dump(tmp_path, text, said):
    path = tmp_path / "other.txt"
    path.write_text(text)
    with pytest.raises(DumpError, match=said):
        read_dump(path)


def test_ragged_rows(pair_run, tmp_path):
    lines = (pair_run / "trajectory.dump").read_text().splitlines(keepends=True)
    lines[9] = " ".join(lines[9].split()[:-2]) + "\n"
    path = tmp_path / "ragged.dump"
    path.write_text("".join(lines))
    with pytest.raises(DumpError, match="step 0 has fewer than 17 columns"):
        read_dump(path)


def test_log_without_output(tmp_path):
    path = tmp_path / "log.liggghts"
    path.write_text("units si\n")
    with pytest.raises(DumpError, match="no thermodynamic output"):
        read_thermo(path)


def test_unfinished_collision(pair_run):
    table = read_dump(pair_run / "trajectory.dump")
    with pytest.raises(CollisionError, match="still in contact in the last frame"):
        measure(table[table["step"] < 100])
    with pytest.raises(CollisionError, match="never touch"):
        measure(table[table["step"] < 1])
    with pytest.raises(CollisionError, match="already in contact in the first frame"):
        measure(table[table["step"] > 20])
    with pytest.raises(CollisionError, match="no column fx"):
        measure(table.drop(columns="fx"))
