# SPDX-License-Identifier: GPL-2.0-or-later
"""Finite-element computations of spheres that several tests share."""

from __future__ import annotations

import pytest
from coarse_sphere import COARSE, ELASTIC, METAL, RADIUS

from plastigran.fem.sphere.press import press
from plastigran.fem.sphere.throw import throw


@pytest.fixture(scope="session")
def elastic_pressing():
    return press(ELASTIC, RADIUS, [200.0], COARSE)


@pytest.fixture(scope="session")
def plastic_pressing():
    """Compression of a yielding sphere to 500 N and 1500 N, with unloading after each."""
    return press(METAL, RADIUS, [500.0, 1500.0], COARSE)


@pytest.fixture(scope="session")
def elastic_throw():
    return throw(ELASTIC, RADIUS, 0.02, COARSE)


@pytest.fixture(scope="session")
def plastic_throw():
    return throw(METAL, RADIUS, 0.02, COARSE)
