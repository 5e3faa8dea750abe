# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of drop tests."""

from __future__ import annotations

from math import sqrt

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
def test_forms_of_the_file_say_the_same(text, read):
    """A fall of h gives sqrt(2 g h); heights of rebound and fall are as speeds squared."""
    found = read(text)
    assert found["speed"].tolist() == pytest.approx([2.0, 1.0])
    assert found["restitution"].tolist() == pytest.approx([0.5, 0.6])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("speed,cor\n1,0.5\n", "'cor' is not a column of a drop test; use one of speed, drop_hei"),
        ("speed\n1\n", "has none of restitution, rebound_speed, rebound_height"),
        ("speed,drop_height,restitution\n1,1,0.5\n", "has speed and drop_height; use one of"),
        (
            "speed,restitution\n1,0.5\n1,1.2\n",
            "restitution of drop 2 is 1.2; it must be above 0",
        ),
        ("speed,restitution\n1,0\n", "restitution of drop 1 is 0; it must be above 0 and below 1"),
        ("speed,rebound_speed\n1,1.1\n", "restitution of drop 1 is 1.1; it must be above"),
        (
            "drop_height,restitution\n300,0.5\n",
            "drop_height of drop 1 is 300; .* 1e-06 and below 10 .m.. Check the unit: m",
        ),
        ("speed,restitution\n1,half\n", "restitution of drop 1 is 'half', not a number"),
        ("speed,restitution\n1,\n", "restitution of drop 1 is nan; it must be"),
        ("", "is not a table of drops"),
    ],
)
def test_what_is_no_drop_test_is_refused(text, said, read):
    with pytest.raises(ValueError, match=said):
        read(text)


def test_a_test_needs_drops_and_the_metal():
    with pytest.raises(ValueError, match="contains no drop"):
        DropTest([], [])
    with pytest.raises(ValueError, match="ball is steel and the plate is given"):
        DropTest([1.0], [0.5], ball=pg.material("steel"))
    with pytest.raises(ValueError, match="2 speeds and 1 restitutions"):
        DropTest([1.0, 2.0], [0.5])
    with pytest.raises(ValueError, match="speed is -1"):
        DropTest([-1.0], [0.5])


def test_the_metal_stands_where_it_is_asked_about():
    """Two equal bodies are half as stiff as one on a rigid plate."""
    steel = pg.material("steel")
    on_rigid = DropTest([1.0], [0.5]).contact("thornton", steel)
    on_itself = DropTest([1.0], [0.5], plate=None).contact("thornton", steel)
    of_glass = DropTest([1.0], [0.5], ball=pg.material("glass_kp10"), plate=None)
    assert on_itself.pair.youngs_modulus_eff == pytest.approx(on_rigid.pair.youngs_modulus_eff / 2)
    glass = of_glass.contact("thornton", steel)
    assert glass.mass_eff / on_rigid.mass_eff == pytest.approx(2500 / 7850, rel=0.02)
    assert sqrt(glass.pair.yield_strength) == pytest.approx(sqrt(3e8))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("speed;rebound_speed\n3,5;2,1\n4,5;2,1\n", "is not a table of drops"),
        ("speed,restitution\n1,0.5,0.45\n", "is not a table of drops"),
        ("speed,restitution,coefficient_of_restitution\n1,0.5,0.6\n", "has a column twice"),
    ],
)
def test_lines_of_more_fields_and_columns_given_twice_are_refused(text, said, tmp_path):
    """Decimal commas part a line into more fields than there are columns."""
    file = tmp_path / "drops.csv"
    file.write_text(text)
    with pytest.raises(ValueError, match=said):
        read_drop_test(file)
