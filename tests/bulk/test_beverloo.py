# SPDX-License-Identifier: GPL-2.0-or-later
"""Beverloo's law of discharge, measured rates, and fits of its constants C and k to known data."""

from __future__ import annotations

from math import pi

import numpy as np
import pandas as pd
import pytest

from plastigran.physics.beverloo import Discharge, discharge_rate, fit_constants, measure_discharge

DIAMETER, DENSITY, GRAVITY = 0.01, 1500.0, 9.81
#: Beverloo's constants C and k of spheres.
SPHERES = 0.58, 1.4
MASS = pi / 6 * DIAMETER**3 * DENSITY


def test_rate_grows_with_the_power_five_halves_of_the_opening():
    """The discharge rate follows Beverloo's law W = 0.58 rho_b sqrt(g) (D0 - 1.4 d)^(5/2).

    rho_b is the bulk density, D0 the orifice diameter, and d the grain diameter. Twice the opening
    D0 - 1.4 d gives 2^2.5 times the rate.
    """
    rate = discharge_rate(0.064, DIAMETER, 900.0, GRAVITY, *SPHERES)
    assert rate == pytest.approx(0.58 * 900 * 9.81**0.5 * 0.05**2.5, rel=1e-12)
    assert discharge_rate(0.114, DIAMETER, 900.0, GRAVITY, *SPHERES) == pytest.approx(2**2.5 * rate)
    with pytest.raises(ValueError, match=r"needs more than 1\.4 grain diameters"):
        discharge_rate(0.013, DIAMETER, 900.0, GRAVITY, *SPHERES)


def course(rate: float, packing: float = 0.6, last: float = 1.5) -> pd.DataFrame:
    """Return a discharge of 1000 grains with a steady part at `rate` [1/s].

    The rate is half as large before the steady part, and decreases after half of the grains.
    """
    time = np.arange(0, last, 0.005)
    start = (2 * 0.08 / GRAVITY) ** 0.5
    out = np.where(time < start, rate / 2 * time, rate * (time - start / 2))
    out = np.where(out > 500, 500 + 500 * (1 - np.exp(-(out - 500) / 500)), out)
    return pd.DataFrame({"time": time, "atoms": 1000.0, "counted": out, "packing": packing})


def test_steady_rate():
    """The rate excludes start and end of the discharge; without scatter, its error is zero."""
    discharge = measure_discharge(course(800.0), 0.08, DIAMETER, DENSITY, GRAVITY, *SPHERES)
    assert discharge.rate == pytest.approx(800 * MASS, rel=1e-9)
    assert discharge.rate_error < 1e-9 * discharge.rate
    assert discharge.bulk_density == pytest.approx(900)


def test_change_of_the_rate_differs_from_scatter():
    """If the rate falls by a tenth halfway, the change exceeds the scatter within both halves."""
    series = course(800.0)
    # The steady part extends from 51 to 500 grains.
    half = series["counted"].between(275, 500)
    series.loc[half, "counted"] = 275 + 0.9 * (series.loc[half, "counted"] - 275)
    discharge = measure_discharge(series, 0.08, DIAMETER, DENSITY, GRAVITY, *SPHERES)
    # The boundary of the halves may be one row away from the change of the rate, which alters the
    # difference by up to 5 %.
    assert discharge.change == pytest.approx(-80 * MASS, rel=0.05)
    assert abs(discharge.change) > 4 * discharge.change_error
    steady = measure_discharge(course(800.0), 0.08, DIAMETER, DENSITY, GRAVITY, *SPHERES)
    assert abs(steady.change) < 1e-9 * steady.rate


def test_scatter_is_in_the_error():
    """The error estimate of the rate agrees with the scatter of 100 random discharges.

    The grains leave independently, so the rate from n grains has the relative error n^(-1/2).
    """
    rng = np.random.default_rng(7)
    ratios = []
    for _ in range(100):
        series = course(800.0)
        steps = rng.poisson(np.diff(series["counted"], prepend=0))
        series["counted"] = np.cumsum(steps)
        discharge = measure_discharge(series, 0.08, DIAMETER, DENSITY, GRAVITY, *SPHERES)
        ratios.append([discharge.rate / MASS / 800 - 1, discharge.rate_error / discharge.rate])
    off, error = np.array(ratios).T
    # The steady part has about 440 grains, so the relative error is 440^(-1/2) = 0.048. The rate is
    # the slope of a fitted line. Its variance is 6/5 times that of a mean over blocks, so its
    # standard deviation is 1.1 times as large. 100 runs give a standard deviation within a tenth.
    assert error.mean() == pytest.approx(440**-0.5, rel=0.2)
    assert off.std() == pytest.approx(1.1 * error.mean(), rel=0.25)


@pytest.mark.parametrize("change", [{"last": 0.5}, {"packing": 0.3}])
def test_no_rate_without_a_steady_part(change):
    """No rate is measured if the run ends early, or if the volume fraction of the bed is too low.

    A run ends early if fewer than half of the grains have flowed out.
    """
    assert (
        measure_discharge(course(800.0, **change), 0.08, DIAMETER, DENSITY, GRAVITY, *SPHERES)
        is None
    )


def discharges(coefficient: float, annulus: float) -> list[Discharge]:
    found = []
    for orifice in (0.05, 0.06, 0.08, 0.1):
        bed = orifice, DIAMETER, 900.0, GRAVITY
        found.append(
            Discharge(*bed, discharge_rate(*bed, coefficient, annulus), *[0.0] * 5, *SPHERES)
        )
    return found


def test_constants_are_recovered():
    fit = fit_constants(discharges(0.5, 1.7))
    assert fit.coefficient == pytest.approx(0.5, rel=1e-6)
    assert fit.empty_annulus == pytest.approx(1.7, rel=1e-6)


def test_constants_need_three_orifices():
    with pytest.raises(ValueError, match="three or more orifice diameters"):
        fit_constants(discharges(0.58, 1.4)[:2])
