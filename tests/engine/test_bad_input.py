# SPDX-License-Identifier: GPL-2.0-or-later
"""Bad input stops a run before the first step; the message has property, value and range."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from deck_text import head, run_text

from plastigran import laws
from plastigran.engine.process import PROJECT, EngineError, run_deck
from plastigran.experiments.collision import measure
from plastigran.materials import BODY_CONSTANTS

DAMPED = "restitution all property/global coefficientRestitution peratomtypepair 2 .8 .8 .8 .8"

DECK = (
    head("-1 1 -1 1 -1 1", skin=0.01, space="{space}")
    + """
neigh_modify    delay 0
fix youngs  all property/global youngsModulus peratomtype {youngs_modulus}
fix poisson all property/global poissonsRatio peratomtype {poissons_ratio}
{yield_strength}
{dissipative_constant}
{more}
create_atoms    1 single 0 0 0
set group all diameter 0.2 density 2700
pair_style      gran model {law} {settings}
pair_coeff      * *
timestep        1e-6
fix integrate   all nve/sphere
run             1
"""
)
GOOD = {
    "law": "vu_quoc_zhang",
    "youngs_modulus": "7.0e10",
    "poissons_ratio": "0.3",
    "yield_strength": "fix ys all property/global yieldStrength peratomtype 1.0e8",
    "dissipative_constant": "fix dc all property/global dissipativeConstant peratomtypepair 1 1e-5",
    "settings": "tangential off",
    "more": "",
    "space": "boundary f f f",
}
LENGTHS = """
fix cl all property/global cylinderLength peratomtype 1.0
fix bt all property/global bodyThickness peratomtype 1.0
"""


def run(folder: Path, **changes: str) -> str:
    values = GOOD | changes
    if values["law"] in laws.LAWS and laws.LAWS[values["law"]].shape == "cylinder":
        values = {"space": "dimension 2\nboundary f f p", "more": LENGTHS} | changes
        values = GOOD | values
    return run_text(folder, DECK.format(**values))


def strength(value: str) -> str:
    return f"fix ys all property/global yieldStrength peratomtype {value}"


def constant(name: str, value: str, shape: str = "peratomtypepair 1") -> str:
    return f"fix c all property/global {name} {shape} {value}"


BRINELL = r"indentationPressure is \d+; it must be between 100000 .* a hardness in kgf/mm2"


def test_good_input_runs(tmp_path, engine_law):
    """The log states the constants of the model, and LIGGGHTS completes the step."""
    log = run(tmp_path, law=engine_law)
    modulus = 7.0e10 / (2 * (1 - 0.3**2))  # two equal bodies
    assert f"model {engine_law}, atom types 1 and 1: effective modulus {modulus:.6g} Pa" in log
    assert re.search(r"^ *Step ", log, re.MULTILINE)
    assert "for 1 steps with 1 atoms" in log


def test_log_states_the_tangent_modulus_of_a_law_that_hardens(tmp_path):
    given = constant("tangentModulus", "2e9", "peratomtype")
    log = run(tmp_path, law="ghaednia_2019", more=given)
    assert "Pa, tangent modulus 2e+09 Pa, unloading brake_2015" in log
    log = run(tmp_path, law="ghaednia_2019")
    assert "Pa, tangent modulus 0 Pa (default), unloading" in log
    assert "tangent modulus" not in run(tmp_path, law="jackson_green", more=given)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"yield_strength": ""},
            "property yieldStrength is missing. Add one value \\[Pa\\] per atom type",
        ),
        ({"yield_strength": strength("0")}, "yieldStrength is 0; it must be positive and finite"),
        ({"yield_strength": strength("-5e7")}, r"yieldStrength is -5e\+07; it must be positive"),
        ({"yield_strength": strength("nan")}, "Expected floating point parameter"),
        ({"youngs_modulus": "0"}, "youngsModulus is 0; it must be positive and finite"),
        ({"youngs_modulus": "-7e10"}, r"youngsModulus is -7e\+10; it must be positive"),
        ({"youngs_modulus": "nan"}, "Expected floating point parameter"),
        ({"poissons_ratio": "0.51"}, "poissonsRatio is 0.51; it must be above -1 and at most 0.5"),
        ({"poissons_ratio": "-1.2"}, "poissonsRatio is -1.2; it must be above -1 and at most 0.5"),
        (
            {"more": constant("yieldPressureFactor", "100", "peratomtype")},
            "yieldPressureFactor is 100; it must be between 0.5 and 10",
        ),
        (
            {"more": constant("tangentModulus", "7e10", "peratomtype")},
            r"tangentModulus is 7e\+10; it must be 0 or more and less than youngsModulus",
        ),
        (
            {"more": constant("rateCoefficient", "-0.1", "peratomtype")},
            r"rateCoefficient is -0.1; it must be between 0 and 1 \[-\]",
        ),
        (
            {"more": constant("referenceRate", "0", "peratomtype")},
            r"referenceRate is 0; it must be positive and finite \[1/s\]",
        ),
        ({"settings": "viscous_damping on"}, "coefficientRestitution"),
        ({"settings": "computeDissipatedEnergy on"}, "computeDissipatedEnergy is not supported"),
        (
            {"settings": "surface superquadric"},
            "surface superquadric is not available with this model; possible: default multicontact",
        ),
        ({"settings": "dampnig on"}, "Unknown argument or wrong keyword order: 'dampnig'"),
    ],
)
def test_wrong_input_is_refused(changes, message, tmp_path):
    with pytest.raises(EngineError, match=message) as refusal:
        run(tmp_path, **changes)
    log = (tmp_path / "log.liggghts").read_text(errors="replace")
    assert "Step" not in log, "LIGGGHTS accepted the input"
    if "it must be" in message:
        assert "(atom type 1)" in str(refusal.value)


def test_every_model_names_itself(engine_law, tmp_path):
    with pytest.raises(EngineError, match=f"model {engine_law}: yieldStrength is 0; it must be"):
        run(tmp_path, law=engine_law, yield_strength=strength("0"))


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (constant("contactRadiusCoefficient", "-0.1"), "contactRadiusCoefficient is -0.1; it must"),
        (constant("curvatureCoefficient", "-0.1"), "curvatureCoefficient is -0.1; it must be"),
        (constant("curvatureCoefficient", "0.9"), "the contact might create energy"),
        (constant("curvatureCoefficient", "0.01", "scalar"), "matrix|peratomtypepair"),
    ],
)
def test_vu_quoc_zhang_refuses(more, message, tmp_path):
    with pytest.raises(EngineError, match=message):
        run(tmp_path, more=more)


@pytest.mark.parametrize(
    ("law", "more", "message"),
    [
        ("brake_2012", constant("indentationPressure", "105"), BRINELL),
        ("brake_2015", constant("indentationPressure", "327"), BRINELL),
        ("brake_2015", constant("meyerIndex", "1.9"), "meyerIndex is 1.9; it must be between 2"),
        ("brake_2015", constant("meyerIndex", "2.8"), "meyerIndex is 2.8; it must be between 2"),
        (
            "brake_2015",
            constant("indentationPressure", "3e7"),
            r"with indentationPressure 3e\+07 \[Pa\], meyerIndex 2 .*more than a third",
        ),
    ],
)
def test_brake_refuses(law, more, message, tmp_path):
    with pytest.raises(EngineError, match=f"model {law}: .*{message}"):
        run(tmp_path, law=law, more=more)


def test_viscoelastic_hertz_asks_for_its_constant_and_no_strength(tmp_path):
    law = {"law": "viscoelastic_hertz", "yield_strength": ""}
    assert "yield pressure" not in run(tmp_path, **law)
    message = r"dissipativeConstant is missing\. Add a value between 0 and 1 \[s\].*types 1 and 1"
    with pytest.raises(EngineError, match=f"model viscoelastic_hertz: {message}"):
        run(tmp_path, **law, dissipative_constant="")
    with pytest.raises(EngineError, match="dissipativeConstant is 2; it must be between 0 and 1"):
        run(tmp_path, **law, dissipative_constant=constant("dissipativeConstant", "2"))
    deck = "collision/sphere_wall.in"
    with pytest.raises(EngineError, match="dissipativeConstant is missing"):
        run_deck(deck, {"law": "viscoelastic_hertz", "material": "steel"}, tmp_path)


@pytest.mark.parametrize(
    ("deck", "message"),
    [("cylinder_wall", "the wall of a cylinder is rigid"), ("two_spheres", "are of one material")],
)
@pytest.mark.parametrize("name", BODY_CONSTANTS)
def test_decks_without_a_wall_of_metal_refuse_its_constants(deck, message, name, tmp_path):
    with pytest.raises(EngineError, match=f"{name}_other is 0.25; .*{message}: leave it out"):
        run_deck(f"collision/{deck}.in", {f"{name}_other": 0.25}, tmp_path)


def test_options_are_words(engine_law, tmp_path):
    """Each option of a law accepts its listed choices and refuses any other word."""
    for option in laws.LAWS[engine_law].options():
        for choice in option["choices"]:
            setting = f"{option['name']} {choice}"
            log = run(tmp_path, law=engine_law, settings=f"tangential off {setting}")
            assert re.search(rf"^model {engine_law}, .*, {setting}[,\n]", log, re.MULTILINE)
        with pytest.raises(EngineError, match="unknown option or wrong keyword order: 'maybe'"):
            run(tmp_path, law=engine_law, settings=f"tangential off {option['name']} maybe")


@pytest.mark.parametrize("name", ["coefficientFriction", "coefficientRollingFriction"])
def test_negative_friction_is_refused(name, tmp_path):
    """The plugin refuses a negative coefficient of friction, because it would create energy.

    LIGGGHTS itself accepts it.
    """
    with pytest.raises(EngineError, match=rf"{name} is -0.3; it must be 0 or more \(atom types 1"):
        run(tmp_path, law="thornton", more=constant(name, "-0.3"))


def test_viscous_damping_is_the_classic_dashpot(hertzian_law, tmp_path):
    """Below yield, the model with viscous_damping equals LIGGGHTS' hertz with limitForce."""
    stock = (PROJECT / "inputs/collision/two_spheres.in").read_text()
    restitutions = []
    for law, settings in ((hertzian_law, "viscous_damping on"), ("hertz", "limitForce on")):
        deck = stock.replace("tangential ${tangential}", f"tangential off {settings}")
        deck = deck.replace("pair_style", f"unfix restitution\nfix {DAMPED}\npair_style", 1)
        folder = tmp_path / law
        run_text(folder, deck, law=law, speed=5e-4, dissipative_constant=1e-30)
        restitutions.append(measure(folder / "trajectory.dump").coefficient_of_restitution)
    assert 0.75 < restitutions[0] < 0.85
    assert restitutions[0] == pytest.approx(restitutions[1], rel=1e-9)  # round-off of sums


