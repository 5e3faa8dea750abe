# SPDX-License-Identifier: GPL-2.0-or-later
"""The cylinder of Katta and Polycarpou, on coarse meshes."""

from __future__ import annotations

import pytest

from plastigran.papers.kp10 import PAPER
from plastigran.papers.kp10.computations import FRICTION


def test_every_table_and_picture_is_made(coarse):
    written = {path.name for path in coarse("kp10").iterdir()}
    assert written == set(PAPER.files)


def test_largest_depths_are_alike_and_sliding_leaves_more(coarse_table):
    ours = coarse_table("kp10", "comparison").set_index("quantity")["finite elements"]
    # The paper calls them alike; by finer meshes they differ by one per cent.
    assert ours["largest depth, oblique/head-on"] == pytest.approx(1, abs=0.03)
    assert ours["oblique: residual depth"] > 1.5 * ours["head-on: residual depth"]
    # Up the front of its groove the cylinder leaves faster than it came.
    assert ours["head-on: restitution"] < 1 < ours["oblique: restitution"]


def test_a_groove_drags_beyond_friction(coarse_table):
    drag = coarse_table("kp10", "oblique").set_index("way")["drag/force"]
    assert drag["head-on"] == pytest.approx(0, abs=1e-12)
    assert FRICTION < drag["oblique"] < 2 * FRICTION


def test_yield_begins_below_the_surface_and_reaches_it(coarse_table):
    table = coarse_table("kp10", "oblique").set_index("way")
    surface = table["force at surface yield (N)"]
    # Friction brings yield up, and more force is needed without.
    assert table.loc["head-on", "force at first yield (N)"] < 0.8 * surface["head-on"]
    assert surface["oblique"] < surface["head-on"]
    for row in table.to_dict("records"):
        shortest, longest = map(float, row["elements (µm)"].split(" to "))
        # Gauss points next to the surface of a square lie 0.21 of its length below it.
        assert 0.21 * shortest < row["detected at depth (µm)"] < 0.22 * longest


def test_a_body_without_far_side_is_softer_and_keeps_waves(coarse_table):
    table = coarse_table("kp10", "normal").set_index("quantity")
    layer, thick = table["finite elements"], table["no reflected waves"]
    assert thick["largest depth"] > layer["largest depth"]
    assert thick["largest force"] < layer["largest force"]
    assert thick["residual depth"] < layer["residual depth"]
    assert thick["restitution"] < layer["restitution"]


def test_the_laws_lie_about_the_finite_elements(coarse_table):
    table = coarse_table("kp10", "normal").set_index("quantity")
    for law in ("katta_polycarpou", "lim_stronge"):
        off = table[f"LIGGGHTS, {law} vs finite elements (%)"]
        # Per cent. The laws are stiffer beyond yield than the body of the same thickness.
        assert -25 < off["largest depth"] < -10
        assert 25 < off["largest force"] < 50
        assert off["restitution"] == pytest.approx(0, abs=6)
