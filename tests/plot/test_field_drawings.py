# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the drawings of meshes and fields, and of movies."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

from plastigran.plot.fields import draw_field, draw_mesh
from plastigran.plot.movie import Movie, save_movie
from plastigran.plot.style import subplots

#: Corners of a mesh of two adjacent squares.
VERTICES = np.array([[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]], float)
QUADS = np.array([[0, 1, 4, 3], [1, 2, 5, 4]])


@pytest.mark.parametrize(("mirror", "left"), [(True, -2), (False, 0)])
def test_field_is_mirrored_at_the_axis(mirror, left):
    _, axes = subplots(figsize=(3, 2))
    levels = [0, 1, 2]
    contours = draw_field(axes, VERTICES, QUADS, VERTICES[:, 0], levels, mirror=mirror)
    assert axes.dataLim.x0 == left
    assert axes.dataLim.x1 == 2
    assert list(contours.levels) == levels


def test_common_side_is_drawn_once_and_through_its_middle_node():
    _, axes = subplots(figsize=(3, 2))
    middles = np.array([[0.5, 0], [1, 0.5], [0.5, 1.2], [0, 0.5], [1.5, 0], [2, 0.5], [1.5, 1]])
    points = np.concatenate([VERTICES, middles])
    quads = np.hstack([QUADS, 6 + np.array([[0, 1, 2, 3], [4, 5, 6, 1]])])
    draw_mesh(axes, points, quads)
    (lines,) = axes.collections
    assert len(lines.get_paths()) == 7
    drawn = np.concatenate([path.vertices for path in lines.get_paths()])
    assert np.isclose(drawn, [0.5, 1.2]).all(axis=1).sum() == 1


def test_movie_has_all_frames(tmp_path):
    figure, axes = subplots(figsize=(1, 1))
    (point,) = axes.plot([0], [0], "o")
    movie = Movie(figure, 4, lambda k: point.set_data([k / 100], [0]), rate=10)
    with Image.open(save_movie(movie, tmp_path / "deep" / "point.gif")) as written:
        assert written.n_frames == 4
        assert written.info["duration"] == 100