@pytest.mark.parametrize(
    "deck", ["sphere_wall", "sphere_mesh", "two_spheres", "cylinder_wall", "rod"]
)
def test_an_impact_out_of_range_is_named(deck, tmp_path):
    for name, value, allowed in (
        ("tip_radius" if deck == "rod" else "radius", -1, r"positive \[m\]"),
        ("speed", 0, r"positive \[m/s\]"),
        ("timestep", 0, r"positive \[s\]"),
        ("gap", -1, r"0 or more \[m\]"),
    ):
        with pytest.raises(EngineError, match=f"{name} is {value}; it must be {allowed}"):
            run_deck(f"collision/{deck}.in", {name: value}, tmp_path)


LENGTH, MASS = r"be positive \[m\]", r"be positive \[kg\]"


@pytest.mark.parametrize(
    ("deck", "name", "value", "allowed"),
    [
        ("rod", "angle", 91, r"lie from 0 to 90 \[degrees\]"),
        ("rod", "length", 0, LENGTH),
        ("rod", "mass", -1, MASS),
        ("cylinder_wall", "mass", -1, MASS),
        ("cylinder_wall", "cylinder_length", -1, LENGTH),
        ("cylinder_wall", "body_thickness", -1, LENGTH),
    ],
)
def test_an_impossible_body_is_named(deck, name, value, allowed, tmp_path):
    with pytest.raises(EngineError, match=f"{name} is {value}; it must {allowed}"):
        run_deck(f"collision/{deck}.in", {name: value}, tmp_path)
