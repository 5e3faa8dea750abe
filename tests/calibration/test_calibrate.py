# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of calibration: from a measurement on a metal to the constants of its laws."""

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


def has_note(metal: pg.calibration.CalibratedMetal, text: str) -> bool:
    return any(re.search(text, note) for note in metal.notes)


def test_known_strength_is_kept():
    metal = calibrate(**STEEL, yield_strength=3e8)
    assert metal.yield_strength == 3e8
    assert metal.yield_strength_interval == (3e8, 3e8)
    assert metal.law == DEFAULT_LAW
    assert "'metal', yield_strength=3e+08 Pa (3e+08 to 3e+08)" in repr(metal)
    assert metal.material.tangent_modulus == 0
    # Without finite elements, the constants are the defaults of the law.
    defaults = {row["name"]: row["default"] for row in laws.LAWS["vu_quoc_zhang"].parameters()}
    assert metal.constants == defaults


def test_hardness_gives_flow_stress_minus_hardening():
    """The yield strength from a hardness is the flow stress at 8 % strain minus the hardening.

    Its interval combines the errors of the constraint factor (2.6 to 3.0, 7 %) and of the reading
    (3 %).
    """
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
def test_strength_from_leeb_reproduces_the_reading(reading):
    """The yield strength from a Leeb reading reproduces this reading.

    The ends of its interval reproduce readings that are 4.5 % lower and higher.
    """
    metal = calibrate(**STEEL, leeb=reading)
    tester, _ = read_leeb(reading)
    least, largest = metal.yield_strength_interval
    for strength, factor in {metal.yield_strength: 1, least: 1 / 1.045, largest: 1.045}.items():
        body = attrs.evolve(metal.material, yield_strength=strength).body()
        # The ends of the interval are at exp(0.045), which differs from 1.045 by 1e-3.
        assert tester.reading(metal.law, body) == pytest.approx(reading * factor, rel=1.5e-3)
    assert 1.96 * LEEB_SCATTER == pytest.approx(0.045)


def test_strength_from_drops_is_that_of_the_drops():
    speeds = np.array([0.05, 0.1, 0.2])
    metal = calibrate(**ALUMINIUM, yield_strength=1e8).material
    restitution = pg.Contact("thornton", metal, pg.RIGID, radius=2e-3).restitution(speeds)
    ball = calibrate(**ALUMINIUM, drops=DropTest(speeds, restitution), law="thornton")
    assert ball.yield_strength == pytest.approx(1e8, rel=1e-5)  # accuracy of the search
    assert ball.yield_strength_interval[0] < 1e8 < ball.yield_strength_interval[1]
    # A hard ball drops on a plate of the metal; the radius of the ball does not matter.
    ruby = attrs.evolve(pg.material("steel"), youngs_modulus=4e11, yield_strength=1e30, name="ruby")
    drops = DropTest([0.1], [0.5], ball=ruby, plate=None)
    plate = calibrate(**ALUMINIUM, drops=drops, law="thornton").material
    contact = pg.Contact("thornton", ruby, plate, radius=1e-3)
    assert contact.restitution(0.1) == pytest.approx(0.5, rel=1e-5)


def test_large_scatter_gives_a_warning_and_a_wide_interval():
    drops = DropTest([0.05, 0.1, 0.2, 0.3], [0.5, 0.3, 0.5, 0.2])
    message = r"scatter by .* about the law thornton; the stated scatter is 1.0%"
    with pytest.warns(UserWarning, match=message):
        metal = calibrate(**ALUMINIUM, drops=drops, law="thornton", scatter=0.01)
    least, largest = metal.yield_strength_interval
    assert largest / least > 1.5


def test_strength_is_a_lower_bound_if_the_other_body_yields_first():
    soft = attrs.evolve(pg.material("steel"), yield_strength=5e7, name="soft")
    ball = calibrate(**ALUMINIUM, yield_strength=1e9).material
    speeds = np.array([0.1, 0.2])
    measured = pg.Contact("thornton", ball, soft, radius=5e-3).restitution(speeds)
    metal = calibrate(**ALUMINIUM, drops=DropTest(speeds, measured, plate=soft), law="thornton")
    assert metal.yield_strength_interval[1] == inf
    assert has_note(metal, "the other body yields first")
    assert not has_note(metal, "nearly elastic")
    assert metal.to_dict()["yield_strength_interval"][1] is None


