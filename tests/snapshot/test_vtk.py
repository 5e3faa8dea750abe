# SPDX-License-Identifier: GPL-2.0-or-later
"""Frames for ParaView and OVITO, plastic work of contacts, and movies."""

from __future__ import annotations

from types import SimpleNamespace
from xml.etree import ElementTree

import imageio.v3 as iio
import numpy as np
import pandas as pd
import pytest
import pyvista
from pressed_pairs import press_pairs

from plastigran import laws
from plastigran.bulk.contact_works import plastic_works
from plastigran.bulk.deck import Analysis
from plastigran.bulk.decks import deck_class
from plastigran.bulk.grains import Grains
from plastigran.bulk.outcome import BulkRun
from plastigran.bulk.plan import plan_bulk
from plastigran.bulk.vtk import write_vtk
from plastigran.cli import main
from plastigran.engine.dumps import DumpError
from plastigran.materials import read_material
from plastigran.plot.frame_files import find_frames
from plastigran.plot.frames import grain_values
from plastigran.plot.grain_movie import save_grain_movie

#: Laws whose contact history starts with the largest overlap, and `vu_quoc_zhang`, whose history
#: does not.
LAWS = ("thornton", "universal", "vu_quoc_zhang")
STEPS = (0, 50, 100)


def read_run(folder, law):
    """Return the run of pressed_pairs.py as `open_run` returns the run of a deck."""
    deck = SimpleNamespace(grains=Grains(law, {}, read_material("soft_granules"), 2e-3))
    series = pd.DataFrame({"step": STEPS, "time": np.multiply(STEPS, 1e-7)})
    return BulkRun("pressed_pairs", folder, deck, Analysis(series))


@pytest.fixture(scope="module", params=LAWS)
def vtk(request, tmp_path_factory):
    """Folder of the VTK files of the two pairs of grains, for each law."""
    folder = press_pairs(tmp_path_factory.mktemp("run"), law=request.param, contact_history=1)
    write_vtk(read_run(folder, request.param), folder / "vtk")
    return folder / "vtk"


def test_plastic_work_of_a_contact_is_that_of_its_grains(vtk):
    """The plastic work of a contact is the sum over its two grains, which have no other contact.

    The relative tolerance is 1e-6, because the files have ten digits.
    """
    grains, contacts = (pyvista.read(vtk / f"{kind}_100.vtp") for kind in ("grains", "contacts"))
    work = dict(zip(grains["id"], grains["plastic_work"], strict=True))
    assert contacts.n_cells == 2
    for row in range(2):
        ends = [int(contacts[name][row]) for name in ("id1", "id2")]
        expected = sum(work[end] for end in ends)
        assert expected > 0
        assert contacts["plastic_work"][row] == pytest.approx(expected, rel=1e-6)


def test_columns_have_their_names(vtk):
    grains, contacts = (pyvista.read(vtk / f"{kind}_50.vtp") for kind in ("grains", "contacts"))
    assert {"id", "type", "radius", "velocity", "plastic_work"} <= set(grains.point_data)
    names = {"id1", "id2", "overlap", "force", "force_normal", "force_tangential", "plastic_work"}
    assert set(contacts.cell_data) == names
    for name in ("grains", "contacts", "mesh"):  # OVITO reads only uncompressed files
        assert "compressor" not in (vtk / f"{name}_50.vtp").read_text().partition("<Piece")[0]
    assert contacts["overlap"] == pytest.approx([1e-4, 1e-4], rel=0.01)


def test_series_lists_frames_by_time(vtk):
    for name in ("grains", "contacts", "mesh"):
        listed = pyvista.get_reader(vtk / f"{name}.pvd")
        assert listed.time_values == pytest.approx([step * 1e-7 for step in STEPS])
        for entry in ElementTree.parse(vtk / f"{name}.pvd").iter("DataSet"):
            assert (vtk / entry.get("file")).exists()


def test_without_history_there_is_no_plastic_work(pairs, tmp_path):
    write_vtk(read_run(pairs, "thornton"), tmp_path)
    contacts = pyvista.read(tmp_path / "contacts_100.vtp")
    assert "plastic_work" not in contacts.cell_data
    assert "overlap" in contacts.cell_data


