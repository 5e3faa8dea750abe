# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of drop tests (restitution versus impact speed) and of their files."""

from __future__ import annotations

import pytest

import plastigran as pg
from plastigran.calibration import DropTest
from plastigran.calibration.drop_test import read_drop_test


@pytest.fixture
def read(tmp_path):
    def reader(text: str):
        path = tmp_path / "drops.csv"
        path.write_text(text)
        return read_drop_test(path)

    return reader


@pytest.mark.parametrize(
    "text",
    [
        "speed,restitution\n2.0,0.5\n1.0,0.6\n",
        "speed coefficient_of_restitution\n2.0 0.5\n1.0 0.6\n",
        "# steel on granite\nspeed; rebound_speed\n2.0; 1.0\n1.0; 0.6  # a second ball\n",
        f"drop_height, rebound_height\n{4 / 19.62}, {1 / 19.62}\n{1 / 19.62},{0.36 / 19.62}\n",
        f"drop_height\trestitution\n{4 / 19.62}\t0.5\n{1 / 19.62}\t0.6\n",
    ],
)
def test_every_form_of_the_file_is_read(text, read):
    """Speeds, heights and restitutions are read from every supported column of a file.

    A drop height h is converted to the speed sqrt(2 g h).
    """
    drops = read(text)
    assert drops["speed"].tolist() == pytest.approx([2.0, 1.0])
    assert drops["restitution"].tolist() == pytest.approx([0.5, 0.6])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("speed,cor\n1,0.5\n", "'cor' is not a column of a drop test; use one of speed, drop_hei"),
        ("speed\n1\n", "has none of restitution, rebound_speed, rebound_height"),
        ("speed,drop_height,restitution\n1,1,0.5\n", "has speed and drop_height; use one of"),
        (
            "speed,restitution,coefficient_of_restitution\n1,0.5,0.6\n",
            "has two columns with the same name",
        ),
        ("speed,restitution\n1,0.5\n1,1.2\n", "restitution of drop 2 is 1.2; it must be above 0"),
        ("speed,restitution\n1,0\n", "restitution of drop 1 is 0; it must be above 0 and below 1"),
        ("speed,rebound_speed\n1,1.1\n", "restitution of drop 1 is 1.1; it must be above"),
        ("drop_height,restitution\n300,0.5\n", "drop_height of drop 1 is 300; .* the unit: m"),
        ("speed,restitution\n1,half\n", "restitution of drop 1 is 'half', not a number"),
        ("speed,restitution\n1,\n", "restitution of drop 1 is nan; it must be"),
        ("", "is not a table of drops"),
        # Decimal commas split a line into more fields than there are columns.
        ("speed;rebound_speed\n3,5;2,1\n4,5;2,1\n", "is not a table of drops"),
        ("speed,restitution\n1,0.5,0.45\n", "is not a table of drops"),
    ],
)
def test_wrong_files_are_refused(text, message, read):
    with pytest.raises(ValueError, match=message):
        read(text)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([], []), "contains no drop"),
        (
            ([1.0], [0.5], pg.material("steel")),
            "ball is steel and plate is a rigid plate, so neither",
        ),
        (([1.0, 2.0], [0.5]), "2 speeds and 1 restitutions"),
        (([-1.0], [0.5]), "speed is -1"),
    ],
)
def test_wrong_drop_tests_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        DropTest(*arguments)


def test_the_metal_is_the_body_that_is_not_given():
    """The calibrated metal takes the place of the body that the drop test does not name.

    E* of two equal bodies is half of E* of one such body on a rigid plate.
    """
    steel = pg.material("steel")
    on_rigid = DropTest([1.0], [0.5]).contact("thornton", steel)
    on_itself = DropTest([1.0], [0.5], plate=None).contact("thornton", steel)
    glass = pg.material("glass_kp10")
    plate = DropTest([1.0], [0.5], ball=glass, plate=None).contact("thornton", steel)
    assert on_itself.pair.youngs_modulus_eff == pytest.approx(on_rigid.pair.youngs_modulus_eff / 2)
    assert plate.mass_eff / on_rigid.mass_eff == pytest.approx(2500 / 7850, rel=0.02)
    assert plate.pair.yield_strength == pytest.approx(3e8)
