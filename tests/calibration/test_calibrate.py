# SPDX-License-Identifier: GPL-2.0-or-later
"""From a measurement of a metal to its constants."""

from __future__ import annotations

import re
import warnings
from math import inf

import attrs
import numpy as np
import pytest

import plastigran as pg
from plastigran import laws
from plastigran.calibration import DropTest, calibrate
from plastigran.calibration.expected_errors import DEFAULT_LAW, errors_table, expected_error
from plastigran.calibration.hardness import leeb_table
from plastigran.calibration.strength import LEEB_SCATTER, read_leeb
from plastigran.materials import Material, read_material, write_material

STEEL = {"youngs_modulus": 206e9, "poissons_ratio": 0.3, "density": 7850.0}
ALUMINIUM = {"youngs_modulus": 70e9, "poissons_ratio": 0.3, "density": 2700.0}


def test_a_strength_that_is_given_is_taken_as_it_is():
    found = calibrate(**STEEL, yield_strength=3e8)
    assert found.yield_strength == 3e8
    assert found.yield_strength_interval == (3e8, 3e8)
    assert found.law == DEFAULT_LAW
    assert "'metal', yield_strength=3e+08 Pa (3e+08 to 3e+08)" in repr(found)
    assert found.material.tangent_modulus == 0


def test_hardness_is_the_flow_stress_less_what_hardening_adds():
    """sigma = H/2.8 at 8 % strain; the interval is of constraint factors 2.6 to 3.0 (7 %) and of
    the reading (3 %)."""
    flow = 9.807e6 * 271 / 0.9272 / 2.8
    plain = calibrate(**STEEL, hardness=271)
    assert plain.yield_strength == pytest.approx(flow, rel=1e-12)
    least, largest = plain.yield_strength_interval
    assert (largest - least) / (2 * flow) == pytest.approx(np.hypot(0.07, 0.03), rel=1e-9)
    hardened = calibrate(**STEEL, hardness="271HV", plastic_modulus=2e9)
    assert hardened.yield_strength == pytest.approx(flow - 0.08 * 2e9, rel=1e-12)
    # 1/E_t = 1/E + 1/H
    assert 1 / hardened.material.tangent_modulus == pytest.approx(1 / 206e9 + 1 / 2e9, rel=1e-12)


@pytest.mark.parametrize("reading", [320, 480, 640, 780])
def test_leeb_is_the_inverse_of_the_law_s_own_impact(reading):
    """The strength found gives the reading back, and its interval the readings 4.5 % off."""
    found = calibrate(**STEEL, leeb=reading)
    tester, _ = read_leeb(reading)
    for strength, factor in zip(
        (found.yield_strength, *found.yield_strength_interval), (1, 1 / 1.045, 1.045), strict=True
    ):
        body = attrs.evolve(found.material, yield_strength=strength).body()
        # The interval's ends are 1.96 standard deviations in the logarithm: exp(0.045).
        assert tester.reading(found.law, body) == pytest.approx(reading * factor, rel=1.5e-3)
    assert 1.96 * LEEB_SCATTER == pytest.approx(0.045)


def test_drops_of_a_known_strength_give_it_back():
    speeds = np.array([0.05, 0.1, 0.2])
    ball = pg.Contact("thornton", calibrate(**ALUMINIUM, yield_strength=1e8).material, pg.RIGID,
                      radius=2e-3)  # fmt: skip
    found = calibrate(**ALUMINIUM, drops=DropTest(speeds, ball.restitution(speeds)), law="thornton")
    assert found.yield_strength == pytest.approx(1e8, rel=1e-5)  # of the search
    assert found.yield_strength_interval[0] < 1e8 < found.yield_strength_interval[1]
    # A plate of the metal under a hard ball, whatever its radius.
    ruby = attrs.evolve(pg.material("steel"), youngs_modulus=4e11, yield_strength=1e30, name="ruby")
    dropped = DropTest([0.1], [0.5], ball=ruby, plate=None)
    plate = calibrate(**ALUMINIUM, drops=dropped, law="thornton")
    contact = pg.Contact("thornton", ruby, plate.material, radius=1e-3)
    assert contact.restitution(0.1) == pytest.approx(0.5, rel=1e-5)


def test_scatter_beyond_the_stated_is_said_and_widens_the_interval():
    speeds = np.array([0.05, 0.1, 0.2, 0.3])
    drops = DropTest(speeds, np.array([0.5, 0.3, 0.5, 0.2]))
    with pytest.warns(
        UserWarning, match=r"scatter by .* about the law thornton; the stated scatter is 1.0%"
    ):
        found = calibrate(**ALUMINIUM, drops=drops, law="thornton", scatter=0.01)
    least, largest = found.yield_strength_interval
    assert largest / least > 1.5


