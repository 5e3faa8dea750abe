# SPDX-License-Identifier: GPL-2.0-or-later
"""Frames without grains, as from a deck that inserts grains later, and incomplete frames."""

from __future__ import annotations

import shutil
from pathlib import Path

import imageio.v3 as iio
import pytest
import pyvista
from pressed_pairs import EMPTY
from test_vtk import read_run

from plastigran.bulk.vtk import write_vtk
from plastigran.cli import main
from plastigran.plot.frame_files import DamagedFrame, SnapshotError, find_frames, read_frame_file
from plastigran.plot.grain_movie import save_grain_movie
from plastigran.plot.snapshot import draw

NAMES = ("grains", "contacts", "mesh")


@pytest.fixture
def run(pairs, tmp_path) -> Path:
    """Copy of the run that a test may damage."""
    return Path(shutil.copytree(pairs, tmp_path / "run"))


def empty(run: Path, *steps: int) -> None:
    """Replace frames by those that LIGGGHTS writes without grains."""
    for step in steps:
        for name in ("grains", "contacts"):
            (run / "frames" / f"{name}_{step}.vtk").write_text(EMPTY)


def truncate(file: Path, fraction: float) -> None:
    content = file.read_bytes()
    file.write_bytes(content[: int(fraction * len(content))])


@pytest.mark.parametrize("options", [[], ["--contacts"]])
def test_movie_starts_before_the_first_grains(run, options, tmp_path, capfd):
    """A movie may start before the first grains; its first picture then shows only the walls."""
    empty(run, 0)
    movie = tmp_path / "grains.gif"
    assert main(["snapshot", str(run), *options, "--movie", str(movie)]) == 0
    pictures = (iio.imread(movie, plugin="pillow")[..., :3] < 250).any(axis=-1)
    assert len(pictures) == 3
    assert 0 < pictures[0].sum() < 0.7 * pictures[2].sum()
    assert "plastigran:" not in capfd.readouterr().err


@pytest.mark.parametrize("options", [[], ["--contacts"]])
def test_picture_of_an_empty_frame_is_refused(run, options, capsys):
    empty(run, 0)
    assert main(["snapshot", str(run), "--step", "0", *options]) == 1
    assert capsys.readouterr().err.endswith(
        "grains_0.vtk contains no grains. Choose another frame\n"
    )


def test_movie_without_grains_is_refused(run, tmp_path):
    empty(run, 0, 50, 100)
    with pytest.raises(SnapshotError, match="no frame contains grains"):
        save_grain_movie(find_frames(run), tmp_path / "x.gif", progress=False)


def test_an_empty_frame_is_written_for_paraview(run, tmp_path):
    empty(run, 0)
    write_vtk(read_run(run, "thornton"), tmp_path / "vtk")
    for name in NAMES:
        assert len(pyvista.get_reader(tmp_path / "vtk" / f"{name}.pvd").time_values) == 3
    assert pyvista.read(tmp_path / "vtk" / "grains_50.vtp").n_points == 4
    assert (tmp_path / "vtk" / "grains_0.vtp").exists()


@pytest.mark.parametrize("name", NAMES)
def test_file_that_is_truncated_anywhere_is_damaged(run, name):
    """A frame file that is truncated anywhere is refused as damaged.

    VTK itself accepts many files that end between two lines. A mesh file may lack its last part,
    CELL_DATA, which contains the IDs of the triangles.
    """
    file = run / "frames" / f"{name}_100.vtk"
    text = file.read_text()
    needed = text.index("CELL_DATA") if name == "mesh" else len(text)
    lines = [place + 1 for place, letter in enumerate(text[: needed - 1]) if letter == "\n"]
    for place in (0, *(place for place in lines if place < needed), len(text) - 5):
        file.write_text(text[:place])
        with pytest.raises(DamagedFrame, match=rf"{name}_100\.vtk is cut short or damaged"):
            read_frame_file(file)
    file.write_text(text)
    assert read_frame_file(file).n_points


@pytest.mark.filterwarnings("default:.* is left out")
@pytest.mark.parametrize("fraction", [0, 0.5])
@pytest.mark.parametrize("name", NAMES)
def test_damaged_frame_is_left_out_and_named(run, name, fraction, tmp_path, capfd):
    truncate(run / "frames" / f"{name}_50.vtk", fraction)
    movie = tmp_path / "grains.gif"
    assert main(["snapshot", str(run), "--colour", "speed", "--movie", str(movie)]) == 0
    assert len(iio.imread(movie, plugin="pillow")) == 2
    errors = capfd.readouterr().err
    assert f"{name}_50.vtk is cut short or damaged; the frame of step 50" in errors
    assert "ERROR" not in errors
    with pytest.warns(UserWarning, match=f"{name}_50.vtk is cut short or damaged"):
        write_vtk(read_run(run, "thornton"), tmp_path / "vtk")
    for written in NAMES:
        listed = pyvista.get_reader(tmp_path / "vtk" / f"{written}.pvd").time_values
        assert listed == pytest.approx([0, 100e-7])


@pytest.mark.parametrize("fraction", [0, 0.5])
def test_picture_of_a_damaged_frame_is_refused(run, fraction, capfd):
    truncate(run / "frames" / "grains_50.vtk", fraction)
    assert main(["snapshot", str(run), "--step", "50"]) == 1
    (line,) = capfd.readouterr().err.splitlines()
    assert line.endswith("grains_50.vtk is cut short or damaged")
    draw(find_frames(run)[-1], run / "other.png", size=(200, 150))
    assert (run / "other.png").exists()


def test_run_without_complete_frames_is_refused(run, tmp_path):
    for step in (0, 50, 100):
        truncate(run / "frames" / f"grains_{step}.vtk", 0)
    with (
        pytest.warns(UserWarning, match="is cut short or damaged"),
        pytest.raises(SnapshotError, match="no frame is complete"),
    ):
        save_grain_movie(find_frames(run), tmp_path / "x.gif", progress=False)
