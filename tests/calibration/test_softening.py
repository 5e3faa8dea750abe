# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests that softened materials keep their restitution, in theory and in LIGGGHTS."""

from __future__ import annotations

import json
from math import pi

import attrs
import numpy as np
import pytest
from numpy.testing import assert_allclose

import plastigran as pg
from plastigran.calibration.softening import (
    SOUND_OVERLAP,
    comparison,
    lowest_factor,
    resting_overlap,
    soften,
)
from plastigran.cli import main
from plastigran.materials import read_material

STEEL = pg.material("steel")
RADIUS, SPEED = 1e-3, 0.5
#: Laws whose restitution depends only on v/v_Y and nu, so that softening does not change it.
EXACT_LAWS = {"thornton", "vu_quoc_zhang", "kogut_etsion", "stronge", "brake_2012", "brake_2015"}


@pytest.mark.parametrize("factor", [0.5, 1e-2, 1e-4])
def test_restitution_stays(factor):
    table = comparison(STEEL, factor, RADIUS, SPEED).set_index("law")
    assert set(table.index) >= EXACT_LAWS
    for law in EXACT_LAWS:
        assert table.loc[law, "restitution_change"] == 0
    others = table.drop(list(EXACT_LAWS | {"hertz"}))
    # Softening changes the restitution of laws that contain sigma_Y/E or a/R. The change is largest
    # for mdr, a law for deep contacts.
    assert (others["restitution_change"] > 0).all()
    assert (others["restitution_change"] < 0.2).all()


def test_time_step_and_overlap_grow_by_the_same_factor():
    factor = 1e-3
    row = comparison(STEEL, factor, RADIUS, SPEED, ["thornton"]).iloc[0]
    assert_allclose(row["timestep_softened"] / row["timestep"], factor**-0.4, rtol=1e-6)
    assert_allclose(row["overlap_softened"] / row["overlap"], factor**-0.4, rtol=1e-9)


def test_strength_must_be_softened_by_its_own_power():
    """Softening by a factor s must multiply sigma_Y by s^0.8 to keep the restitution.

    With an unchanged sigma_Y, the spheres would not yield. With s sigma_Y, the yield speed would be
    too low.
    """

    def restitution(modulus_factor, strength_factor):
        changed = attrs.evolve(
            STEEL,
            youngs_modulus=STEEL.youngs_modulus * modulus_factor,
            yield_strength=STEEL.yield_strength * strength_factor,
        )
        return pg.Contact("thornton", changed, pg.RIGID, radius=RADIUS).restitution(SPEED)

    usual = restitution(1, 1)
    assert_allclose(restitution(1e-3, 1), 1, rtol=1e-12)
    assert restitution(1e-3, 1e-3) < 0.8 * usual
    assert_allclose(restitution(1e-3, 1e-3**0.8), usual, rtol=1e-9)


def test_restitution_of_viscous_spheres_stays():
    """Softening keeps the restitution of viscoelastic spheres.

    Restitution is a function of A (E*^2 v/m*^2)^(1/5), with the dissipative constant A. Softening
    multiplies A by the same factor as the contact time.
    """
    ice = pg.material("ice")
    speeds = np.geomspace(1e-3, 1, 5)
    before, after = (
        pg.Contact("viscoelastic_hertz", body, body, radius=0.01, radius_other=0.01)
        for body in (ice, soften(ice, 1e-3))
    )
    # The law integrates both impacts in time, with a relative error of 1e-6.
    assert_allclose(after.restitution(speeds), before.restitution(speeds), rtol=1e-6)


def test_lowest_factor_reaches_the_sound_overlap():
    overlap = 1e-3
    factor = lowest_factor(overlap)
    assert_allclose(overlap * factor**-0.4, SOUND_OVERLAP)
    assert lowest_factor(2 * SOUND_OVERLAP) == 1


@pytest.mark.parametrize("law", ["hertz", "thornton", "universal"])
def test_lowest_factor_carries_the_bed(law):
    """At the lowest softening factor, grains at rest in a bed reach the largest allowed overlap.

    Softening lowers the yield strength but not the weight, so that yielding grains overlap more
    than elastic grains.
    """

    def rest(factor):
        return resting_overlap(soften(STEEL, factor), RADIUS, 1.0, law)

    factor = lowest_factor(0.0, rest)
    assert_allclose(rest(factor), SOUND_OVERLAP)
    assert rest(factor) >= resting_overlap(soften(STEEL, factor), RADIUS, 1.0) * (1 - 1e-12)
    force = 4 * pi * RADIUS**2 * STEEL.density * 9.81 / 6  # Rumpf 1958, Z = 6; phi cancels
    soft = soften(STEEL, factor)
    pair = pg.Contact(law, soft, soft, radius=RADIUS, radius_other=RADIUS)
    at_limit = pair.law.follow(RADIUS / 2, [SOUND_OVERLAP * RADIUS])["force"][0]
    # The force above uses g = 9.81 m/s^2, 3e-4 more than the package's 9.80665 m/s^2.
    assert_allclose(at_limit, force, rtol=1e-3)
    assert lowest_factor(1e-9, rest) == pytest.approx(factor)  # slow impacts do not matter
    # A fast impact limits the factor more than the bed.
    assert lowest_factor(SOUND_OVERLAP * 0.9, rest) == pytest.approx(0.9**2.5)


def test_overlap_in_a_bed_grows_with_depth():
    """In a bed of elastic grains, overlap/R grows as the depth to the power 2/3 (Hertz).

    It does not depend on the radius R.
    """
    shallow, deep = (resting_overlap(STEEL, RADIUS, depth) for depth in (0.1, 0.8))
    assert_allclose(deep / shallow, 4)
    assert_allclose(resting_overlap(STEEL, 10 * RADIUS, 0.1), shallow)


@pytest.mark.filterwarnings("ignore::plastigran.contact.RangeWarning")
def test_restitution_stays_in_liggghts(tmp_path):
    """Softening does not change the restitution in LIGGGHTS beyond the error of the time step.

    With the recommended time steps, this error is up to 1e-3.
    """
    soft = soften(STEEL, 1e-2)
    runs = [
        pg.collide(["kogut_etsion"], [SPEED], body, radius=RADIUS, folder=tmp_path / body.name)
        for body in (STEEL, soft)
    ]
    measured = [run.table["coefficient_of_restitution"].iloc[0] for run in runs]
    assert_allclose(measured[0], measured[1], atol=1e-3)


def test_command_writes_a_material(tmp_path, capsys):
    file = tmp_path / "soft.in"
    call = ["soften", "--material", "steel", "--radius", "1e-3", "--speed", "0.5"]
    assert (
        main([*call, "--speedup", "10", "--law", "thornton", "--json", "--output", str(file)]) == 0
    )
    numbers = json.loads(capsys.readouterr().out)
    assert_allclose(numbers["speedup"], 10)
    assert_allclose(numbers["factor"], 10**-2.5)
    assert_allclose(
        read_material(file).yield_strength, STEEL.yield_strength * numbers["factor"] ** 0.8
    )
    assert main([*call, "--factor", "0.1", "--output", str(file)]) == 1  # the file exists
    assert "soft.in exists" in capsys.readouterr().err
    for options, message in (
        (["--factor", "2"], "factor is 2; it must lie from"),
        (["--speedup", "0.5"], "--speedup is 0.5; it must be at least 1"),
    ):
        assert main([*call, *options]) == 1
        assert message in capsys.readouterr().err
    with pytest.raises(ValueError, match="youngs_modulus is 210; it must be above 10000 and"):
        soften(attrs.evolve(STEEL, youngs_modulus=210.0), 0.1)
