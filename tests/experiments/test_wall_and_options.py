# SPDX-License-Identifier: GPL-2.0-or-later
"""LIGGGHTS agrees with the law for impacts on a wall of another material and for laws with options.
Impossible cases are refused."""

from __future__ import annotations

import pytest

from plastigran import laws
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.cylinder import CylinderImpact
from plastigran.materials import RIGID, Material, read_material


@pytest.mark.parametrize("geometry", ["sphere_wall", "sphere_mesh"])
@pytest.mark.parametrize(
    ("ball", "wall"),
    [("zirconia", "steel"), ("copper", "steel_bearing"), ("glass", "pmma")],
    ids=["wall yields", "ball yields", "soft wall"],
)
def test_the_engine_has_the_wall_of_theory(geometry, ball, wall, tmp_path):
    """Impacts on a wall of another material agree with theory.

    The relative tolerance 2e-3 is twice the error of restitution at the recommended time step.
    """
    case = CentralImpact("universal", 0.5, ball, 0.005, geometry, wall=wall)
    found, expected = case.run(tmp_path), case.predict()
    for name in ("coefficient_of_restitution", "force_max", "overlap_max"):
        assert getattr(found, name) == pytest.approx(getattr(expected, name), rel=2e-3)
    rigid = CentralImpact("universal", 0.5, ball, 0.005, geometry)
    assert expected.force_max < rigid.predict().force_max


def test_a_rigid_wall_has_a_name():
    """A sweep accepts the name `rigid` for a wall, like the names of materials."""
    runs = CentralImpact.theory(law="thornton", speed=0.1, wall=["rigid", "copper", RIGID])
    assert runs.table["wall"].tolist() == ["rigid", "copper"]
    with pytest.raises(
        ValueError, match="3 is not a material; it must be a Material, a name or a p"
    ):
        CentralImpact("thornton", 0.1, "steel", 0.005, wall=3)


def test_a_wall_of_the_balls_metal_has_half_its_modulus():
    """On a wall of its own metal, a ball has half of the effective modulus E* of a rigid wall.

    1/E* = 2 (1 - nu^2)/E, and the yield speed of Hertz' contact is proportional to E*^-2.
    """
    steel = read_material("steel")
    alike = CentralImpact("thornton", 1.0, steel, 0.01, wall=steel)
    rigid = CentralImpact("thornton", 1.0, steel, 0.01)
    ratio = rigid.pair.youngs_modulus_eff / alike.pair.youngs_modulus_eff
    assert ratio == pytest.approx(2, rel=1e-12)
    assert alike.yield_speed() == pytest.approx(ratio**2 * rigid.yield_speed(), rel=1e-12)


def test_an_option_reaches_law_and_engine(tmp_path):
    """An option of a law takes effect in theory and in LIGGGHTS.

    Theory equals a law that is created directly. LIGGGHTS agrees within 2e-3, twice the error of
    restitution at the recommended time step.
    """
    case = CentralImpact("universal", 2.0, "steel", 0.005, options="yielding flat")
    law = laws.LAWS["universal"](case.pair, yielding="flat")
    by_hand = law.central_impact(case.radius_eff, case.mass_eff, case.closing_speed)
    expected = by_hand.coefficient_of_restitution
    assert case.predict().coefficient_of_restitution == expected
    plain = CentralImpact("universal", 2.0, "steel", 0.005).predict().coefficient_of_restitution
    assert abs(expected - plain) > 5e-3 * plain, "the option has no effect"
    found = case.run(tmp_path)
    assert found.coefficient_of_restitution == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize(
    ("changes", "complaint"),
    [
        ({"options": "yielding"}, "options is 'yielding'; it must be made of pairs NAME CHOICE"),
        ({"options": "yielding soft"}, "yielding is soft; it must be one of sphere, flat"),
        ({"options": "unloading area"}, "no option 'unloading'. Available options: yielding"),
        (
            {"law": "hertz", "options": "yielding flat"},
            "no option 'yielding'. Available options: no",
        ),
        (
            {"geometry": "two_spheres", "wall": "steel"},
            "wall is steel, but two_spheres has no wall",
        ),
        ({"wall": "cheese"}, "no material 'cheese'"),
    ],
)
def test_what_cannot_be_is_refused(changes, complaint):
    given = {"law": "universal", "speed": 0.5, "material": "steel", "radius": 0.005}
    with pytest.raises(ValueError, match=complaint):
        CentralImpact(**given | changes)


