# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the field snapshots of a finite-element impact, and of the values for their plots."""

from __future__ import annotations

import attrs
import numpy as np
import pytest
from coarse_sphere import COARSE, METAL, RADIUS

from plastigran.fem.sphere.throw import throw
from plastigran.fem.stepping.snapshot import at_vertices


@pytest.fixture(scope="module")
def followed():
    """An impact with field snapshots; it ends half a Hertz contact time after the contact."""
    return throw(METAL, RADIUS, 0.02, attrs.evolve(COARSE, frames=10, free_steps=40))


def test_frames_are_spread_over_the_contact(followed):
    times = np.array(list(followed.snapshots))
    assert len(times) >= 10
    # There is one snapshot per tenth of Hertz' contact time. It may be one time step late, which is
    # an eightieth of the contact time.
    assert np.diff(times).max() < 1.2 * times[-1] / (len(times) - 1)
    forces = [frame.force for frame in followed.snapshots.values()]
    assert 0.9 * followed.force_max < max(forces) <= followed.force_max
    assert forces[-1] == 0


def test_corners_move_with_the_centre_of_mass(followed):
    frame = followed.snapshots[max(followed.snapshots)]
    history = followed.history
    approach = np.interp(max(followed.snapshots), history["time"], history["approach"])
    upper = frame.vertices[:, 1] > RADIUS  # far from the contact
    # The tolerance [m] covers the remaining vibration, some per cent of the displacement.
    assert -frame.displacement[upper, 1].mean() == pytest.approx(approach, abs=0.5e-6)


def test_restitution_by_nodes_swings_and_that_by_momentum_does_not(followed):
    free = followed.history[followed.history["time"] > followed.contact_time].iloc[2:]
    momentum, nodes = (free[name] / followed.speed for name in ("velocity", "nodal_velocity"))
    assert np.ptp(momentum) < 1e-6
    assert np.ptp(nodes) > 0.02
    assert nodes.mean() == pytest.approx(followed.coefficient_of_restitution, rel=0.03)
    assert followed.nodal_restitution == nodes.iloc[-1]


def test_values_at_corners_stay_within_those_of_the_gauss_points(plastic_pressing):
    top = plastic_pressing.snapshots[-2]
    mises = at_vertices(top, top.mises)
    assert len(mises) == len(top.vertices)
    assert top.mises.min() <= mises.min() < mises.max() <= top.mises.max()
    constant = at_vertices(top, np.full(len(top.mises), 3.0))
    assert constant == pytest.approx(np.full(len(top.vertices), 3.0))
    # For a linear field, the error is its change from a corner to the closest Gauss point, which is
    # less than half an element away.
    height = at_vertices(top, top.positions[:, 1])
    longest = np.ptp(top.vertices[top.quads], axis=1).max()
    assert np.abs(height - top.vertices[:, 1]).max() < 0.5 * longest
