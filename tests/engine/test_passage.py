# SPDX-License-Identifier: GPL-2.0-or-later
"""A particle that would pass through a wall stops the run.

A wall repels particles on both of its sides. So the overlap never exceeds the radius, even if a
particle passes through the wall.
"""

from __future__ import annotations

import re

import pytest
from deck_text import error_of, head, run_text

#: The balls of the README above a floor. The tests give a modulus in GPa or a long time step.
DECK = (
    head("0 0.05 0 0.05 -0.02 0.1", skin=0.002)
    + """
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype {youngs_modulus}
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global yieldStrength peratomtype {yield_strength}
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model {law} tangential history {settings}
pair_coeff * *
{mesh}
fix floor all wall/gran model {law} tangential history {wall} {settings}
lattice sc 0.015
region balls block 0 2 0 2 1 3 units lattice
create_atoms 1 region balls
set group all diameter 0.01 density 7850
velocity all set 0 0 {velocity}
fix gravity all gravity 9.81 vector 0 0 -1
fix integrate all nve/sphere
timestep {timestep}
thermo 300000
run {steps}
"""
)
PLANE = "primitive type 1 zplane 0.0"
TYPED_IN_GPA = {"youngs_modulus": "210", "yield_strength": "3e8", "timestep": "1e-4"}
STEP_TOO_LONG = {"youngs_modulus": "2.1e11", "yield_strength": "3e8", "timestep": "2e-4"}


def deck(**changes: object) -> str:
    values = {"law": "kogut_etsion", "settings": "", "mesh": "", "wall": PLANE, "velocity": 0}
    return DECK.format(**values | {"steps": 3000} | changes)


def test_a_modulus_typed_in_gpa(engine_wall, tmp_path):
    """A ball that crosses a wall stops the run; the message quotes the warning with the cause."""
    text = error_of(tmp_path, deck(**TYPED_IN_GPA, **engine_wall))
    place = re.search(
        r"particle \d+ at \(\S+ \S+ (\S+)\) is about to cross a wall: the overlap is "
        r"(\S+) times its radius\.",
        text,
    )
    assert 0 < float(place[1]) < 0.05 * 0.005
    assert float(place[2]) == pytest.approx(1 - float(place[1]) / 0.005, abs=1e-4)
    assert "earlier warnings: model kogut_etsion: youngsModulus is 210 [Pa]" in text


@pytest.fixture(params=["plane", "mesh"])
def engine_wall(request):
    """A plane, or a mesh in the same place."""
    if request.param == "plane":
        return {}
    # The mesh of the file lies at x = 0 and measures 5 by 6.
    mesh = "fix mesh all mesh/surface file ${inputs}/meshes/plate.stl type 1 scale 0.02"
    mesh += " rotate axis 0 1 0 angle 90 move 0.025 0.025 0"
    return {"mesh": mesh, "wall": "mesh n_meshes 1 meshes mesh"}


def test_a_step_that_is_too_long(tmp_path):
    """A run with a time step that is far too long stops, and the message quotes earlier warnings.

    Balls hit a wall at 10 m/s and move by 0.4 radii per step. The first contact force is too
    large, or the second step passes the wall.
    """
    text = error_of(tmp_path, deck(**STEP_TOO_LONG, velocity=-10))
    assert "is about to cross a wall" in text or "times its radius in one step" in text
    assert "the time step 0.0002 is too long for wall impacts" in text


def test_a_wall_that_may_be_passed(tmp_path):
    """With `overlap_limit 2`, a particle may pass through a wall, and the run continues."""
    run_text(tmp_path, deck(**TYPED_IN_GPA, settings="overlap_limit 2"))


def test_sound_balls_pass_nothing(tmp_path):
    sound = {"youngs_modulus": "2.1e8", "yield_strength": "3e6", "timestep": "3e-6"}
    assert "WARNING" not in run_text(tmp_path, deck(**sound, steps=20000))