@pytest.mark.parametrize("damage", ["a row", "another contact"])
def test_missing_contact_history_is_refused(damage, tmp_path):
    folder = press_pairs(tmp_path, contact_history=1)
    file = folder / "frames" / "memories_100.dump"
    text = file.read_text()
    head, last = text.rstrip("\n").rsplit("\n", 1)
    if damage == "a row":
        file.write_text(head.replace("ENTRIES\n2", "ENTRIES\n1") + "\n")
    else:
        file.write_text(f"{head}\n9{last}\n")
    with pytest.raises(DumpError, match=r"memories_100.dump and .* list different contacts"):
        write_vtk(read_run(folder, "vu_quoc_zhang"), folder / "vtk")


def test_command_writes_the_contacts_of_a_deck(bulk_run, tmp_path, capsys):
    """`plastigran vtk` writes the contacts of a hopper, also if some frames have no contacts."""
    settings = {**deck_class("hopper").briefs[""].settings, "frames": 2, "contact_history": 1}
    run = bulk_run("hopper", settings)
    assert main(["vtk", str(run.folder), "--output", str(tmp_path)]) == 0
    assert f"{tmp_path / 'contacts.pvd'}" in capsys.readouterr().out
    largest = max(tmp_path.glob("contacts_*.vtp"), key=lambda path: path.stat().st_size)
    contacts = pyvista.read(largest)
    overlapping = contacts["overlap"] > 0
    assert overlapping.sum() > 50
    assert (contacts["plastic_work"][overlapping] >= 0).all() and contacts["plastic_work"].max() > 0
    with pytest.raises(ValueError, match="contact_history is 2; it must lie from 0 to 1"):
        plan_bulk("hopper", settings | {"contact_history": 2}, tmp_path / "run")


def test_plastic_work_follows_from_history_and_overlap(yielding_law):
    """The plastic work from contact history and overlap equals that of the whole loading path.

    The path contains unloading and reloading.
    """
    grains = Grains(yielding_law, {}, read_material("aluminium_zv02"), 0.1)
    state = laws.LAWS[yielding_law].State()
    path = grains.contact_law().follow(0.05, np.array([5e-6, 2e-5, 1.2e-5, 1.5e-5]), state)
    work = plastic_works(grains, [0.05], [1.5e-5], [state.values()[0]])
    assert work[0] == pytest.approx(path["plastic_work"][-1], rel=1e-9)


@pytest.mark.parametrize("name", ["grains.gif", "grains.mp4"])
def test_movie_has_a_picture_of_every_frame(name, pairs, tmp_path):
    line = ["snapshot", str(pairs), "--colour", "speed", "--rate", "4"]
    assert main([*line, "--movie", str(tmp_path / name)]) == 0
    pictures = iio.imread(tmp_path / name, plugin="pyav" if name.endswith("mp4") else "pillow")
    assert pictures.shape[:3] == (len(STEPS), 720, 960)
    shown = (pictures[..., :3] < 200).any(axis=-1)
    assert all(0.005 < picture.mean() < 0.5 for picture in shown)


@pytest.mark.parametrize("colour", ["height", "radius", "speed"])
def test_frames_of_a_movie_have_one_scale(colour, pairs, tmp_path, monkeypatch, capsys):
    """The color scale starts at the smallest value of all frames, but at zero for speeds."""
    spans = []

    def draw(*_, span, **__):
        spans.append(span)
        return np.zeros((4, 4, 3), np.uint8)

    monkeypatch.setattr("plastigran.plot.grain_movie.draw", draw)
    frames = find_frames(pairs)
    save_grain_movie(frames, tmp_path / "x.gif", colour, progress=False)
    values = np.concatenate([grain_values(frame, colour) for frame in frames])
    least = 0.0 if colour == "speed" else values.min()
    assert spans == [(least, values.max())] * len(STEPS)
    assert spans[0][0] < spans[0][1]
    assert capsys.readouterr().err == ""


def test_wrong_movie_options_are_refused(pairs, capsys):
    assert main(["snapshot", str(pairs), "--movie", "grains.avi"]) == 1
    message = "grains.avi cannot be a movie: its name must end in .mp4 or .gif"
    assert message in capsys.readouterr().err
    assert main(["snapshot", str(pairs), "--rate", "3"]) == 1
    assert "--rate is 3, but has no effect without --movie" in capsys.readouterr().err
