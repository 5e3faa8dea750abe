# SPDX-License-Identifier: GPL-2.0-or-later
"""Unusual radii give a warning to check the unit; absurd radii and speeds are refused."""

from __future__ import annotations

import pytest
from commands import exit_code

import plastigran as pg
from plastigran.declared import SizeWarning

STEEL = "--young 2.1e11 --poisson 0.3 --density 7850 --yield 3e8"
UNUSUAL = [
    "timestep --law thornton --material steel --speed 1 --radius 5",
    "soften --material steel --speedup 8 --speed 1 --radius 5",
    "modes --material ice --radius 5",
    "impact --law thornton --theory --material steel --speed 1 --radius 5 --output {folder}",
]
SLOW = [
    "timestep --law thornton --material steel --speed 1e-300",
    "impact --law thornton --theory --material steel --speed 1e-300 --output {folder}",
    "impact --law thornton --material steel --speed 1e-300 --output {folder}",
]
ABSURD = [
    *(line.replace("--radius 5", "--radius 1e300") for line in UNUSUAL),
    "soften --material steel --speedup 8 --speed 1 --radius 1e-300",
    f"fem throw {STEEL} --radius 1e300 --speed 0.1",
]
REFUSED = [(line, "it must lie from 1e-12 to 1e+06 [m]") for line in ABSURD]
REFUSED += [(line, "speed is 1e-300; it must be 1e-09 or more and finite [m/s]") for line in SLOW]


@pytest.mark.filterwarnings("default::plastigran.declared.SizeWarning")
@pytest.mark.parametrize("line", UNUSUAL, ids=lambda line: line.split()[0])
def test_a_radius_in_mm_gives_one_warning(line, tmp_path, capsys):
    assert exit_code(line.format(folder=tmp_path / "out")) == 0
    said = capsys.readouterr().err
    assert said.count("radius is 5 m, which is 5000 mm; radii are usually between 1e-09 and") == 1
    assert "Check the unit: radii are in m, not mm" in said


@pytest.mark.parametrize(("line", "message"), REFUSED)
def test_an_absurd_radius_or_speed_is_refused(line, message, tmp_path, capsys):
    """The command fails with a message that states the allowed range."""
    assert exit_code(line.format(folder=tmp_path / "out")) in (1, 2)
    assert message in capsys.readouterr().err


def test_a_truth_value_is_not_a_number():
    with pytest.raises(ValueError, match=r"radius is True, not a number \[m\]"):
        pg.Contact("thornton", pg.material("steel"), pg.RIGID, radius=True)


@pytest.mark.parametrize("radius", [3, 1e-10])
def test_an_unusual_radius_in_python_gives_a_warning(radius):
    with pytest.warns(SizeWarning, match=rf"radius is {radius:g} m, which is .* mm"):
        pg.Contact("thornton", pg.material("steel"), pg.RIGID, radius=radius)


@pytest.mark.parametrize("radius", [1e-9, 0.5])
def test_usual_radii_give_no_warning(radius):
    pg.Contact("thornton", pg.material("steel"), pg.RIGID, radius=radius)
