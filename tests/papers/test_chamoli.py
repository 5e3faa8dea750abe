# SPDX-License-Identifier: GPL-2.0-or-later
"""The thesis on the vibrating sphere, with coarse meshes and short flights."""

from __future__ import annotations

import pytest

from plastigran.papers.chamoli import PAPER


@pytest.fixture(scope="module")
def tables(coarse_table):
    return {name: coarse_table("chamoli", name) for name in (*PAPER.tables, *PAPER.data)}


def test_slow_impact_is_that_of_hertz_in_elements_and_engine(tables):
    table = tables["impacts"]
    slow = table[(table["E (GPa)"] == 9.3) & (table["speed (m/s)"] == 0.1)]
    # In per cent. A sphere of finite size is stiffer; the engine's step is the recommended one.
    assert slow["finite elements vs Hertz (%)"].abs().max() < 1
    assert table["LIGGGHTS vs Hertz (%)"].abs().max() < 0.1
    force = table.loc[table["quantity"] == "largest force", "finite elements vs Hertz (%)"]
    assert tables["deviations"]["largest force (%)"].to_numpy() == pytest.approx(force)


def test_faster_and_softer_impacts_keep_more_vibration(tables):
    table = tables["restitution"]
    assert list(table["periods in contact"]) == sorted(table["periods in contact"])[::-1]
    assert table["vibration energy"].is_monotonic_increasing
    assert (2 * table["1 − e, momentum"]).to_numpy() == pytest.approx(
        table["vibration energy"], rel=0.01
    )
    between = table["1 − e, kinetic energy"].between(table["least"], table["most"])
    assert between.all()


def test_energy_is_conserved(tables):
    assert tables["energies"]["energy error"].max() < 1e-6


def test_radial_mode_is_seen_and_the_toroidal_one_is_not(tables):
    table = tables["modes"].set_index(["kind", "degree", "overtone"])
    assert table.loc[("radial", 0, 0), "thesis (kHz)"] == pytest.approx(143.67)
    # Per cent; a coarse mesh.
    assert table["mesh (kHz) vs exact (kHz) (%)"].abs().max() < 0.5
    assert abs(table.loc[("radial", 0, 0), "peak (kHz) vs exact (kHz) (%)"]) < 0.5
    assert table.loc[("toroidal", 1, 0), "exact (kHz)"] == pytest.approx(186.49, abs=0.01)
    assert table.loc[("toroidal", 1, 0), ["mesh (kHz)", "peak (kHz)"]].isna().all()


def test_force_oscillates_as_the_gravest_mode(tables):
    # Two to ten periods tell a frequency to some per cent.
    off = tables["oscillations"]["strongest (kHz) vs fundamental mode (kHz) (%)"]
    assert off.abs().max() < 5


def test_viscoelastic_sphere_is_that_of_the_closed_form(tables):
    # The closed form lies above the equation of motion by 1.2 % at v* = 1.
    table = tables["viscoelastic"]
    assert table["viscoelastic_hertz vs closed form (%)"].between(-1.4, 0).all()
    assert table["LIGGGHTS"].to_numpy() == pytest.approx(table["viscoelastic_hertz"], rel=2e-3)
