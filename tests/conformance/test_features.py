# SPDX-License-Identifier: GPL-2.0-or-later
"""Features of LIGGGHTS work with the laws of this project as with LIGGGHTS' own `hertz`.

The features are moving and wearing meshes, insertion, heat, and bodies of several spheres.
"""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import pytest
from attrs import frozen
from soft_grains import NO_YIELD, PROPERTIES, STRENGTH, assert_alike, fresh, motion

from plastigran.engine.log import read_thermo

FLOOR = "fix floor all wall/gran model {law} tangential history primitive type 2 zplane 0.0"
#: Two grains that hit the floor or a plate on it, and each other; one grain spins.
TWO = """
create_atoms    1 single 0.0 0.0 0.0102
create_atoms    1 single 0.0215 0.001 0.0112
set group all diameter 0.02 density 2500 vz -0.2
set atom 2 vx -0.3 omegay 20.0
"""
#: A horizontal plate of triangles on the floor, for a given mesh style.
PLATE = (
    "fix plate all {} file ${{inputs}}/meshes/plate.stl type 2 scale 0.01 rotate axis 0 1 0 "
    "angle -90 {}\n"
)
ON_PLATE = """
fix plate_wall all wall/gran model {law} tangential history mesh n_meshes 1 meshes plate
"""
GRAINS_OF = """
fix small all particletemplate/sphere 15485863 atom_type 1 density constant 2500 &
    radius constant 0.004
fix large all particletemplate/sphere 15485867 atom_type 1 density constant 2500 &
    radius constant 0.006
fix sizes all particledistribution/discrete 32452843 2 small 0.3 large 0.7
group inserted region box
"""
STONE = """
fix stone all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 2 &
    ntry 10000 spheres 0 0 0 0.005  0.006 0 0 0.004 type 1
fix sizes all particledistribution/discrete 15485867 1 stone 1.0
"""


@frozen
class Feature:
    """A feature of LIGGGHTS that a deck uses.

    Attributes:
        grains: Commands that make grains, if any.
        commands: Commands after the pair style; `{law}` stands for the name of the law.
        integrate: The fix that moves the grains, if any.
        more: Values of each grain to compare in addition to its motion.
        thermo: Values of the log to compare.
        steps: Number of steps of the run.
        differs: Whether LIGGGHTS' own models give other results on two ranks. Each rank then draws
            its own random grains, or uses radii of the other rank that are some steps old.
    """

    commands: str
    grains: str = TWO
    integrate: str = "fix integrate all nve/sphere\n"
    more: str = ""
    thermo: str = ""
    steps: int = 1000
    differs: bool = False


