# SPDX-License-Identifier: GPL-2.0-or-later
"""Mean-field theory of a cooling granular gas, compared with closed-form solutions."""

from __future__ import annotations

from math import exp, pi

import numpy as np
import pytest

from plastigran.physics.kinetic_theory import Gas, contact_value, cool, haff

RADIUS = 1e-3


def constant(e: float):
    return lambda speed: np.full_like(speed, e)


def yielding(speed):
    """Return the restitution e of a law with 1 - e^2 = (1 - 1/g^2)/2 for speeds g above 1 m/s.

    The mean of (1 - e^2) g^2/(4T) over the impacts of a gas at temperature T is exp(-1/(4T))/2.
    """
    return np.sqrt(1 - 0.5 * (1 - 1 / np.maximum(speed, 1) ** 2))


@pytest.mark.parametrize("e", [0.0, 0.5, 0.9])
def test_constant_restitution_is_haffs_law(e):
    """With a constant restitution e, the temperature follows Haff's law T0/(1 + t/tau)^2.

    tau = 6/((1 - e^2) omega0), with the initial collision rate omega0. The relative tolerance,
    1e-5, is a hundred times the tolerance of the ODE solver.
    """
    gas, start = Gas(RADIUS, 0.2, constant(e), 1000), 3.0
    rate = float(gas.collision_rate(start))
    times = np.linspace(0, 300, 40) / rate
    course = cool(gas, start, times)
    expected = start / (1 + times * (1 - e**2) * rate / 6) ** 2
    assert course["temperature"].to_numpy() == pytest.approx(expected, rel=1e-5)
    assert haff(start, gas.cooling_rate(start), times) == pytest.approx(expected, rel=1e-6)
    # The rate is proportional to T^(1/2), so the number of impacts is a logarithm.
    tau = 6 / ((1 - e**2) * rate)
    assert course["collisions"].to_numpy() == pytest.approx(
        rate * tau * np.log1p(times / tau), rel=1e-5
    )


def test_elastic_gas_keeps_its_energy():
    gas = Gas(RADIUS, 0.2, constant(1.0), 1000)
    course = cool(gas, 3.0, [0.0, 1.0])
    assert course["temperature"].iloc[-1] == pytest.approx(3.0, rel=1e-12)
    assert course["temperature_error"].iloc[-1] == 0


@pytest.mark.parametrize("temperature", [10.0, 1.0, 0.1, 0.02])
def test_loss_of_a_yielding_gas(temperature):
    """The mean loss of impacts with the restitution of `yielding` is exp(-1/(4T))/2.

    The relative tolerance is 1e-5: the kink at the yield speed lies between two quadrature nodes.
    """
    gas = Gas(RADIUS, 0.1, yielding, 1000)
    assert gas.loss(temperature) == pytest.approx(0.5 * exp(-1 / (4 * temperature)), rel=1e-5)


def test_yielding_gas_stalls():
    """A gas with elastic impacts below the yield speed almost stops cooling.

    The fraction of impacts above the yield speed decreases exponentially. x = 1/(4T) grows at a
    rate of x^(1/2) exp(-x), so x - ln(x)/2 grows as ln t. The tolerance, 2 % of this growth, covers
    the next term of the expansion, 1/x.
    """
    gas = Gas(RADIUS, 0.1, yielding, 1000)
    early, late = 1 / (4 * cool(gas, 10.0, [0.0, 1.0, 1e4])["temperature"].iloc[1:])
    grown = late - early - 0.5 * np.log(late / early)
    assert grown == pytest.approx(np.log(1e4), rel=0.02)


def test_collision_rate_in_the_dilute_limit():
    """In a dilute gas, the collision rate of a grain is its mean speed over its mean free path.

    The mean speed is sqrt(8 T/pi), and the mean free path 1/(sqrt(2) pi d^2 n), with the grain
    diameter d and the number density n.
    """
    phi, temperature = 1e-9, 2.0
    number_density = phi / (4 / 3 * pi * RADIUS**3)
    free_path = 1 / (2**0.5 * pi * (2 * RADIUS) ** 2 * number_density)
    expected = (8 * temperature / pi) ** 0.5 / free_path
    rate = Gas(RADIUS, phi, constant(1.0), 1000).collision_rate(temperature)
    assert rate == pytest.approx(expected, rel=1e-8)


def test_contact_value_has_the_hard_spheres_virial_coefficients():
    """The pair correlation at contact agrees with the virial series 1 + 2.5 phi + 4.5 phi^2.

    phi is the volume fraction. Carnahan and Starling's formula rounds the coefficient 4.5904 of
    hard spheres to 4.5.
    """
    phi = 1e-3
    assert contact_value(phi) == pytest.approx(1 + 2.5 * phi + 4.5 * phi**2, abs=1e-8)


def test_statistical_error_goes_with_the_number_of_grains():
    """Four times as many grains halve the statistical error of the temperature.

    After few impacts, this error is that of a sum of independent energy losses. For e = 0, an
    impact removes m T l of the energy 3/2 N m T of N grains of mass m. The number l is
    exponentially distributed with mean 1, so its mean square is 2. After x impacts per grain, N x/2
    in total, the relative variance is N x/2 · 2 (2/(3N))^2 = 4x/(9N).
    """
    times = np.linspace(0, 1, 5) * 1e-5
    errors = [
        cool(Gas(RADIUS, 0.1, constant(0.0), count), 3.0, times)["temperature_error"].to_numpy()[1:]
        for count in (1000, 4000)
    ]
    assert errors[0] == pytest.approx(2 * errors[1], rel=1e-6)
    gas = Gas(RADIUS, 0.1, constant(0.0), 1000)
    impacts = float(gas.collision_rate(3.0)) * times[1:]
    assert impacts.max() < 0.1
    # The tolerance of 5 % covers cooling, which reduces the effect of the first losses.
    assert errors[0] ** 2 == pytest.approx(impacts / 1000 * 4 / 9, rel=0.05)
