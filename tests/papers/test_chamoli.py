# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the vibrating sphere of Chamoli's thesis, with coarse meshes and short flights."""

from __future__ import annotations

from functools import partial

import pytest


@pytest.fixture
def table(coarse_table):
    return partial(coarse_table, "chamoli")


def test_slow_impacts_agree_with_hertz(table):
    impacts = table("impacts")
    slow = impacts[(impacts["E (GPa)"] == 9.3) & (impacts["speed (m/s)"] == 0.1)]
    # Differences are in per cent. A finite sphere is stiffer than in Hertz' theory, by less than 1
    # %. LIGGGHTS uses the recommended time step, with an error of 0.1 %.
    assert slow["finite elements vs Hertz (%)"].abs().max() < 1
    assert impacts["LIGGGHTS vs Hertz (%)"].abs().max() < 0.1
    force = impacts.set_index("quantity").loc["largest force", "finite elements vs Hertz (%)"]
    assert table("deviations")["largest force (%)"].to_numpy() == pytest.approx(force)


def test_faster_and_softer_impacts_leave_more_vibration(table):
    impacts = table("restitution")
    assert impacts["periods in contact"].is_monotonic_decreasing
    assert impacts["vibration energy"].is_monotonic_increasing
    expected = pytest.approx(impacts["vibration energy"], rel=0.01)
    assert (2 * impacts["1 − e, momentum"]).to_numpy() == expected
    assert impacts["1 − e, kinetic energy"].between(impacts["least"], impacts["most"]).all()


def test_energy_is_conserved(table):
    assert table("energies")["energy error"].max() < 1e-6


def test_spectra_contain_the_radial_mode_but_not_the_toroidal_mode(table):
    modes = table("modes").set_index(["kind", "degree", "overtone"])
    assert modes.loc[("radial", 0, 0), "thesis (kHz)"] == pytest.approx(143.67)
    # Differences are in per cent and due to the coarse mesh.
    assert modes["mesh (kHz) vs exact (kHz) (%)"].abs().max() < 0.5
    assert abs(modes.loc[("radial", 0, 0), "peak (kHz) vs exact (kHz) (%)"]) < 0.5
    assert modes.loc[("toroidal", 1, 0), "exact (kHz)"] == pytest.approx(186.49, abs=0.01)
    assert modes.loc[("toroidal", 1, 0), ["mesh (kHz)", "peak (kHz)"]].isna().all()


def test_force_oscillates_at_the_fundamental_frequency(table):
    # Two to ten periods determine a frequency to some per cent.
    difference = table("oscillations")["strongest (kHz) vs fundamental mode (kHz) (%)"]
    assert difference.abs().max() < 5


def test_viscoelastic_sphere_agrees_with_the_closed_form(table):
    # The closed form exceeds the solution of the equation of motion by 1.2 % at v* = 1.
    impacts = table("viscoelastic")
    assert impacts["viscoelastic_hertz vs closed form (%)"].between(-1.4, 0).all()
    assert impacts["LIGGGHTS"].to_numpy() == pytest.approx(impacts["viscoelastic_hertz"], rel=2e-3)
