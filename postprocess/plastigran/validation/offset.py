# SPDX-License-Identifier: GPL-2.0-or-later
"""Possible causes of the mean error of a law in rebound hardness tests on steel."""

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

#: Rate coefficient of steel 4340 by Johnson & Cook, and its reference rate [1/s].
RATE = {"rate_coefficient": STEEL_RATE_COEFFICIENT, "reference_rate": 1.0}
# The next constants are further uncertainties of the hardness testers and of steel.
# Mass [kg] and speed [m/s] of device D in makers' tables. ISO 16859 states 5.45 g and 2.05 m/s.
MASS, SPEED = 5.5e-3, 2.00
BALL_MODULI = (600e9, 650e9)
CONSTRAINT_FACTORS = (2.6, 3.0)
CONVERSION_SCATTER = 0.1  # relative scatter of Vickers hardness converted from Leeb hardness
SENSOR_HEIGHT = 1e-3


def budget(law: str) -> pd.DataFrame:
    """Return how much each uncertainty of the tester and the steel changes a law's restitution.

    Returns:
        Table with a row for each uncertainty. The columns are the source of the uncertainty, the
        changed value, the mean change of restitution [%] for the hardnesses of `leeb_table`, and
        the change at the smallest and largest hardness [%]. The source "large a/R" uses the
        hardnesses of `dented_steel.table`.
    """
    usual = rebound(law)
    rows = []
    for source, change, options in _changes():
        effect = 100 * (rebound(law, **options) / usual - 1)
        rows.append((source, change, effect.mean(), effect[0], effect[-1]))
    errors = dented_steel.comparison(law)[f"{law} vs {dented_steel.FINITE_ELEMENTS} (%)"]
    effect = 100 / (1 + errors / 100) - 100
    rows.append(("large a/R", "law → finite elements", effect.mean(), np.nan, effect.iloc[-1]))
    columns = ["source", "change", "mean (%)", "at 80 HV (%)", "at 940 HV (%)"]
    return pd.DataFrame(rows, columns=columns)


def _changes() -> Iterator[tuple[str, str, dict[str, object]]]:
    """Yield the source, the changed value and the arguments for `rebound` of each uncertainty."""
    device, ball = TESTERS["D"], TUNGSTEN_CARBIDE
    yield "strain rate", f"none → C = {RATE['rate_coefficient']:g}", RATE
    for factor in CONSTRAINT_FACTORS:
        change = f"{CONSTRAINT_FACTOR:g} → {factor:g}"
        yield "hardness/flow stress", change, {"strength_factor": CONSTRAINT_FACTOR / factor}
    for scatter in (CONVERSION_SCATTER, -CONVERSION_SCATTER):
        change = f"HV {100 * scatter:+.0f} %"
        yield "scatter of a conversion", change, {"strength_factor": 1 + scatter}
    for modulus in BALL_MODULI:
        change = f"{1e-9 * ball.youngs_modulus:.0f} → {1e-9 * modulus:.0f} GPa"
        tester = attrs.evolve(device, ball=laws.Body(modulus, ball.poissons_ratio))
        yield "modulus of the ball", change, {"tester": tester}
    for source, change, field in (
        ("speed of the body", f"{device.speed:.2f} → {SPEED:.2f} m/s", {"speed": SPEED}),
        ("mass of the body", f"{1e3 * device.mass:.2f} → {1e3 * MASS:.2f} g", {"mass": MASS}),
        (
            "height of the sensor",
            f"0 → {1e3 * SENSOR_HEIGHT:g} mm",
            {"sensor_height": SENSOR_HEIGHT},
        ),
    ):
        yield source, change, {"tester": attrs.evolve(device, **field)}


def with_rate(rebounds: pd.DataFrame, rated: pd.DataFrame) -> pd.DataFrame:
    """Return the mean and rms error of every law [%], without and with strain-rate dependence.

    Args:
        rebounds: Table of `steel.rebounds` without `RATE`.
        rated: Table of `steel.rebounds` with `RATE`.
    """
    usual, moved = (
        (100 * table.set_index("law")["error"]).groupby("law") for table in (rebounds, rated)
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
