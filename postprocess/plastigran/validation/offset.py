# SPDX-License-Identifier: GPL-2.0-or-later
"""What the offset between a law and the rebound hardness of steel is made of."""

from __future__ import annotations

from collections.abc import Iterator

import attrs
import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.calibration.hardness import CONSTRAINT_FACTOR, flow_stress, leeb_table
from plastigran.physics.rebound_hardness import TESTERS, TUNGSTEN_CARBIDE
from plastigran.validation.laws_on_spheres import WIDE
from plastigran.validation.spheres import table
from plastigran.validation.steel import contact_radius, rebound
from plastigran.validation.tables import root_mean_square

#: Johnson & Cook's C for 4340 steel, and its rate [1/s]: 7th Int. Symp. Ballistics, The Hague 1983,
#: p. 541.
RATE_COEFFICIENT, REFERENCE_RATE = 0.014, 1.0
#: What else is not known of the testers and of steel.
MASS, SPEED = 5.5e-3, 2.00  # makers' tables; ISO 16859 has 5.45 g, and 2.05 m/s
BALL_MODULI = (600e9, 650e9)
CONSTRAINT_FACTORS = (2.6, 3.0)
CONVERSION_SCATTER = 0.1  # of HV
SENSOR_HEIGHT = 1e-3


def budget(law: str) -> pd.DataFrame:
    """What each unknown changes a law's restitution by [%].

    Args:
        law: Its name.

    Returns:
        A row for each: source, change (from what to what), and the change of restitution: its mean
        over the hardnesses of `leeb_table`, and at the softest and the hardest.
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
    return pd.DataFrame(rows)


def _changes(law: str, usual: np.ndarray) -> Iterator[tuple[str, str, np.ndarray]]:
    device = TESTERS["D"]
    yield (
        "rate of strain",
        f"none → C = {RATE_COEFFICIENT:g}",
        rebound_with_rate(law),
    )
    for factor in CONSTRAINT_FACTORS:
        yield (
            "hardness over flow stress",
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
    reach = np.array([contact_radius(law, each) for each in flow_stress(leeb_table()["HV"])])
    reach /= device.ball_radius
    yield (
        "wide contact",
        f"0 → {reach[-1]:.2f} to {reach[0]:.2f} a/R",
        usual * (1 + width_slope() * reach),
    )


def rebound_with_rate(law: str) -> np.ndarray:
    """Restitution as of `rebound` with the rate of strain's share of the strength."""
    return rebound(law, rate_coefficient=RATE_COEFFICIENT, reference_rate=REFERENCE_RATE)


def width_slope() -> float:
    """Relative change of restitution per a/R [-], at one v/v_Y, by the table of spheres.

    Perfectly plastic metals with a/R above `WIDE`, against those below half of it.
    """
    rows = table()
    rows = rows[rows["hardening_ratio"] == 0]
    reach = rows["contact_radius_over_radius"]
    narrow = rows[reach < WIDE / 2].sort_values("speed_ratio")
    wide = rows[(reach >= WIDE) & (rows["speed_ratio"] <= narrow["speed_ratio"].max())]
    expected = np.interp(
        np.log(wide["speed_ratio"]),
        np.log(narrow["speed_ratio"]),
        narrow["coefficient_of_restitution"],
    )
    off = wide["coefficient_of_restitution"] / expected - 1
    reach = wide["contact_radius_over_radius"]
    return float(off @ reach / (reach @ reach))


def with_rate(rebounds: pd.DataFrame) -> pd.DataFrame:
    """Every law's mean error and its root of the mean square [%], without and with the rate.

    Args:
        rebounds: As of `plastigran.validation.steel.rebounds`.
    """
    rows = []
    for law, part in rebounds.groupby("law"):
        error = 100 * part["error"].to_numpy()
        rated = 100 * (rebound_with_rate(law) / (part["HLD"].to_numpy() / 1000) - 1)
        rows.append(
            {
                "law": law,
                "mean (%)": error.mean(),
                "mean with rate (%)": rated.mean(),
                "rms": root_mean_square(error),
                "rms with rate": root_mean_square(rated),
            }
        )
    return pd.DataFrame(rows).sort_values("rms with rate", ignore_index=True).round(2)
