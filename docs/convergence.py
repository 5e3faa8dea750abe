#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Print the convergence tables of docs/finite_elements.md.

    .venv/bin/python docs/convergence.py

The press takes about three minutes on one core, the throw about six.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import pandas as pd

from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.convergence import (
    PRESS_VARIATIONS,
    THROW_VARIATIONS,
    convergence,
    press_measure,
    throw_measure,
)

#: The sphere of Zhang & Vu-Quoc 2002 (Int. J. Impact Eng. 27:317), pressed and thrown [m, N, m/s].
METAL = ElasticPlastic(
    youngs_modulus=70e9, poissons_ratio=0.3, density=2699.0, hardening=LinearHardening(100e6)
)
RADIUS, FORCE, SPEED = 0.1, 1500.0, 0.02

Variations = Mapping[str, Sequence[float]]


def tables(
    press: Variations = PRESS_VARIATIONS,
    throw: Variations = THROW_VARIATIONS,
    settings: Settings | None = None,
) -> dict[str, pd.DataFrame]:
    """What each setting changes, by name of the computation; see `convergence`."""
    return {
        "press": convergence(press_measure(METAL, RADIUS, [FORCE]), press, settings),
        "throw": convergence(throw_measure(METAL, RADIUS, SPEED), throw, settings),
    }


if __name__ == "__main__":
    for name, table in tables().items():
        print(f"{name}\n{table.to_string(index=False, float_format='{:.4g}'.format)}\n")