def test_expected_error_is_for_the_intended_speeds():
    slow = calibrate(**STEEL, yield_strength=3e8, speeds=(0.01, 0.001), law="kogut_etsion")
    ratio = slow.expected_error.speed_ratio
    assert ratio == pytest.approx((0.001 / slow.yield_speed, 0.01 / slow.yield_speed))
    table = errors_table()
    rows = table[
        (table["law"] == "kogut_etsion")
        & (table["quantity"] == "coefficient_of_restitution")
        & (table["kind"] == "perfectly plastic")
        & (table["speed_ratio_to"] <= 300)
    ]
    error = expected_error("kogut_etsion", (2.0, 200.0), False, 0.01)
    assert (error.restitution, error.restitution_largest) == (rows["rms"].max(), rows["max"].max())


def test_expected_error_is_unknown_outside_the_table():
    assert expected_error("no such law", (2.0, 200.0), False, 0.01).restitution is None
    beyond = expected_error("kogut_etsion", (2.0, 1e6), False, 0.01)
    assert beyond.restitution is None
    assert "not known" in str(beyond)


def test_expected_error_depends_on_hardening_and_contact_radius():
    plain, hardening, wide = (
        expected_error("kogut_etsion", (20.0, 200.0), *contact)
        for contact in ((False, 0.01), (True, 0.01), (False, 0.1))
    )
    assert hardening.regime == "hardening"
    assert wide.regime == "perfectly plastic, large a/R"
    assert wide.restitution_largest >= plain.restitution_largest
    assert hardening.restitution_largest != plain.restitution_largest


def test_expected_error_is_unknown_for_other_pairs():
    """The expected error of a law is known only for spheres on a rigid plane.

    There are finite elements only for this contact.
    """
    drops = DropTest([0.5, 2.0], [0.8, 0.6])
    assert calibrate(**STEEL, drops=drops).expected_error.restitution is not None
    on_glass = attrs.evolve(drops, plate=read_material("glass_kp10"))
    unknown = calibrate(**STEEL, drops=on_glass).expected_error
    assert unknown.restitution is None
    reason = "unknown, because finite elements exist only for spheres on a rigid plane"
    assert str(unknown).startswith(f"not known ({reason}, ")
    # The argument `speeds` always applies to a sphere of the metal on a rigid plane.
    intended = calibrate(**STEEL, drops=on_glass, speeds=(0.05, 0.3)).expected_error
    assert intended.restitution is not None


def test_material_file_reads_back(tmp_path):
    metal = calibrate(**STEEL, hardness="45HRC", plastic_modulus=1e9, name="spring")
    path = tmp_path / "spring.in"
    write_material(metal.material, path, metal.remark)
    copy = pg.material(path)
    assert copy.name == "spring"
    # The file has twelve digits.
    assert copy.variables() == pytest.approx(metal.material.variables(), rel=1e-11)
    assert path.read_text().startswith("# Yield strength from 45 HRC = 446 HV")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "given measurements: none; exactly one is needed"),
        (
            {"hardness": 200, "leeb": 500},
            "given measurements: hardness and leeb; exactly one is needed",
        ),
        ({"yield_strength": 250}, "yield_strength is 250 Pa; .* between 2.06e[+]05 and 6.18e[+]10"),
        ({"hardness": 200, "youngs_modulus": 206}, r"is 206; .*Check the unit: Pa, not MPa or GPa"),
        ({"hardness": 200, "density": 7.85}, r"is 7.85; .*Check the unit: kg/m\^3, not g/cm\^3"),
        ({"hardness": 200, "law": "hertz"}, "it must be a law for yielding spheres"),
        ({"hardness": 200, "plastic_modulus": 1e11}, "plastic_modulus is 1e[+]11 Pa; for 200 HV"),
        ({"leeb": "500HLX"}, "leeb is '500HLX'; it must be a number and a device of HLD, HLG, HLC"),
        ({"leeb": 5}, r"leeb is 5; it must lie from 100 to 1000"),
        ({"leeb": 1000}, "restitution 1 is almost elastic and gives only a lower bound: .* above"),
        ({"leeb": 500, "scatter": 2}, "scatter is 2; it must be above 0 and below 0.5"),
        ({"hardness": 200, "scatter": 0.1}, "scatter is 0.1, but it applies only to leeb or drops"),
        ({"hardness": 200, "strain": "finite"}, "strain is 'finite', .* Give force_ratio"),
        ({"hardness": 200, "radius": "x"}, "radius is 'x', but it applies only to finite elements"),
        ({"hardness": 200, "force_ratio": "x"}, "force_ratio is 'x'"),
        ({"hardness": 200, "speeds": []}, "speeds is empty; give the slowest and the"),
        ({"drops": 5}, "drops is 5; it must be a DropTest or the path of a table"),
    ],
)
def test_wrong_arguments_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        calibrate(**(STEEL | arguments))