FEATURES = {
    "conveyor": Feature(PLATE.format("mesh/surface", "surface_vel 0.5 0 0") + ON_PLATE),
    "lifting plate": Feature(
        PLATE.format("mesh/surface", "")
        + ON_PLATE
        + "fix lift all move/mesh mesh plate linear 0.1 0 0.3\n"
    ),
    "turning plate": Feature(
        PLATE.format("mesh/surface", "")
        + ON_PLATE
        + "fix turn all move/mesh mesh plate rotate origin 0 0 0 axis 0 0 1 period 0.1\n"
    ),
    "press": Feature(
        FLOOR
        + "\n"
        + PLATE.format(
            "mesh/surface/stress/servo",
            "move 0 0 0.0205 com 0 0 0.0205 ctrlPV force axis 0 0 -1 target_val 2 vel_max 0.5 kp 5",
        )
        + ON_PLATE,
        grains="create_atoms 1 single 0 0 0.0101\nset group all diameter 0.02 density 2500\n",
        thermo="f_plate[3] f_plate[9]",
    ),
    "worn plate": Feature(
        "fix wear all property/global k_finnie peratomtypepair 2 1 1 1 1\n"
        + PLATE.format("mesh/surface/stress", "wear finnie")
        + ON_PLATE,
        thermo="f_plate[1] f_plate[2] f_plate[3] f_plate[4] f_plate[5] f_plate[6]",
    ),
    "stream": Feature(
        GRAINS_OF
        + FLOOR
        + "\n"
        + PLATE.format("mesh/surface", "move 0 0 0.04")
        + "fix stream inserted insert/stream seed 32452867 distributiontemplate sizes "
        "nparticles 30 particlerate 3000 overlapcheck yes all_in no vel constant 0 0 -1 "
        "insertion_face plate extrude_length 0.02\n",
        grains="",
        integrate="fix integrate inserted nve/sphere\n",
        steps=4000,
        differs=True,
    ),
    "pack": Feature(
        GRAINS_OF
        + FLOOR
        + "\nregion above block -0.03 0.03 -0.03 0.03 0.0 0.03 units box\n"
        + "fix pack inserted insert/pack seed 32452867 distributiontemplate sizes insert_every "
        "once overlapcheck yes all_in yes vel constant 0 0 -0.3 region above "
        "particles_in_region 30\n",
        grains="",
        integrate="fix integrate inserted nve/sphere\n",
        differs=True,
    ),
    "heat": Feature(
        FLOOR
        + """
fix conductivity all property/global thermalConductivity peratomtype 100 100
fix capacity     all property/global thermalCapacity peratomtype 10 10
fix warmth       all heat/gran initial_temperature 300
run 0
set atom 2 property/atom Temp 400
""",
        more="f_Temp[0] f_heatFlux[0]",
        thermo="f_warmth",
    ),
    "growth": Feature(
        FLOOR
        + """
compute radius all property/atom radius
variable grown atom 2*1.0005*c_radius
fix grow all adapt 20 atom diameter v_grown
""",
        differs=True,
    ),
    "rigid body": Feature(
        FLOOR,
        grains=TWO + "create_atoms 1 single 0.0 0.0 0.0295\nset atom 3 diameter 0.02 density 2500\n"
        "group body id 1 3\ngroup single id 2\n",
        integrate="fix body body rigid single\nfix integrate single nve/sphere\n",
    ),
    "multisphere": Feature(
        STONE
        + FLOOR
        + "\nregion above block -0.03 0.03 -0.03 0.03 0.0 0.04 units box\n"
        + "fix pack all insert/pack seed 32452843 distributiontemplate sizes insert_every once "
        "overlapcheck yes vel constant 0 0 -0.5 region above particles_in_region 8 ntry_mc 10000\n",
        grains="",
        integrate="fix integrate all multisphere\n",
        steps=2000,
        differs=True,
    ),
    "contacts by themselves": Feature(
        FLOOR
        + """
compute contacts all pair/gran/local pos vel id force
compute sums all reduce sum c_contacts[13] c_contacts[14] c_contacts[15]
compute pressed all contact/atom
fix step all check/timestep/gran 20 0.1 0.1
""",
        more="c_pressed",
        thermo="c_sums[1] c_sums[2] c_sums[3] f_step[1] f_step[2]",
    ),
}
every_feature = pytest.mark.parametrize("feature", FEATURES.values(), ids=FEATURES)


def follow(
    feature: Feature, folder: Path, law: str = "thornton", ranks: int = 1, **values: str
) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Return the motion of the grains by step and atom ID, and the log of the last run."""
    strength = values.get("strength", STRENGTH)
    text = (
        feature.grains
        + PROPERTIES.format(strength=strength)
        + f"pair_style gran model {law} tangential history\npair_coeff * *\n"
        + feature.commands.format(law=law, inputs="{inputs}")
        + "\n"
        + feature.integrate
        + f"thermo_style custom step atoms ke {feature.thermo}\n"
        + "thermo_modify format float %.17g\n"
        + motion(feature.more)
        + f"run {feature.steps}\n"
    )
    grains, log = fresh(text, folder, ranks), read_thermo(folder / "log.liggghts")
    return grains, log[log["run"] == log["run"].max()].dropna(axis=1, how="all")


def assert_hertzian(feature: Feature, folder: Path, ranks: int = 1) -> None:
    """Check that a law without yield agrees with LIGGGHTS' hertz in motion and log. They agree to
    1e-9 of the largest value of each column, because round-off grows during impacts.
    """
    ours, log = follow(feature, folder / "ours", ranks=ranks, strength=NO_YIELD)
    stock, their_log = follow(feature, folder / "stock", "hertz", ranks)
    assert_alike(ours, stock, 1e-9)
    for name in set(log) - {"run"}:
        scale = their_log[name].abs().max()
        assert log[name].to_numpy() == pytest.approx(their_log[name].to_numpy(), abs=1e-9 * scale)


@every_feature
def test_it_is_that_of_the_engines_hertz(feature, tmp_path):
    assert_hertzian(feature, tmp_path)


@every_feature
def test_two_ranks_are_one_where_grains_yield(feature, tmp_path):
    """With yielding grains, a feature gives the same motion on two ranks as on one, to 1e-9.

    If LIGGGHTS' own hertz gives another motion on two ranks, a law without yield must give the same
    motion as hertz on two ranks.
    """
    one, two = (follow(feature, tmp_path / str(ranks), ranks=ranks)[0] for ranks in (1, 2))
    plain = follow(feature, tmp_path / "plain", strength=NO_YIELD)[0]
    assert len(plain) == len(one) == len(two)
    assert ((plain - one).abs().max() > 1e-3 * one.abs().max()).any(), "nothing yields"
    if feature.differs:
        assert_hertzian(feature, tmp_path, ranks=2)
    else:
        assert_alike(one, two, 1e-9)
