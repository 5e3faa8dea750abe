# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of the VTK frames of a run, drawn without a screen."""

from __future__ import annotations

import re
from contextlib import suppress
from math import pi
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread

from plastigran.cli import main
from plastigran.plot.frame_files import SnapshotError, find_frames
from plastigran.plot.snapshot import draw


def drawn(path: Path) -> np.ndarray:
    """Return a mask of the pixels that are not white, left of the color scale, of a picture of 1000
    by 800 pixels.
    """
    return (imread(path)[220:, :840, :3] < 0.97).any(axis=2)


def halves(shown: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the parts left and right of the widest gap between columns."""
    columns = np.flatnonzero(shown.any(axis=0))
    middle = columns[np.argmax(np.diff(columns))] + 1
    return shown[:, :middle], shown[:, middle:]


def test_frames_are_found_by_step(pairs):
    frames = find_frames(pairs)
    assert [frame.step for frame in frames] == [0, 50, 100]
    assert frames[-1].contacts.name == "contacts_100.vtk"
    assert frames[-1].mesh.name == "mesh_100.vtk"


def test_grains_have_their_size(pairs, tmp_path):
    """A picture shows grains at their size: seen from above, each pair of grains is a disc.

    The areas of the two discs have a ratio of 4, within 3 % due to facets.
    """
    draw(
        find_frames(pairs)[-1], tmp_path / "top.png", colour="height", view="top", size=(1000, 800)
    )
    large, small = halves(drawn(tmp_path / "top.png"))
    width = np.flatnonzero(large.any(axis=0)).size
    assert large.sum() == pytest.approx(4 * small.sum(), rel=0.03)
    assert large.sum() == pytest.approx(pi / 4 * width**2, rel=0.03)


def test_force_chains_are_where_grains_touch(pairs, tmp_path):
    """A picture of force chains has a tube between the centers of grains in contact.

    The cross section of the tube is proportional to the force.

    LIGGGHTS computes forces of 0.049 and 0.024 N. The tolerances correspond to some pixels.
    """
    draw(find_frames(pairs)[-1], tmp_path / "c.png", contacts=True, view="front", size=(1000, 800))
    large, small = halves(drawn(tmp_path / "c.png"))
    high, low = (np.flatnonzero(tube.any(axis=1)).size for tube in (large, small))
    assert high == pytest.approx(3.9 / 1.9 * low, rel=0.05)
    assert large.sum() / high == pytest.approx(2**0.5 * small.sum() / low, rel=0.1)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--step", "70"], r"no frame of step 70 in .*\. Available steps: 0, 50, 100"),
        (["--colour", "red"], "invalid choice: 'red'"),
    ],
)
def test_wrong_options_are_refused(pairs, options, message, capsys):
    with suppress(SystemExit):  # argparse exits
        assert main(["snapshot", str(pairs), *options]) == 1
    assert re.search(message, capsys.readouterr().err)


def test_folder_without_frames_is_refused(tmp_path):
    with pytest.raises(SnapshotError, match=r"no frames .* -v frames=10"):
        find_frames(tmp_path)


def test_command_writes_into_the_run(pairs, capsys):
    assert main(["snapshot", str(pairs), "--colour", "speed", "--view", "front"]) == 0
    assert drawn(pairs / "figures" / "speed_front_100.png").any()