@pytest.mark.parametrize(
    ("law", "wall", "options", "said"),
    [
        ("universal", "steel", None, 1),
        ("universal", "steel", "yielding flat", 0),
        ("universal", None, None, 0),
        ("thornton", "steel", None, 1),
        ("ye_komvopoulos", "steel", None, 0),
        ("hertz", "steel", None, 0),
    ],
)
def test_a_dented_wall_is_said(law, wall, options, said):
    """The output has a note if the wall yields but the law describes spheres that flatten.

    With `yielding flat`, `universal` describes a yielding wall.
    """
    runs = CentralImpact.theory(
        law=law, material="zirconia", speed=1.0, radius=0.005, wall=wall, options=options
    )
    assert str(runs).count("Zirconia on Steel: the wall yields") == said
    assert f"spheres of radius 0.005 m, on {'Steel' if wall else 'a rigid wall'}" in str(runs)


def test_options_go_to_the_laws_that_have_them():
    names = ["universal", "thornton"]
    runs = CentralImpact.theory(law=names, speed=0.1, options="yielding flat")
    assert runs.table["options"].tolist() == ["yielding flat", "default"]
    several = ["yielding flat", "yielding sphere"]
    runs = CentralImpact.theory(law=names, speed=0.1, options=several)
    assert runs.table["options"].tolist() == [*several, "default"]
    with pytest.raises(ValueError, match="thornton has no option 'yielding'"):
        CentralImpact.theory(law=["thornton", "hertz"], speed=0.1, options="yielding flat")
    with pytest.raises(ValueError, match="yielding is soft; it must be one of sphere, flat"):
        CentralImpact.theory(law=names, speed=0.1, options="yielding soft")


def test_a_law_of_dents_for_a_ball_that_flattens_is_said():
    """The output has a note if the option describes a yielding flat but the ball yields."""
    case = {"law": "universal", "speed": 1.0, "material": "steel", "wall": "zirconia"}
    said = "Steel on Zirconia: the ball yields, but --options 'yielding flat' describes a"
    assert said in str(CentralImpact.theory(**case, options="yielding flat"))
    assert "the ball yields, but" not in str(CentralImpact.theory(**case))


@pytest.mark.parametrize("name", ["rigid", "none", "default", "", "a/b", 304])
def test_names_that_no_material_may_have(name):
    """A material may not have a name that tables and folders use otherwise or cannot contain."""
    with pytest.raises(ValueError, match=f"name is {name!r}[;,] "):
        Material(name, **read_material("steel").variables())


def test_laws_may_be_any_iterable():
    names = ["universal", "thornton"]
    cases = CentralImpact.plan(law=iter(names), speed=0.1, material="steel", radius=0.005)
    assert [case.law for case in cases] == names


def test_options_are_not_left_out_before_a_case_is_judged():
    """The check of the largest overlap of an impact uses the options of the law.

    With the default options, the overlap would be too large.
    """
    case = {"law": "universal", "speed": 134.0, "material": "steel", "radius": 0.005}
    (found,) = CentralImpact.plan(**case, options="yielding flat")
    assert found.options == "yielding flat"
    with pytest.raises(ValueError, match="would overlap by"):
        CentralImpact.plan(**case)


def test_every_row_has_a_wall_and_options():
    """Every row of a table has values for wall and options, so that the table can be read again."""
    runs = CentralImpact.theory(law="thornton", speed=0.1, geometry=["sphere_wall", "two_spheres"])
    assert runs.table["wall"].tolist() == ["rigid", "none"]
    assert runs.table["options"].tolist() == ["default", "default"]


def test_impacts_without_yield_are_said():
    said = "every impact is slower than its yield speed"
    for speeds, expected in ((0.1, True), ([0.1, 50.0], False)):
        runs = CentralImpact.theory(law="thornton", material="glass", speed=speeds, radius=0.005)
        assert (said in str(runs)) is expected


def test_a_cylinder_has_a_rigid_wall():
    with pytest.raises(ValueError, match="wall is steel, but a cylinder must hit a rigid wall"):
        CylinderImpact("lim_stronge", 1.0, "glass_kp10", 1e-5, wall="steel")