def test_a_body_that_yields_first_makes_the_strength_a_lower_bound():
    soft = attrs.evolve(pg.material("steel"), yield_strength=5e7, name="soft")
    ball = calibrate(**ALUMINIUM, yield_strength=1e9).material
    speeds = np.array([0.1, 0.2])
    measured = pg.Contact("thornton", ball, soft, radius=5e-3).restitution(speeds)
    drops = DropTest(speeds, measured, plate=soft)
    found = calibrate(**ALUMINIUM, drops=drops, law="thornton")
    assert found.yield_strength_interval[1] == inf
    assert any("the other body yields first" in note for note in found.notes)
    assert not any("nearly elastic" in note for note in found.notes)
    assert found.to_dict()["yield_strength_interval"][1] is None


def test_error_is_that_of_the_speeds_that_are_asked_about():
    slow = calibrate(**STEEL, yield_strength=3e8, speeds=(0.01, 0.001), law="kogut_etsion")
    ratio = slow.expected_error.speed_ratio
    assert ratio == pytest.approx((0.001 / slow.yield_speed, 0.01 / slow.yield_speed))
    table = errors_table()
    rows = table[
        (table["law"] == "kogut_etsion")
        & (table["quantity"] == "coefficient_of_restitution")
        & (table["kind"] == "perfectly plastic")
    ]
    found = expected_error("kogut_etsion", (2.0, 200.0), False, 0.01)
    assert found.restitution_largest == rows[rows["speed_ratio_to"] <= 300]["max"].max()
    assert found.restitution == rows[rows["speed_ratio_to"] <= 300]["rms"].max()


def test_error_is_not_known_beyond_the_table():
    assert expected_error("no such law", (2.0, 200.0), False, 0.01).restitution is None
    beyond = expected_error("kogut_etsion", (2.0, 1e6), False, 0.01)
    assert beyond.restitution is None
    assert "not known" in str(beyond)


def test_hardening_and_wide_contacts_have_errors_of_their_own():
    plain, hardening, wide = (
        expected_error("kogut_etsion", (20.0, 200.0), *kind)
        for kind in ((False, 0.01), (True, 0.01), (False, 0.1))
    )
    assert hardening.regime == "hardening"
    assert wide.regime == "perfectly plastic, large a/R"
    assert wide.restitution_largest >= plain.restitution_largest
    assert hardening.restitution_largest != plain.restitution_largest


def test_constants_without_finite_elements_are_the_law_s_own():
    own = {row["name"]: row["default"] for row in laws.LAWS["vu_quoc_zhang"].parameters()}
    assert calibrate(**STEEL, yield_strength=3e8).constants == own


def test_a_material_file_reads_back(tmp_path):
    found = calibrate(**STEEL, hardness="45HRC", plastic_modulus=1e9, name="spring")
    path = tmp_path / "spring.in"
    write_material(found.material, path, found.remark)
    read = pg.material(path)
    assert read.name == "spring"
    # Twelve digits are written.
    assert read.variables() == pytest.approx(found.material.variables(), rel=1e-11)
    assert path.read_text().startswith("# Yield strength from 45 HRC = 446 HV")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({}, "none of yield_strength, hardness, leeb, drops is given"),
        ({"hardness": 200, "leeb": 500}, "hardness and leeb of .* exactly one is needed"),
        ({"yield_strength": 250}, "yield_strength is 250 Pa; .* between 2.06e[+]05 and 6.18e[+]10"),
        ({"hardness": 200, "youngs_modulus": 206}, r"is 206; .*Check the unit: Pa, not MPa or GPa"),
        ({"yield_strength": 250, "youngs_modulus": 206e3}, r"youngs_modulus is 206000; .* not MPa"),
        (
            {"hardness": 200, "density": 7.85},
            r"density is 7.85; .*Check the unit: kg/m\^3, not g/cm\^3",
        ),
        (
            {"hardness": 200, "law": "hertz"},
            "law is 'hertz'; it must be one of the laws for spheres that yield",
        ),
        ({"hardness": 200, "plastic_modulus": 1e11}, "plastic_modulus is 1e[+]11 Pa; for 200 HV"),
        ({"leeb": "500HLX"}, "leeb is '500HLX'; it must be a number and a device of HLD, HLG, HLC"),
        ({"leeb": 5}, r"leeb is 5; it must lie from 100 to 1000"),
        ({"leeb": 1000}, "restitution 1 is almost elastic and gives only a lower bound: .* above"),
        ({"leeb": 500, "scatter": 2}, "scatter is 2; it must be above 0 and below 0.5"),
        (
            {"hardness": 200, "scatter": 0.1},
            "scatter is 0.1, but it applies only to leeb or drops, not",
        ),
        ({"hardness": 200, "strain": "finite"}, "strain is 'finite', .* Give force_ratio"),
        ({"hardness": 200, "radius": "x"}, "radius is 'x', but it applies only to finite elements"),
        ({"hardness": 200, "force_ratio": "x"}, "force_ratio is 'x'"),
        (
            {"hardness": 200, "speeds": []},
            "speeds is empty; it must be the smallest and the largest",
        ),
        ({"drops": 5}, "drops is 5; it must be a DropTest or the file of one"),
    ],
)
def test_bad_input_is_named(given, said):
    with pytest.raises(ValueError, match=said):
        calibrate(**(STEEL | given))


