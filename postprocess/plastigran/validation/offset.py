# SPDX-License-Identifier: GPL-2.0-or-later
"""Possible causes of the mean error of a law on the rebound hardness of steel."""

from __future__ import annotations

from collections.abc import Iterator

import attrs
import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.calibration.hardness import CONSTRAINT_FACTOR
from plastigran.calibration.strength import STEEL_RATE_COEFFICIENT
from plastigran.physics.rebound_hardness import TESTERS, TUNGSTEN_CARBIDE
from plastigran.validation import dented_steel
from plastigran.validation.steel import rebound
from plastigran.validation.tables import root_mean_square

#: Constants of steel 4340 by Johnson & Cook, with the reference rate [1/s].
RATE = {"rate_coefficient": STEEL_RATE_COEFFICIENT, "reference_rate": 1.0}
#: Further uncertainties of the testers and of steel.
MASS, SPEED = 5.5e-3, 2.00  # from makers' tables; ISO 16859 has 5.45 g and 2.05 m/s
BALL_MODULI = (600e9, 650e9)
CONSTRAINT_FACTORS = (2.6, 3.0)
CONVERSION_SCATTER = 0.1  # relative, in HV
SENSOR_HEIGHT = 1e-3


def budget(law: str) -> pd.DataFrame:
    """Return the change of a law's restitution [%] for each uncertainty.

    Args:
        law: Name of the law.

    Returns:
        A row for each uncertainty: source, change (from value to value), mean change of restitution
        over the hardnesses of `leeb_table`, and the change at the softest and the hardest. For the
        large a/R, the hardnesses are those of `dented_steel.table`.
    """
    usual = rebound(law)
    rows = []
    for source, change, changed in _changes(law, usual):
        off = 100 * (changed / usual - 1)
        rows.append(
            {
                "source": source,
                "change": change,
                "mean (%)": off.mean(),
                "at 80 HV (%)": off[0],
                "at 940 HV (%)": off[-1],
            }
        )
    dent = 100 / (1 + dented_steel.comparison(law).iloc[:, -1] / 100) - 100
    rows.append(
        {
            "source": "large a/R",
            "change": "law → finite elements",
            "mean (%)": dent.mean(),
            "at 80 HV (%)": np.nan,
            "at 940 HV (%)": dent.iloc[-1],
        }
    )
    return pd.DataFrame(rows)


def _changes(law: str, usual: np.ndarray) -> Iterator[tuple[str, str, np.ndarray]]:
    device = TESTERS["D"]
    yield (
        "strain rate",
        f"none → C = {RATE['rate_coefficient']:g}",
        rebound(law, **RATE),
    )
    for factor in CONSTRAINT_FACTORS:
        yield (
            "hardness/flow stress",
            f"{CONSTRAINT_FACTOR:g} → {factor:g}",
            rebound(law, strength_factor=CONSTRAINT_FACTOR / factor),
        )
    for sign in (1, -1):
        yield (
            "scatter of a conversion",
            f"HV {100 * sign * CONVERSION_SCATTER:+.0f} %",
            rebound(law, strength_factor=1 + sign * CONVERSION_SCATTER),
        )
    ball = TUNGSTEN_CARBIDE.youngs_modulus
    for modulus in BALL_MODULI:
        tester = attrs.evolve(device, ball=laws.Body(modulus, TUNGSTEN_CARBIDE.poissons_ratio))
        yield (
            "modulus of the ball",
            f"{1e-9 * ball:.0f} → {1e-9 * modulus:.0f} GPa",
            rebound(law, tester),
        )
    yield (
        "speed of the body",
        f"{device.speed:.2f} → {SPEED:.2f} m/s",
        rebound(law, attrs.evolve(device, speed=SPEED)),
    )
    yield (
        "mass of the body",
        f"{1e3 * device.mass:.2f} → {1e3 * MASS:.2f} g",
        rebound(law, attrs.evolve(device, mass=MASS)),
    )
    yield (
        "height of the sensor",
        f"0 → {1e3 * SENSOR_HEIGHT:g} mm",
        rebound(law, attrs.evolve(device, sensor_height=SENSOR_HEIGHT)),
    )


def with_rate(rebounds: pd.DataFrame, rated: pd.DataFrame) -> pd.DataFrame:
    """Return the mean and rms error of every law [%], without and with the strain rate.

    Args:
        rebounds, rated: As of `plastigran.validation.steel.rebounds`, the second with `RATE`.
    """
    usual, moved = (
        (100 * found.set_index("law")["error"]).groupby("law") for found in (rebounds, rated)
    )
    table = pd.DataFrame(
        {
            "mean (%)": usual.mean(),
            "mean with rate (%)": moved.mean(),
            "rms": usual.agg(root_mean_square),
            "rms with rate": moved.agg(root_mean_square),
        }
    )
    return table.sort_values("rms with rate").rename_axis("law").reset_index().round(2)
