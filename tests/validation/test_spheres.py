# SPDX-License-Identifier: GPL-2.0-or-later
"""Laws against finite elements of spheres: the pages and the package hold the errors there are."""

from __future__ import annotations

import pandas as pd
import pytest

from plastigran.validation import choice, laws_on_spheres, offset, paper_sphere, steel
from plastigran.validation.report import ERRORS
from plastigran.validation.spheres import table


@pytest.fixture(scope="module")
def compared() -> pd.DataFrame:
    return laws_on_spheres.compare()


def test_the_errors_of_the_package_and_the_pages_are_those_of_the_laws(compared, assert_on_page):
    kept = pd.read_csv(ERRORS)
    unfitted = laws_on_spheres.without_fitted_metals(compared)
    found = laws_on_spheres.errors(unfitted)
    keys = ["law", "kind", "speed_ratio_from", "speed_ratio_to", "quantity", "cases"]
    assert kept[keys].to_numpy().tolist() == found[keys].to_numpy().tolist()
    for size in ("rms", "max"):  # 1e-6: rounding of libraries, where an error is next to nothing
        assert kept[size].to_numpy() == pytest.approx(found[size].to_numpy(), rel=1e-3, abs=1e-6)
    rebounds, rated = steel.rebounds(), steel.rebounds(**offset.RATE)
    for word in ("restitution", "force"):
        assert_on_page(word, choice.by_law(compared, rebounds, word))
    assert_on_page("regimes", choice.by_regime(unfitted, rebounds, rated))
    assert_on_page("leeb_rate", offset.with_rate(rebounds, rated))
    assert_on_page("leeb", steel.summary(rebounds))


def test_every_yielding_law_and_every_row_is_compared(compared):
    rows = table()
    assert len(compared) == len(laws_on_spheres.yielding_laws()) * (rows["speed_ratio"] > 1).sum()
    assert set(compared["kind"]) <= set(laws_on_spheres.KINDS)


def test_the_errors_of_universal_are_those_of_metals_outside_its_fit(compared):
    """The two sets of rows share no metal, and together they are all."""
    by_law = compared.groupby("law")["metal"].unique().map(set)
    held = set(table().query("set == 'held'")["metal"])
    assert by_law["universal"] == held
    assert by_law["universal"] | by_law[laws_on_spheres.ON_FITTED_METALS] == by_law["thornton"]
    assert not by_law["universal"] & by_law[laws_on_spheres.ON_FITTED_METALS]


def test_errors_of_a_made_up_law_are_found():
    """Two rows in one regime and one in another; 3 and 4 % make 3.54 % together."""
    compared = pd.DataFrame(
        {
            "law": "own",
            "kind": laws_on_spheres.KINDS[0],
            "speed_ratio": [20.0, 50.0, 500.0],
            "coefficient_of_restitution": [0.03, -0.04, 0.01],
            "force_max": [0.0, 0.0, 0.0],
        }
    )
    found = laws_on_spheres.errors(compared)
    first = found[found["quantity"] == "coefficient_of_restitution"].iloc[0]
    assert (first["speed_ratio_from"], first["speed_ratio_to"], first["cases"]) == (10, 100, 2)
    assert first["rms"] == pytest.approx((0.0025 / 2) ** 0.5)
    assert first["max"] == pytest.approx(0.04)


def test_the_papers_sphere_is_as_far_off_as_the_page_says(assert_on_page):
    assert_on_page("paper_sphere", paper_sphere.compare())
