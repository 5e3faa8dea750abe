# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the flow stress from hardness, and of readings of rebound hardness testers."""

from __future__ import annotations

import attrs
import numpy as np
import pytest

from plastigran import laws
from plastigran.calibration.hardness import (
    ROCKWELL_C,
    ROCKWELL_C_VICKERS,
    SCALES,
    flow_stress,
    indentation_pressure,
    leeb_table,
    read_hardness,
    steel_yield_strength,
)
from plastigran.physics.rebound_hardness import TESTERS, ReboundTester


@pytest.mark.parametrize(
    ("hardness", "vickers"),
    [
        (271, 271),
        ("271", 271),
        ("271HV", 271),
        ("45HRC", 446),  # ASTM E140, table 1
        ("45 hrc", 446),
        ("60HRC", 697),
        ("21HRC", 243),  # between two rows of the table; E140 has 243
        ("200HB", 210.5),  # ISO 18265: 210 HV is 200 HB
        ("285HBW", 300),
        ("380 HV10", 380),  # with its load, ISO 6507-1
        ("380HV0.5", 380),
        ("285 HBW 10/3000", 300),
    ],
)
def test_scales_are_converted_by_the_standards(hardness, vickers):
    assert read_hardness(hardness).vickers == pytest.approx(vickers, rel=3e-3)


def test_brinell_and_rockwell_scales_agree():
    """The conversions from Brinell (ISO 18265) and Rockwell (ASTM E140) to Vickers agree."""
    vickers = dict(zip(ROCKWELL_C, ROCKWELL_C_VICKERS, strict=True))
    for rockwell, brinell in {50: 481, 40: 371, 30: 286, 20: 226}.items():
        assert SCALES["HB"].vickers(brinell) == pytest.approx(vickers[rockwell], rel=0.015)


def test_flow_stress_is_that_of_a_fully_plastic_indentation():
    """The flow stress is the mean pressure of the Vickers indentation, divided by 2.8.

    At 100 HV and a load of 100 kgf, the sloping area of the indentation is 1 mm^2 and its projected
    area 0.9272 mm^2.
    """
    pressure = 100 * 9.807 / (0.9272e-6)
    assert indentation_pressure(100) == pytest.approx(pressure, rel=1e-12)
    assert flow_stress([100, 200]) == pytest.approx([pressure / 2.8, pressure / 1.4], rel=1e-12)


def test_tensile_strength_of_steel_is_below_the_flow_stress():
    vickers = np.linspace(130, 580)  # 300 to 1600 MPa
    assert np.all(steel_yield_strength(vickers) < flow_stress(vickers))


@pytest.mark.parametrize(
    ("hardness", "message"),
    [
        ("380 HV0", "must be a number and a scale"),
        ("380 HV10/0", "must be a number and a scale"),
        ("45HRX", "the scale of hardness is HRX; it must be one of HV, HB, HRC"),
        ("hard", "hardness is 'hard'; it must be a number and a scale"),
        (2.6e9, r"hardness is 2.6e\+09; it must lie from 5 to 2000 \[HV\]"),
        ("72HRC", r"hardness is 72; it must lie from 20 to 68 \[HRC\]"),
        ("nan", "hardness is 'nan'"),
    ],
)
def test_wrong_hardness_is_refused(hardness, message):
    with pytest.raises(ValueError, match=message):
        read_hardness(hardness)


def test_leeb_table_is_complete():
    table = leeb_table()
    assert len(table) == 59
    assert table["HLD"].is_monotonic_increasing
    assert table["HV"].is_monotonic_increasing


def test_reading_is_1000_times_the_restitution_of_the_law():
    steel, tester = laws.Body(206e9, 0.3, 1e9), TESTERS["D"]
    # E* of WC-Co on steel is 168 GPa.
    assert tester.pair(steel).youngs_modulus_eff == pytest.approx(168e9, rel=5e-3)
    law = laws.LAWS["thornton"](tester.pair(steel))
    restitution = law.central_impact(1.5e-3, 5.45e-3, 2.05).coefficient_of_restitution
    assert tester.reading("thornton", steel) == pytest.approx(1000 * restitution, rel=1e-12)
    assert tester.restitution(1000 * restitution) == pytest.approx(restitution, rel=1e-12)


def test_gravity_under_the_sensor_lowers_readings():
    """A sensor above the surface reads a lower restitution, because gravity acts in between.

    For a sensor at h = 1 mm, 2 g h is added to the square of the speed before the impact and
    subtracted after the rebound.
    """
    tester = attrs.evolve(TESTERS["D"], sensor_height=1e-3)
    share = 2 * 9.81 * 1e-3 / tester.speed**2
    for strength in (5e8, 1e9, 2e9):
        steel = laws.Body(206e9, 0.3, strength)
        without, lowered = (device.reading("thornton", steel) for device in (TESTERS["D"], tester))
        expected = 1e3 * ((without / 1e3) ** 2 * (1 + share) - share) ** 0.5
        # Restitution decreases by 0.06 % for a speed that is 0.23 % higher.
        assert lowered == pytest.approx(expected, rel=1.5e-3)
        restitution = tester.impact("thornton", steel).coefficient_of_restitution
        assert tester.restitution(lowered) == pytest.approx(restitution, rel=1e-9)


@pytest.mark.parametrize(
    ("change", "message"),
    [({"mass": 0}, "mass is 0"), ({"sensor_height": -1e-3}, "sensor_height is -0.001")],
)
def test_wrong_testers_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        ReboundTester(**attrs.asdict(TESTERS["D"], recurse=False) | change)