def test_hardness_and_leeb_agree_for_steel():
    """For steel, the yield strengths from Vickers hardness and from Leeb hardness agree.

    Their rms difference is below 10 %, the scatter of hardness conversions, and their intervals
    overlap.
    """
    differences = []
    for reading, vickers in leeb_table().to_numpy()[::4]:
        leeb, hardness = calibrate(**STEEL, leeb=reading), calibrate(**STEEL, hardness=vickers)
        assert leeb.material.rate_coefficient == hardness.material.rate_coefficient == 0.014
        differences.append(leeb.yield_strength / hardness.yield_strength - 1)
        intervals = leeb.yield_strength_interval, hardness.yield_strength_interval
        least, largest = zip(*intervals, strict=True)
        assert max(least) < min(largest)
    assert np.sqrt(np.mean(np.square(differences))) < 0.10


def test_impacts_beyond_the_range_of_the_law_give_a_note():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        metal = calibrate(**STEEL, leeb=320, law="kogut_etsion")
    assert has_note(metal, "exceeds the validity range of")


def test_strength_of_steel_is_for_a_strain_rate_of_one_per_second():
    """The yield strength of steel from a Leeb reading is the strength at a strain rate of 1/s.

    In the impact, the strain rate is (v/R)(E*/E')^2, in 1/s. There, the strength is larger by the
    factor 1 + C ln(rate), with the rate coefficient C.
    """
    fast = calibrate(**STEEL, leeb=540, rate_coefficient=0)
    slow = calibrate(**STEEL, leeb=540)
    body = slow.material.body()
    pair = read_leeb(540)[0].pair(body)
    factor = laws.rate_factor(pair, 1.5e-3, 2.05)
    plane_modulus = body.youngs_modulus / (1 - body.poissons_ratio**2)
    rate = 2.05 / 1.5e-3 * (pair.youngs_modulus_eff / plane_modulus) ** 2
    # The law rounds factors to 1e-4.
    assert factor == pytest.approx(1 + 0.014 * np.log(rate), abs=5.1e-5)
    assert fast.yield_strength / slow.yield_strength == pytest.approx(factor, rel=1e-4)
    assert any("rateCoefficient" in line for line in slow.deck_lines())


def test_other_metals_get_a_note_on_the_strain_rate():
    note = "the strength is assumed not to depend on the strain rate"
    assert has_note(calibrate(**ALUMINIUM, hardness=107), note)
    for coefficient in (0.0, 0.015):
        metal = calibrate(**ALUMINIUM, hardness=107, rate_coefficient=coefficient)
        assert not has_note(metal, note)
    assert not has_note(calibrate(**STEEL, hardness=200), note)


def test_trend_of_the_deviation_with_speed_gives_a_note():
    """A note appears if the measured restitution depends on speed in another way than the law.

    The measurements of this test follow the law `thornton`. With the law `universal`, restitution
    decreases less with speed.
    """
    metal = Material("metal", **STEEL, yield_strength=6e8)
    speeds = np.geomspace(0.3, 3, 8)
    impacts = pg.Contact("thornton", metal, pg.RIGID, radius=5e-3).impact(speeds)
    drops = DropTest(speeds, impacts.coefficient_of_restitution)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        other, same = (
            calibrate(**STEEL, drops=drops, law=law) for law in ("universal", "thornton")
        )
    assert has_note(other, r"depends on speed: \+\d.*% at the slowest and -\d.*% at the fastest")
    assert not has_note(same, "at the slowest")


def test_conversions_of_other_metals_give_a_note():
    """A Rockwell hardness of a metal other than steel gives a note; a Vickers hardness does not."""
    titanium = {"youngs_modulus": 1.14e11, "poissons_ratio": 0.34, "density": 4430}
    note = r"for steel \(table 1 of ASTM E140\); for another metal, measure HV"
    assert has_note(calibrate(**titanium, hardness="36HRC"), note)
    assert not has_note(calibrate(**titanium, hardness="354HV"), note)
    assert not has_note(calibrate(**STEEL, hardness="36HRC"), note)
