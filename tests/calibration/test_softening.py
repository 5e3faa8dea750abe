# SPDX-License-Identifier: GPL-2.0-or-later
"""Softened materials keep their restitution: by theory, in the engine, from the command line."""

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
#: Laws of v over v_Y and nu alone: their restitution does not change at all.
EXACT_LAWS = {"thornton", "vu_quoc_zhang", "kogut_etsion", "stronge", "brake_2012", "brake_2015"}


@pytest.mark.parametrize("factor", [0.5, 1e-2, 1e-4])
def test_restitution_stays(factor):
    """From the equations of motion: only rounding is left for laws of v/v_Y alone."""
    table = comparison(STEEL, factor, RADIUS, SPEED).set_index("law")
    assert set(table.index) >= EXACT_LAWS
    for law in EXACT_LAWS:
        assert table.loc[law, "restitution_change"] == 0
    others = table.drop(list(EXACT_LAWS | {"hertz"}))
    # Fits with sigma_Y/E or a/R in them change; mdr, which is written for deep contacts, the most.
    assert (others["restitution_change"] > 0).all()
    assert (others["restitution_change"] < 0.2).all()


def test_step_and_overlap_grow_alike():
    factor = 1e-3
    row = comparison(STEEL, factor, RADIUS, SPEED, ["thornton"]).iloc[0]
    assert_allclose(row["timestep_softened"] / row["timestep"], factor**-0.4, rtol=1e-6)
    assert_allclose(row["overlap_softened"] / row["overlap"], factor**-0.4, rtol=1e-9)


def test_softening_the_modulus_alone_is_elastic_and_both_alike_is_not_the_same():
    """With sigma_Y kept nothing yields; with sigma_Y times s the yield speed falls."""

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


def test_viscous_spheres_too():
    """Their restitution is a function of A (E*^2 v/m*^2)^(1/5)..., in which A falls as a time."""
    ice = pg.material("ice")
    speeds = np.geomspace(1e-3, 1, 5)
    before, after = (
        pg.Contact("viscoelastic_hertz", body, body, radius=0.01, radius_other=0.01)
        for body in (ice, soften(ice, 1e-3))
    )
    # Both are integrated in time, to 1e-6.
    assert_allclose(after.restitution(speeds), before.restitution(speeds), rtol=1e-6)


def test_lowest_factor_reaches_the_sound_overlap():
    overlap = 1e-3
    factor = lowest_factor(overlap)
    assert_allclose(overlap * factor**-0.4, SOUND_OVERLAP)
    assert lowest_factor(2 * SOUND_OVERLAP) == 1


@pytest.mark.parametrize("law", ["hertz", "thornton", "universal"])
def test_lowest_factor_bears_the_bed(law):
    """By the law: the weight stays while the strength falls, so grains that yield sink deeper."""

    def rest(factor):
        return resting_overlap(soften(STEEL, factor), RADIUS, 1.0, law)

    factor = lowest_factor(0.0, rest)
    assert_allclose(rest(factor), SOUND_OVERLAP)
    assert rest(factor) >= resting_overlap(soften(STEEL, factor), RADIUS, 1.0) * (1 - 1e-12)
    force = 4 * pi * RADIUS**2 * STEEL.density * 9.81 / 6  # Rumpf's, Z = 6; phi cancels
    soft = soften(STEEL, factor)
    pair = pg.Contact(law, soft, soft, radius=RADIUS, radius_other=RADIUS)
    found = pair.law.follow(RADIUS / 2, [SOUND_OVERLAP * RADIUS])["force"][0]
    assert_allclose(found, force, rtol=1e-3)  # of g
    assert lowest_factor(1e-9, rest) == pytest.approx(factor)  # a slow impact asks for nothing
    # A load that moves the factor by rest comes first, else the impact does.
    assert lowest_factor(SOUND_OVERLAP * 0.9, rest) == pytest.approx(0.9**2.5)


def test_a_bed_at_rest_grows_softer_with_depth():
    """Hertz: overlaps grow as the depth to 2/3; over R they do not depend on R."""
    shallow, deep = (resting_overlap(STEEL, RADIUS, depth) for depth in (0.1, 0.8))
    assert_allclose(deep / shallow, 4)
    assert_allclose(resting_overlap(STEEL, 10 * RADIUS, 0.1), shallow)


@pytest.mark.filterwarnings("ignore::plastigran.contact.RangeWarning")
def test_engine_agrees(tmp_path):
    """The same impact in the engine, stiff and soft, at each one's step: the same restitution
    within what that step leaves, 1e-3."""
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
    assert main([*call, "--factor", "0.1", "--output", str(file)]) == 1  # it is there
    assert "soft.in exists" in capsys.readouterr().err
    for words, said in (
        (["--factor", "2"], "factor is 2; it must lie from"),
        (["--speedup", "0.5"], "--speedup is 0.5; it must be at least 1"),
    ):
        assert main([*call, *words]) == 1
        assert said in capsys.readouterr().err
    with pytest.raises(ValueError, match="youngs_modulus is 210; it must be above 10000 and"):
        soften(attrs.evolve(STEEL, youngs_modulus=210.0), 0.1)