def test_hardness_and_leeb_are_inverses_of_the_steel_table():
    """Of a row, the strength by either number: within 10 % in the root mean square, which is what
    conversions scatter by in HV, and each row's intervals overlap."""
    off = []
    for reading, vickers in leeb_table().to_numpy()[::4]:
        rebound, dent = calibrate(**STEEL, leeb=reading), calibrate(**STEEL, hardness=vickers)
        assert rebound.material.rate_coefficient == dent.material.rate_coefficient == 0.014
        off.append(rebound.yield_strength / dent.yield_strength - 1)
        least, largest = zip(
            rebound.yield_strength_interval, dent.yield_strength_interval, strict=True
        )
        assert max(least) < min(largest)
    assert np.sqrt(np.mean(np.square(off))) < 0.10


def test_numbers_that_leave_the_law_s_range_are_noted_not_warned():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = calibrate(**STEEL, leeb=320, law="kogut_etsion")
    assert any("exceeds the validity range of" in note for note in found.notes)


def test_rate_of_strain_takes_its_share_of_the_strength_of_an_impact():
    """The strength at 1/s is less by 1 + C ln of the ball's rate, (v/R)(E*/E')^2."""
    fast = calibrate(**STEEL, leeb=540, rate_coefficient=0)
    slow = calibrate(**STEEL, leeb=540)
    body = slow.material.body()
    pair = read_leeb(540)[0].pair(body)
    factor = laws.rate_factor(pair, 1.5e-3, 2.05)
    plane_modulus = body.youngs_modulus / (1 - body.poissons_ratio**2)
    rate = 2.05 / 1.5e-3 * (pair.youngs_modulus_eff / plane_modulus) ** 2
    # Factors come in steps of 1e-4.
    assert factor == pytest.approx(1 + 0.014 * np.log(rate), abs=5.1e-5)
    assert fast.yield_strength / slow.yield_strength == pytest.approx(factor, rel=1e-4)
    assert any("rateCoefficient" in line for line in slow.deck_lines())


def test_a_strength_that_may_grow_with_the_rate_is_said():
    """Of a metal that is no steel no coefficient is taken by itself."""
    aluminium = {"youngs_modulus": 6.9e10, "poissons_ratio": 0.33, "density": 2700}
    said = "no dependence on the strain rate is assumed"
    assert any(said in note for note in calibrate(**aluminium, hardness=107).notes)
    for coefficient in (0.0, 0.015):
        found = calibrate(**aluminium, hardness=107, rate_coefficient=coefficient)
        assert not any(said in note for note in found.notes)
    assert not any(said in note for note in calibrate(**STEEL, hardness=200).notes)


def test_a_slope_that_is_not_the_laws_is_said():
    """Drops made by one law, read by another whose restitution falls less; and by itself."""
    metal = Material("mine", **STEEL, yield_strength=6e8)
    speeds = np.geomspace(0.3, 3, 8)
    made = pg.Contact("thornton", metal, pg.RIGID, radius=5e-3).impact(speeds)
    fall = DropTest(speeds, made.coefficient_of_restitution)
    said = r"depends on speed: \+\d.*% at the slowest and -\d.*% at the fastest"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        other = calibrate(**STEEL, drops=fall, law="universal")
        same = calibrate(**STEEL, drops=fall, law="thornton")
    assert any(re.search(said, note) for note in other.notes)
    assert not any("at the slowest" in note for note in same.notes)


def test_no_error_is_claimed_of_pairs_that_were_not_computed():
    """The finite elements are of spheres on a rigid plane."""
    fall = {"speed": [0.5, 2.0], "restitution": [0.8, 0.6]}
    on_rigid = calibrate(**STEEL, drops=DropTest(**fall))
    assert on_rigid.expected_error.restitution is not None
    on_glass = calibrate(**STEEL, drops=DropTest(**fall, plate=read_material("glass_kp10")))
    assert on_glass.expected_error.restitution is None
    said = str(on_glass.expected_error)
    assert said.startswith("not known (finite elements are of spheres on a rigid plane, ")
    asked = calibrate(
        **STEEL, drops=DropTest(**fall, plate=read_material("glass_kp10")), speeds=(0.05, 0.3)
    )
    assert asked.expected_error.restitution is not None, "of the metal on a rigid plane"


def test_a_steels_conversion_is_said_of_another_metal():
    """Vickers hardness needs none."""
    titanium = {"youngs_modulus": 1.14e11, "poissons_ratio": 0.34, "density": 4430}
    said = "for steel (table 1 of ASTM E140); for another metal, measure HV"
    assert any(said in note for note in calibrate(**titanium, hardness="36HRC").notes)
    assert not any(said in note for note in calibrate(**titanium, hardness="354HV").notes)
    assert not any(said in note for note in calibrate(**STEEL, hardness="36HRC").notes)
