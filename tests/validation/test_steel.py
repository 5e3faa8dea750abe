# SPDX-License-Identifier: GPL-2.0-or-later
"""Laws on steel of known hardness: nothing is fitted, and each part of the offset has its sign."""

from __future__ import annotations

import pandas as pd
import pytest

from plastigran.validation import dented_steel, offset, steel


def test_single_impacts_and_craters_are_as_the_page_says(assert_on_page):
    assert_on_page("single_impacts", steel.single_impacts())
    assert_on_page("craters", steel.craters())


def test_the_nearest_law_has_the_slope_of_the_table_and_its_level_with_the_rate(page_table):
    """The table is trusted to 5 % in restitution, its slope to the 4 % in HV, 1.7 % in restitution,
    that other points of makers lie off it."""
    assert float(page_table("leeb")["rms about the mean"][0]) < 1.7
    assert float(page_table("leeb_rate")["rms with rate"][0]) < 5


def test_parts_of_the_offset_have_the_sign_of_their_cause(page_table):
    """Stronger steel gives more back; a weaker ball yields more to the same energy."""
    parts = page_table("leeb_offset").set_index(["source", "change"])["mean (%)"].astype(float)
    assert parts["strain rate"].item() > 2
    assert parts["hardness/flow stress", "2.8 → 2.6"] > 0
    assert parts["hardness/flow stress", "2.8 → 3"] < 0
    assert (
        parts["scatter of a conversion", "HV +10 %"]
        > 0
        > parts["scatter of a conversion", "HV -10 %"]
    )
    assert parts["modulus of the ball", "625 → 600 GPa"] > 0
    assert parts["modulus of the ball", "625 → 650 GPa"] < 0
    assert parts["speed of the body"].item() > 0  # slower
    assert parts["mass of the body"].item() < 0  # heavier
    assert parts["height of the sensor"].item() < 0  # gravity takes speed twice


def test_parts_of_the_offset_are_those_of_the_page(page_table, monkeypatch):
    nearest = page_table("leeb")["law"][0]
    table = steel.leeb_table().iloc[[0, -1]]
    monkeypatch.setattr(steel, "leeb_table", lambda: table)
    found, shown = offset.budget(nearest), page_table("leeb_offset")
    assert list(found["source"]) == list(shown["source"])
    for column in ("at 80 HV (%)", "at 940 HV (%)"):
        said = pd.to_numeric(shown[column])
        assert found[column].to_numpy() == pytest.approx(said.to_numpy(), abs=0.011, nan_ok=True)


def test_finite_elements_of_the_dent_are_within_the_scatter_of_the_table(
    page_table, assert_on_page
):
    """5 % in restitution, as the table is trusted; nothing of a law is in them."""
    found = dented_steel.comparison(page_table("leeb")["law"][0])
    assert found["finite elements vs measured (%)"].abs().max() < 5
    assert_on_page("leeb_finite_elements", found)


def test_the_rate_of_strain_moves_every_law_up(page_table):
    rate = page_table("leeb_rate")
    gained = pd.to_numeric(rate["mean with rate (%)"]) - pd.to_numeric(rate["mean (%)"])
    assert (gained > 0).all()
