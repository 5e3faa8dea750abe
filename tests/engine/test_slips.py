# SPDX-License-Identifier: GPL-2.0-or-later
"""Values that look like typing errors give one warning; an error lists the possible choices."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from deck_text import head, run_text

from plastigran.engine.log import find_models
from plastigran.engine.process import EngineError

DECK = (
    head("-1 1 -1 1 -1 1", skin=0.01, types=2, units="{units}")
    + """
neigh_modify    delay 0
fix youngs  all property/global youngsModulus peratomtype {youngs_modulus} 1e30
fix poisson all property/global poissonsRatio peratomtype 0.3 0.3
fix strength all property/global {strength_name} peratomtype {yield_strength} 1e30
{more}
create_atoms    1 single 0 0 0.5
create_atoms    1 single 0.5 0 0.5
set group all diameter 0.2 density 2700
{velocities}
pair_style      gran model {model}
pair_coeff      * *
{floor}
timestep        {timestep}
fix integrate   all nve/sphere
run             0
"""
)
FLOOR = "primitive type 2 zplane 0.0"
GOOD = {
    "units": "si",
    "youngs_modulus": "7.0e10",
    "yield_strength": "1e8",
    "strength_name": "yieldStrength",
    "model": "thornton tangential off",
    "velocities": "",
    "timestep": "1e-7",
    "more": "",
}


def run(folder: Path, **changes: str) -> str:
    values = GOOD | changes
    values.setdefault("floor", f"fix floor all wall/gran model {values['model']} {FLOOR}")
    return run_text(folder, DECK.format(**values))


def property_global(name: str, values: str, shape: str = "peratomtype") -> str:
    return f"fix more all property/global {name} {shape} {values}"


def matrix(name: str, value: str) -> str:
    return property_global(name, f"2 {value} {value} {value} {value}", "peratomtypepair")


COHESION = property_global("cohesionEnergyDensity", "2 1e9 0 0 0", "peratomtypepair")


@pytest.mark.parametrize("changes", [{}, {"more": COHESION}, {"yield_strength": "1e30"}])
def test_a_good_deck_gives_no_warning(changes, tmp_path):
    """Unused cohesion and a rigid body give no warning, either."""
    assert "WARNING" not in run(tmp_path, **changes)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"youngs_modulus": "210", "yield_strength": "2.5e8"},
            "youngsModulus is 210 [Pa], as soft as a gel; if it is in GPa, write 2.1e+11; if it is "
            "in MPa, write 2.1e+08 (atom type 1)",
        ),
        (
            {"youngs_modulus": "2.1e5", "yield_strength": "250"},
            "youngsModulus is 210000 [Pa], as soft as a gel; if it is in MPa, write 2.1e+11 "
            "(atom type 1)",
        ),
        (
            {"yield_strength": "250"},
            "yieldStrength is 250 [Pa], less than 2e-5 of youngsModulus 7e+10; if it is in MPa, "
            "write 2.5e+08 (atom type 1)",
        ),
        (
            {"yield_strength": "3e10"},
            "yieldStrength is 3e+10 [Pa], more than a third of youngsModulus 7e+10; no solid",
        ),
        (
            {"units": "cgs", "youngs_modulus": "210"},
            "youngsModulus is 210 [dyn/cm2], as soft as a gel; if it is in GPa, write 2.1e+12; if "
            "it is in MPa, write 2.1e+09 (atom type 1)",
        ),
        (
            {"more": property_global("yieldPresureFactor", "2.0 2.0")},
            "property yieldPresureFactor is not used. Possible misspelling of yieldPressureFactor",
        ),
        (
            {"more": matrix("indentatonPressure", "1e9"), "model": "brake_2012 tangential off"},
            "property indentatonPressure is not used. Possible misspelling of indentationPressure",
        ),
        (
            {"more": COHESION, "model": "thornton tangential off cohesion sjkr"},
            "cohesionEnergyDensity is 1e+09 [Pa], above the yield pressure 1.6",
        ),
        (
            {"more": "neighbor 0.01 multi"},
            "LIGGGHTS misses contacts with `neighbor ... multi`. Use `bin`",
        ),
    ],
)
def test_a_slip_gives_one_warning(changes, message, tmp_path):
    """A value that looks like a typing error gives one warning, although pairs and walls use it."""
    log = run(tmp_path, **changes)
    assert log.count("WARNING: plastigran: model ") == 1
    assert message in log


def test_messages_are_in_the_units_of_the_deck(tmp_path):
    log = run(tmp_path, units="cgs", youngs_modulus="7e11", yield_strength="1e9")
    assert "yield strength 1e+09 dyn/cm2, yield pressure" in log
    assert not re.search(r"\bPa\b", log)
    with pytest.raises(EngineError, match=r"yieldStrength is 0; .* finite \[dyn/cm2\]"):
        run(tmp_path, units="cgs", yield_strength="0")


def test_a_misspelt_property_that_must_be_there_is_named(tmp_path):
    message = r"yieldStrength is missing\. .*\. The deck defines yieldStrenght"
    with pytest.raises(EngineError, match=message):
        run(tmp_path, strength_name="yieldStrenght")


def test_unused_restitution_gives_a_warning(tmp_path):
    given = matrix("coefficientRestitution", "0.9")
    message = "model thornton: coefficientRestitution is not used"
    assert run(tmp_path, more=given).count(message) == 1
    damped = run(tmp_path, more=given, model="thornton tangential off viscous_damping on", floor="")
    assert message not in damped


@pytest.mark.parametrize(
    ("pairs", "wall", "message"),
    [
        ("thornton", "hertz", "pair_style has thornton; fix floor has one of LIGGGHTS' own models"),
        ("hertz", "thornton", "pair_style has one of LIGGGHTS' own models; fix floor has thornton"),
        ("thornton", "stronge", "pair_style has thornton; fix floor has stronge"),
    ],
)
def test_different_models_of_pairs_and_walls_give_one_warning(pairs, wall, message, tmp_path):
    log = run(
        tmp_path,
        model=f"{pairs} tangential off",
        floor=f"fix floor all wall/gran model {wall} tangential off {FLOOR}",
        more="hard_particles yes\n" + matrix("coefficientRestitution", "0.9"),
    )
    assert log.count(f"lines have different normal models: {message}") == 1
    # The warning is right only if neither line has a model of LIGGGHTS, which uses restitution.
    assert ("coefficientRestitution is not used" in log) == (wall == "stronge")


def test_constants_are_printed_once_with_their_lines(tmp_path):
    """The log prints the constants of each law once per pair of atom types.

    It also lists the pair_style and wall lines for which they hold. The deck has two atom types, so
    three pairs of types, and five walls, of which one has another law.
    """
    walls = [f"fix w{k} all wall/gran model thornton tangential off {FLOOR}" for k in range(4)]
    walls.append(f"fix other all wall/gran model stronge tangential off {FLOOR}")
    log = run(tmp_path, floor="\n".join(walls))
    constants = re.findall(r"^model (\w+), atom types (\d and \d): effective", log, re.M)
    types = ("1 and 1", "1 and 2", "2 and 2")
    assert sorted(constants) == sorted(
        (law, pair) for law in ("stronge", "thornton") for pair in types
    )
    lines = re.findall(r"^these constants hold for (.*)$", log, re.M)
    assert sorted(lines) == ["fix other", "fix w0, fix w1, fix w2, fix w3, pair_style"]
    assert find_models(log) == ["thornton", "stronge"]


def test_an_unknown_law_is_refused_with_the_possible_ones(tmp_path):
    with pytest.raises(EngineError) as error:
        run(tmp_path, model="vu_quok_zhang tangential off")
    assert "Invalid model specified" in str(error.value)
    message = "model vu_quok_zhang is unknown. Available models: brake_2012 brake_2015"
    assert message in str(error.value)
    assert " hertz " in str(error.value) and " vu_quoc_zhang " in str(error.value)


def test_constants_of_unused_type_pairs_are_not_checked(tmp_path):
    """An indentation pressure that is impossible for two bodies of the wall's type is accepted if
    no particle has that type."""
    bad = {"model": "brake_2012 tangential off", "more": matrix("indentationPressure", "1e9")}
    assert "atom types 1 and 2" in run(tmp_path, **bad)
    particle = "create_atoms 2 single -0.5 0 0.5\nset group all diameter 0.2 density 2700"
    message = r"indentationPressure 1e\+09 .*two thirds .*\(atom types 2 and 2\)"
    with pytest.raises(EngineError, match=message):
        run(tmp_path, **bad, velocities=particle)


def test_grains_side_by_side_are_no_impact(tmp_path):
    """Grains that move at the same 1 m/s do not meet; a warning needs a relative speed."""
    side_by_side = {"velocities": "velocity all set 1 0 0.01", "timestep": "1e-4", "floor": ""}
    assert "WARNING" not in run(tmp_path, **side_by_side)
    apart = "region one block -0.1 0.1 -1 1 -1 1 units box\ngroup one region one\n"
    against = side_by_side | {"velocities": f"{apart}velocity one set 1 0 0\n"}
    assert "impacts at the current speeds (up to 1)" in run(tmp_path, **against)
