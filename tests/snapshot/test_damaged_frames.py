# SPDX-License-Identifier: GPL-2.0-or-later
"""Frames that hold no grains, as of a deck that inserts them, and frames that cannot be read whole:
the others are shown.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import imageio.v3 as iio
import pytest
import pyvista
from pressed_pairs import EMPTY, press_pairs
from test_vtk import read_run

from plastigran.bulk.vtk import write_vtk
from plastigran.cli import main
from plastigran.plot.frame_files import DamagedFrame, SnapshotError, find_frames, read_vtk
from plastigran.plot.grain_movie import save_grain_movie
from plastigran.plot.snapshot import draw

KINDS = ("grains", "contacts", "mesh")


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> Path:
    """Folder of a run with three frames."""
    return press_pairs(tmp_path_factory.mktemp("run"))


@pytest.fixture
def run(whole, tmp_path) -> Path:
    """A copy of it, to be broken."""
    return Path(shutil.copytree(whole, tmp_path / "run"))


def empty(run: Path, *steps: int) -> None:
    """Make frames as the engine writes them before there are grains."""
    for step in steps:
        for kind in ("grains", "contacts"):
            (run / "frames" / f"{kind}_{step}.vtk").write_text(EMPTY)


def cut(file: Path, share: float) -> None:
    """Leave so much of a file."""
    content = file.read_bytes()
    file.write_bytes(content[: int(share * len(content))])


@pytest.mark.parametrize("what", [[], ["--contacts"]])
def test_a_movie_begins_before_there_are_grains(run, what, tmp_path, capfd):
    """Its first picture has the walls alone."""
    empty(run, 0)
    movie = tmp_path / "grains.gif"
    assert main(["snapshot", str(run), *what, "--movie", str(movie)]) == 0
    pictures = (iio.imread(movie, plugin="pillow")[..., :3] < 250).any(axis=-1)
    assert len(pictures) == 3
    assert 0 < pictures[0].sum() < 0.7 * pictures[2].sum()
    assert "plastigran:" not in capfd.readouterr().err


@pytest.mark.parametrize("what", [[], ["--contacts"]])
def test_a_picture_of_an_empty_frame_says_that_it_holds_no_grains(run, what, capsys):
    empty(run, 0)
    assert main(["snapshot", str(run), "--step", "0", *what]) == 1
    assert capsys.readouterr().err.endswith("grains_0.vtk contains no grains\n")


def test_a_movie_without_any_grains_is_refused(run, tmp_path):
    empty(run, 0, 50, 100)
    with pytest.raises(SnapshotError, match="no frame contains grains"):
        save_grain_movie(find_frames(run), tmp_path / "x.gif", progress=False)


def test_an_empty_frame_is_written_for_paraview(run, tmp_path):
    empty(run, 0)
    write_vtk(read_run(run, "thornton"), tmp_path / "vtk")
    for kind in KINDS:
        assert len(pyvista.get_reader(tmp_path / "vtk" / f"{kind}.pvd").time_values) == 3
    assert pyvista.read(tmp_path / "vtk" / "grains_50.vtp").n_points == 4
    assert (tmp_path / "vtk" / "grains_0.vtp").exists()


@pytest.mark.parametrize("kind", KINDS)
def test_a_file_cut_anywhere_is_known(run, kind):
    """Between two of its lines, where VTK itself notices little, and within its last number. What a
    mesh lacks at its end are numbers of its triangles.
    """
    file = run / "frames" / f"{kind}_100.vtk"
    text = file.read_text()
    needed = text.index("CELL_DATA") if kind == "mesh" else len(text)
    lines = [place + 1 for place, letter in enumerate(text[: needed - 1]) if letter == "\n"]
    for place in (0, *(place for place in lines if place < needed), len(text) - 5):
        file.write_text(text[:place])
        with pytest.raises(DamagedFrame, match=rf"{kind}_100\.vtk is cut short or damaged"):
            read_vtk(file)
    file.write_text(text)
    assert read_vtk(file).n_points


@pytest.mark.filterwarnings("default:.* is left out")
@pytest.mark.parametrize("share", [0, 0.5])
@pytest.mark.parametrize("kind", KINDS)
def test_a_damaged_frame_is_left_out_and_named(run, kind, share, tmp_path, capfd):
    cut(run / "frames" / f"{kind}_50.vtk", share)
    movie = tmp_path / "grains.gif"
    assert main(["snapshot", str(run), "--colour", "speed", "--movie", str(movie)]) == 0
    assert len(iio.imread(movie, plugin="pillow")) == 2
    said = f"{kind}_50.vtk is cut short or damaged; the frame of step 50"
    written = capfd.readouterr().err
    assert said in written and "ERROR" not in written
    with pytest.warns(UserWarning, match=f"{kind}_50.vtk is cut short or damaged"):
        write_vtk(read_run(run, "thornton"), tmp_path / "vtk")
    for each in KINDS:
        listed = pyvista.get_reader(tmp_path / "vtk" / f"{each}.pvd").time_values
        assert listed == pytest.approx([0, 100e-7])


@pytest.mark.parametrize("share", [0, 0.5])
def test_a_picture_of_a_damaged_frame_is_refused(run, share, capfd):
    cut(run / "frames" / "grains_50.vtk", share)
    assert main(["snapshot", str(run), "--step", "50"]) == 1
    (line,) = capfd.readouterr().err.splitlines()
    assert line.endswith("grains_50.vtk is cut short or damaged")
    draw(find_frames(run)[-1], run / "other.png", size=(200, 150))
    assert (run / "other.png").exists()


def test_no_whole_frame_is_said(run, tmp_path):
    for step in (0, 50, 100):
        cut(run / "frames" / f"grains_{step}.vtk", 0)
    with (
        pytest.warns(UserWarning, match="is cut short or damaged"),
        pytest.raises(SnapshotError, match="no frame is complete"),
    ):
        save_grain_movie(find_frames(run), tmp_path / "x.gif", progress=False)
