# SPDX-License-Identifier: GPL-2.0-or-later
"""The tables of the validation pages and of the package equal the tables that the code computes."""

from __future__ import annotations

import re
from itertools import product

import pandas as pd
import pytest

from plastigran.calibration.expected_errors import KINDS
from plastigran.engine.process import PROJECT
from plastigran.validation import (
    choice,
    dented_steel,
    laws_on_spheres,
    oblique,
    offset,
    paper_sphere,
    rod,
    steel,
)
from plastigran.validation.oblique import PARTIAL_SLIP, SPRING
from plastigran.validation.report import ERRORS, FEW_ANGLES
from plastigran.validation.spheres import table
from plastigran.validation.spheres.fit import bands, fit


def test_the_errors_of_the_package_and_the_pages_are_those_of_the_laws(assert_on_page):
    compared = laws_on_spheres.compare()
    stored = pd.read_csv(ERRORS)
    unfitted = laws_on_spheres.without_fitted_metals(compared)
    computed = laws_on_spheres.errors(unfitted)
    keys = ["law", "kind", "speed_ratio_from", "speed_ratio_to", "quantity", "cases"]
    assert stored[keys].to_numpy().tolist() == computed[keys].to_numpy().tolist()
    for size in ("rms", "max"):  # 1e-6 allows for round-off of libraries
        expected = pytest.approx(computed[size].to_numpy(), rel=1e-3, abs=1e-6)
        assert stored[size].to_numpy() == expected
    rebounds, rated = steel.rebounds(), steel.rebounds(**offset.RATE)
    regimes = choice.by_regime(unfitted, rebounds, rated)
    best = regimes.loc[regimes["quantity"] == "force", "best"]  # in docs/choose_a_law.md
    assert best.str.startswith("`universal`").all()
    for word in ("restitution", "force"):
        assert_on_page(word, choice.by_law(compared, rebounds, word))
    page = (PROJECT / "docs" / "validation_steel.md").read_text()
    for law, error in offset.with_rate(rebounds, rated).set_index("law")["rms with rate"].items():
        for shown in re.findall(rf"^\| `{law}` \| .* \| (\S+) \|$", page, re.MULTILINE):
            assert float(shown) == pytest.approx(error, abs=0.011)
    assert_on_page("leeb", steel.summary(rebounds))


def test_the_page_of_universal_shows_its_largest_errors():
    """docs/laws/universal.md shows the largest errors of the law that the code computes.

    The page lists them by kind of contact and speed, for metals of the fit and held-out metals.
    """
    page = (PROJECT / "docs" / "laws" / "universal.md").read_text()
    names = ("perfectly plastic, small a/R", "hardening, small a/R", "large a/R")
    kinds = dict(zip(names, KINDS, strict=True))
    largest, contact = bands(fit(table()), table()), ""
    rows = re.findall(r"^\|(.*)\| (\d+ to \d+) \|(.*)\|(.*)\|(.*)\|(.*)\|$", page, re.MULTILINE)
    assert len(rows) == len(kinds) * len(largest.index.unique("regime"))
    for name, regime, *cells in rows:
        contact = kinds.get(name.strip(), contact)
        for cell, (quantity, metals) in zip(
            cells, product(("force", "restitution"), ("fit", "held")), strict=True
        ):
            if (metals, regime, contact) in largest.index:
                error = largest.loc[(metals, regime, contact), quantity]
                assert float(cell) == pytest.approx(error, abs=0.011)
            else:
                assert not cell.strip()


def test_finite_elements_of_steel_are_those_of_the_page(page_table, assert_on_page):
    nearest = page_table("leeb")["law"][0]
    assert_on_page("leeb_finite_elements", dented_steel.comparison(nearest))


def test_errors_for_the_sphere_of_the_paper_are_those_of_the_page(assert_on_page):
    assert_on_page("paper_sphere", paper_sphere.compare())


def test_single_impacts_are_as_the_page_says():
    errors = steel.single_impacts().set_index("law").abs()
    assert errors.loc["universal"].max() == pytest.approx(3.3, abs=0.05)
    assert [errors.loc["thornton"].min(), errors.loc["thornton"].max()] == pytest.approx(
        [13, 32], abs=0.5
    )


def test_the_crater_of_universal_is_as_large_as_measured():
    craters = steel.craters().set_index("law").loc["universal"]
    assert list(craters) == pytest.approx([0.54, 0.35], rel=0.3)  # rough measurements


def test_causes_of_the_mean_error_are_those_of_the_page(page_table, monkeypatch):
    nearest = page_table("leeb")["law"][0]
    table = steel.leeb_table().iloc[[0, -1]]
    monkeypatch.setattr(steel, "leeb_table", lambda: table)
    parts, shown = offset.budget(nearest), page_table("leeb_offset")
    assert list(parts["source"]) == list(shown["source"])
    for column in ("at 80 HV (%)", "at 940 HV (%)"):
        expected = pytest.approx(pd.to_numeric(shown[column]).to_numpy(), abs=0.011, nan_ok=True)
        assert parts[column].to_numpy() == expected


@pytest.mark.engine
def test_theories_of_oblique_impacts_are_those_of_the_page(page_table):
    computed = oblique.computed(FEW_ANGLES)
    keys = ["quantity", "computed by"]
    errors, shown = oblique.summary(computed).set_index(keys), page_table("oblique").set_index(keys)
    theory = [key for key in errors.index if key[1] in (PARTIAL_SLIP, SPRING)]
    assert len(theory) == 2 * len(oblique.QUANTITIES)
    for column in ("largest difference", "rms"):
        numbers = pd.to_numeric(shown.loc[theory, column])
        # The page has three digits, so the relative tolerance is 0.01.
        assert errors.loc[theory, column].to_numpy() == pytest.approx(numbers, rel=0.01)


def test_errors_for_the_rod_are_those_of_the_page(page_table, assert_on_page):
    law = page_table("rod")["law"][0]
    assert_on_page("rod", rod.summary(rod.impacts([law])))
    assert_on_page("rod_tangential", rod.tangential_models())
