# SPDX-License-Identifier: GPL-2.0-or-later
"""The sphere of Zhang and Vu-Quoc, on coarse meshes."""

from __future__ import annotations

import pytest
from PIL import Image

from plastigran.papers.zv02 import PAPER


def test_every_picture_is_drawn(coarse):
    written = {path.name for path in coarse("zv02").iterdir()}
    assert written == set(PAPER.files)
    with Image.open(coarse("zv02") / "collision.gif") as movie:
        assert movie.n_frames > 10


def test_the_sphere_yields_below_its_surface_at_the_theorys_force(coarse_table):
    table = coarse_table("zv02", "onset").set_index("quantity")["finite elements vs Hertz (%)"]
    # The stress is largest between Gauss points: yield is seen late, never early.
    assert 0 < table["force at yield"] < 2
    assert table["largest pressure/yield strength"] == pytest.approx(0, abs=0.7)
    # An element is a tenth of the contact radius.
    assert table["depth/contact radius"] == pytest.approx(0, abs=10)


def test_elastic_impacts_are_hertz_impacts(coarse_table):
    for row in coarse_table("zv02", "elastic").to_dict("records"):
        # 1 %: the sphere's finite size, and 80 steps in a contact.
        assert row["finite elements"] == pytest.approx(row["Hertz"], rel=1e-2)
        assert row["LIGGGHTS"] == pytest.approx(row["Hertz"], rel=2e-3)
        if row["quantity"] == "restitution":
            assert row["finite elements"] > 0.999


def test_forces_are_those_of_the_paper(coarse_table):
    table = coarse_table("zv02", "force")
    assert len(table) > 1
    # 1 % on the default mesh, twice as much on a coarse one.
    assert (table["finite elements vs paper (%)"].abs() < 2).all()
    law = table["vu_quoc_zhang"]
    assert table["vu_quoc_zhang, LIGGGHTS"].to_numpy() == pytest.approx(law.to_numpy(), rel=1e-3)


def test_restitution_by_nodes_swings_about_that_by_momentum(coarse_table):
    table = coarse_table("zv02", "restitution")
    for row in table.to_dict("records"):
        least, largest = map(float, row["by nodes, range"].split(" to "))
        assert least < row["finite elements"] < largest
        # Over a quarter of the contact, some periods, the vibration averages out but for its ends.
        assert row["by nodes, mean"] == pytest.approx(row["finite elements"], rel=0.03)


def test_pressed_slowly_more_force_leaves_more(coarse_table):
    table = coarse_table("zv02", "pressed").set_index(["quantity", "force (N)"])["finite elements"]
    for quantity in ("approach", "contact radius", "residual approach"):
        assert table[quantity].is_monotonic_increasing
    assert table["√(recovered work/work)"].is_monotonic_decreasing
    assert (table["residual approach"] < table["approach"]).all()


def test_the_laws_constants_come_out_near_the_papers(coarse_table):
    off = coarse_table("zv02", "coefficients").set_index("quantity")["finite elements vs paper (%)"]
    # 1.5 % of C_a and 8 % of K_c are the fit's definition; the rest is the coarse mesh.
    assert abs(off["C_a"]) < 5
    assert abs(off["K_c"]) < 12


def test_the_engine_runs_the_laws(coarse_table):
    table = coarse_table("zv02", "engine")
    for column in ("LIGGGHTS vs the law, force (%)", "LIGGGHTS vs the law, restitution (%)"):
        assert (table[column] < 0.1).all()  # the recommended time step is for 0.1 %
