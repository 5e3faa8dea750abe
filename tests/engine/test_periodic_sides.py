# SPDX-License-Identifier: GPL-2.0-or-later
"""A box in which a pair could touch through two periodic images is refused: LIGGGHTS keeps one
contact history for each pair of particles."""

from __future__ import annotations

import re

import pytest
from deck_text import error_of, head, material, run_text

MODEL = "pair_style gran model thornton tangential off\npair_coeff * *\n"
TWO_SPHERES = """
create_atoms 1 single 0.01 0 0 units box
create_atoms 1 single 0.03 0 0 units box
set group all diameter 0.02 density 2700
"""
INSERTED = """
fix part all particletemplate/sphere 15485867 atom_type 1 density constant 2700 radius constant 0.01
fix dist all particledistribution/discrete 32452843 1 part 1.0
region place block 0 0.02 0.01 0.04 -0.04 0.04 units box
fix ins all insert/pack seed 86028157 distributiontemplate dist vel constant 0 0 0 &
  insert_every once overlapcheck yes all_in no particles_in_region 2 region place
"""
SMALL_SPHERE = """
create_atoms 1 single 0.01 0 0 units box
set group all diameter 0.004 density 2700
"""
INTRUDER = SMALL_SPHERE + INSERTED.replace("particles_in_region 2", "particles_in_region 1")
NOT_INSERTED = TWO_SPHERES + "".join(INSERTED.replace("0.01\n", "0.02\n").splitlines(True)[:3])
END = "fix integrate all nve/sphere\ntimestep 1e-8\nrun 5\n"


def deck(side: float, particles: str = TWO_SPHERES, more: str = "") -> str:
    start = head(f"0 {side} -0.05 0.05 -0.05 0.05", skin=1e-4, space="boundary p f f")
    return start + material("7.0e10", "1.0e8") + MODEL + particles + END + more


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("particles", [TWO_SPHERES, INSERTED])
def test_a_short_periodic_side_is_refused(particles, ranks, tmp_path):
    """A periodic side that is shorter than two diameters plus the neighbor skin is refused.

    The side of 39.7 mm is 0.4 mm shorter than two diameters of 20 mm plus the skin of 0.1 mm.
    """
    message = error_of(tmp_path, deck(0.0397, particles), ranks)
    assert (
        "model thornton: the periodic side x is 0.0397 long; it must be at least 0.0401" in message
    )
    assert (
        "(0.02 and 0.02) and the neighbor skin (0.0001)" in message and "Enlarge the box" in message
    )


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_longer_periodic_side_runs(ranks, tmp_path):
    run_text(tmp_path, deck(0.0402), ranks)


@pytest.mark.parametrize("runs", [1, 2])
def test_one_large_sphere_to_be_inserted_is_one(runs, tmp_path):
    """One sphere of 20 mm among spheres of 4 mm needs a periodic side of 24.1 mm, before and after
    the insertion of the large sphere.
    """
    log = run_text(tmp_path, deck(0.025, INTRUDER, "run 5\n" * (runs - 1)))
    assert "inserted 1 particle templates" in log
    assert "must be at least 0.0241" in error_of(tmp_path, deck(0.024, INTRUDER))


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_box_that_shrinks_in_a_run_is_refused(ranks, tmp_path):
    """A run stops when its periodic side becomes too short for two diameters and the neighbor skin.

    `fix deform` shrinks the side from 42 to 38 mm; the limit is 40.1 mm.
    """
    shrink = "fix deform all deform 10 x final 0 0.038\nrun 1000\n"
    message = error_of(tmp_path, deck(0.042, more=shrink), ranks)
    assert re.search(r"the periodic side x is 0\.040.* must be at least", message)


def test_a_size_that_nothing_inserts_does_not_count(tmp_path):
    run_text(tmp_path, deck(0.0402, NOT_INSERTED))
