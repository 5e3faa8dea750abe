# SPDX-License-Identifier: GPL-2.0-or-later
"""The law `universal` against the finite elements of metals that its fit has not seen."""

from __future__ import annotations

import re
from itertools import product

import attrs
import numpy as np
import pandas as pd
import pytest

from plastigran import laws
from plastigran.calibration.expected_errors import WIDE
from plastigran.engine.process import PROJECT
from plastigran.materials import RIGID
from plastigran.physics import central
from plastigran.validation.spheres import table
from plastigran.validation.spheres.fit import fit
from plastigran.validation.spheres.forms import Metals, peak
from plastigran.validation.spheres.metals import METALS, PLANE_MODULUS

TABLE = table()
RADIUS, MASS = 0.01, 1.0
#: a/R to which the law is stated to be good.
WIDEST = 0.1


def pair_of(metal: str) -> laws.MaterialPair:
    """A metal of the table on a rigid plane."""
    row = TABLE[TABLE["metal"] == metal].iloc[0]
    youngs_modulus = PLANE_MODULUS * (1 - row["poissons_ratio"] ** 2)
    slope = row["hardening_ratio"] / (1 + row["hardening_ratio"])  # E_t/E = H/(E + H)
    body = laws.Body(
        youngs_modulus,
        row["poissons_ratio"],
        row["yield_strength_ratio"] * PLANE_MODULUS,
        tangent_modulus=slope * youngs_modulus,
    )
    return laws.combine(body, RIGID)


def largest_errors(rows: pd.DataFrame) -> dict[str, float]:
    """Of the law's impacts at the rows' speeds, in per cent: `restitution` and `force`."""
    off = {"restitution": [0.0], "force": [0.0]}
    for metal, part in rows.groupby("metal"):
        pair = pair_of(metal)
        speeds = part["speed_ratio"].to_numpy() * central.yield_speed(pair, RADIUS, MASS)
        impact = laws.Universal(pair).central_impact(RADIUS, MASS, speeds)
        overlap_y = RADIUS * laws.yield_radius_ratio(pair) ** 2
        force_y = 4 / 3 * pair.youngs_modulus_eff * np.sqrt(RADIUS) * overlap_y**1.5
        restitution = impact.coefficient_of_restitution / part["coefficient_of_restitution"]
        off["restitution"].append(100 * np.abs(restitution - 1).max())
        off["force"].append(
            100 * np.abs(impact.force_max / force_y / part["force_ratio"] - 1).max()
        )
    return {name: max(values) for name, values in off.items()}


HELD = TABLE[(TABLE["set"] == "held") & (TABLE["contact_radius_over_radius"] <= WIDEST)]
SLOW = HELD["speed_ratio"] <= 300
PLAIN = (HELD["hardening_ratio"] == 0) & (HELD["contact_radius_over_radius"] < WIDE)


@pytest.mark.parametrize(
    ("rows", "restitution", "force"),
    [
        pytest.param(HELD[SLOW & PLAIN], 1, 1, id="perfectly plastic, a/R below 0.05"),
        pytest.param(HELD[SLOW & ~PLAIN], 2, 2, id="hardening to E/20, a/R to 0.1"),
        pytest.param(HELD[~SLOW], 2, 2, id="beyond 300 times the speed at yield"),
    ],
)
def test_metals_that_the_fit_has_not_seen(rows, restitution, force):
    """The law is meant to be good to 1 %, and to 2 % where metals harden or contacts are wide."""
    assert len(rows) >= 9
    found = largest_errors(rows)
    assert found["restitution"] < restitution
    assert found["force"] < force


def test_the_table_holds_every_metal():
    assert list(TABLE["metal"].unique()) == [metal.name for metal in METALS]
    held = {metal.name for metal in METALS if metal.held}
    assert set(TABLE.loc[TABLE["set"] == "held", "metal"]) == held


def test_the_law_has_the_constants_of_the_fit():
    header = PROJECT / "contact_models" / "plastigran" / "laws" / "universal.h"
    said = re.findall(r"\b(\w_\d) = ([\d.]+)[,;]", header.read_text())
    assert {name: float(value) for name, value in said} == attrs.asdict(fit(TABLE))


def test_the_fit_moves_the_law_itself():
    """Forms of the fit and compiled law, which are written separately: to rounding, hardening and
    wide contacts too. The table's columns have six digits, which do not enter here."""
    constants = fit(TABLE)
    for metal, rows in TABLE.groupby("metal"):
        pair = pair_of(metal)
        overlap_y = RADIUS * laws.yield_radius_ratio(pair) ** 2
        force_y = 4 / 3 * pair.youngs_modulus_eff * np.sqrt(RADIUS) * overlap_y**1.5
        overlap = np.geomspace(1.01, 500, 50)
        found = laws.Universal(pair).follow(RADIUS, overlap * overlap_y)
        expected = peak(constants, Metals.of(rows.iloc[:1]), np.sqrt(overlap))
        assert found["force"] / force_y == pytest.approx(expected.force, rel=1e-12)
        stored = found["elastic_energy"] / (force_y * overlap_y)
        assert stored == pytest.approx(expected.work_unloading, rel=1e-11)


def test_force_and_slope_go_on_at_yield():
    pair = pair_of("s0.0012-nu0.3-H0.05")
    overlap_y = RADIUS * laws.yield_radius_ratio(pair) ** 2
    for step in (1e-3, 1e-4):
        force = laws.Universal(pair).follow(
            RADIUS, overlap_y * np.array([1 - step, 1.0, 1 + step])
        )["force"]
        below, beyond = np.diff(force) / (force[1] * step)
        assert below == pytest.approx(1.5, abs=0.5 * step)  # of Hertz; its curvature is 3/4
        assert beyond == pytest.approx(1.5, abs=0.5 * step)


@pytest.mark.parametrize("yield_strength_ratio", [1e-6, 1e-3, 0.05, 0.3])
@pytest.mark.parametrize("poissons_ratio", [0.0, 0.3, 0.4999])
def test_any_metal_presses_harder_and_loses_more(yield_strength_ratio, poissons_ratio):
    """Force and plastic work never fall as a contact is pressed on, up to overlaps of two radii:
    restitution is at most 1 at any speed."""
    for slope, mirrored in product((0.0, 0.01, 0.2, 0.999), (False, True)):
        body = laws.Body(7e10, poissons_ratio, yield_strength_ratio * 7e10, 0, slope * 7e10)
        pair = laws.combine(body, body if mirrored else RIGID)
        overlap_y = RADIUS * laws.yield_radius_ratio(pair) ** 2
        overlap = np.geomspace(0.5 * overlap_y, 2 * RADIUS, 3000)
        answer = laws.Universal(pair).follow(RADIUS, overlap)
        assert (np.diff(answer["force"]) >= 0).all()
        work = answer["plastic_work"]
        total = work + answer["elastic_energy"]
        assert (np.diff(work) >= -1e-13 * total[1:]).all()  # a difference of works, rounded
        assert (work >= -1e-13 * total).all()
