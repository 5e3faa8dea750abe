# SPDX-License-Identifier: GPL-2.0-or-later
"""Impacts on steel flats of known hardness: rebound testers, and a sphere of alumina.

The yield strength of a flat is its flow stress, hardness/2.8 (`plastigran.calibration.hardness`).
No constant is fitted to the impacts.
"""

from __future__ import annotations

from math import pi

import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.calibration.hardness import flow_stress, leeb_table
from plastigran.physics.central import yield_speed
from plastigran.physics.rebound_hardness import TESTERS, ReboundTester, dented_flat
from plastigran.validation.laws_on_spheres import yielding_laws
from plastigran.validation.tables import nearest_first, root_mean_square

#: Elastic constants of steel.
YOUNGS_MODULUS, POISSONS_RATIO = 206e9, 0.3
#: Range of the Leeb hardness HLD in which the uncertainty of the restitution is 5 %. For softer
#: steel, the uncertainty is 8 to 10 %.
TRUSTED = (450, 890)
#: Single measurements with other devices: device, Leeb hardness HL, Vickers hardness HV. The sample
#: of device C has 70 HRC, which the table of ASTM E140 does not contain. Its hardness is taken as
#: 1015 to 1080 HV, which gives an uncertainty of 2.5 % in restitution.
SINGLE_READINGS = (("G", 750, 675.0), ("C", 960, 1050.0))
#: Approximate diameters [m] of the craters that device D leaves, by Vickers hardness.
CRATERS = {300.0: 0.54e-3, 800.0: 0.35e-3}
#: Alumina spheres of 3 mm diameter on flats at 10 m/s: restitution by HV, from the abstract of a
#: paper.
ALUMINA = laws.Body(380e9, 0.23)
ALUMINA_DENSITY, ALUMINA_RADIUS, ALUMINA_SPEED = 3900.0, 1.5e-3, 10.0
ALUMINA_RESTITUTION = {300.0: 0.63, 700.0: 0.86}


def steel(strength: float, **others: float) -> laws.Body:
    """Return the steel with a yield strength [Pa]; `others` are further fields of `laws.Body`."""
    return laws.Body(YOUNGS_MODULUS, POISSONS_RATIO, strength, **others)


def speed_ratio(tester: ReboundTester, strength: float) -> float:
    """Return the impact speed / yield speed of a tester on steel with a yield strength [Pa]."""
    pair = tester.pair(steel(strength))
    return tester.speed / yield_speed(pair, tester.ball_radius, tester.mass)


def rebound(
    law: str,
    tester: ReboundTester = TESTERS["D"],
    strength_factor: float = 1.0,
    **steel_constants: float,
) -> np.ndarray:
    """Return the restitution that a law predicts for each hardness of `leeb_table` (59,).

    Args:
        law: Name of the law.
        tester: Rebound hardness tester.
        strength_factor: Factor on the yield strength of the steel.
        steel_constants: Further constants of the steel; see `steel`.
    """
    strengths = strength_factor * flow_stress(leeb_table()["HV"])
    samples = [steel(strength, **steel_constants) for strength in strengths]
    return np.array([tester.reading(law, sample) / 1000 for sample in samples])


def rebounds(**steel_constants: float) -> pd.DataFrame:
    """Compare the restitution of every law with the measured values of `leeb_table` for steel.

    Args:
        steel_constants: Further constants of the steel; see `steel`.

    Returns:
        Table with the columns HV (Vickers hardness), HLD (Leeb hardness), speed_ratio (impact
        speed / yield speed), law, restitution and error (law / measured value - 1).
    """
    table = leeb_table()
    ratios = [speed_ratio(TESTERS["D"], strength) for strength in flow_stress(table["HV"])]
    parts = []
    for law in yielding_laws():
        restitution = rebound(law, **steel_constants)
        part = table.assign(speed_ratio=ratios, law=law, restitution=restitution)
        parts.append(part.assign(error=restitution / (table["HLD"] / 1000) - 1))
    return pd.concat(parts, ignore_index=True)


def summary(rebounds: pd.DataFrame) -> pd.DataFrame:
    """Return the errors of each law in restitution [%]; the law with the smallest rms comes first.

    Args:
        rebounds: Table of `rebounds`.
    """
    rows = []
    for law, part in rebounds.groupby("law"):
        error = 100 * part["error"]
        trusted = error[part["HLD"].between(*TRUSTED)]
        rows.append(
            {
                "law": law,
                "rms, all 59": root_mean_square(error),
                f"rms, {TRUSTED[0]}–{TRUSTED[1]} HLD": root_mean_square(trusted),
                "mean (%)": error.mean(),
                "rms about the mean": error.std(ddof=0),
                "at 80 HV (%)": error.iloc[0],
                "at 940 HV (%)": error.iloc[-1],
            }
        )
    return pd.DataFrame(rows).sort_values("rms, all 59", ignore_index=True).round(2)


def single_impacts() -> pd.DataFrame:
    """Return the errors of every law in the restitution [%] of single impacts.

    The impacts are those of `SINGLE_READINGS` and of `ALUMINA`. The head of a column names the
    impact and the measured restitution. The law with the smallest sum of absolute errors comes
    first.
    """
    cases = [
        (f"Leeb {name}, {hardness:g} HV", reading / 1000, TESTERS[name], hardness)
        for name, reading, hardness in SINGLE_READINGS
    ]
    mass = 4 / 3 * pi * ALUMINA_RADIUS**3 * ALUMINA_DENSITY
    sphere = ReboundTester("alumina", ALUMINA_RADIUS, mass, ALUMINA_SPEED, ALUMINA)
    cases += [
        (f"alumina at 10 m/s, {hardness:g} HV", measured, sphere, hardness)
        for hardness, measured in ALUMINA_RESTITUTION.items()
    ]
    rows = []
    for law in yielding_laws():
        row: dict[str, object] = {"law": law}
        for name, measured, tester, hardness in cases:
            restitution = tester.reading(law, steel(float(flow_stress(hardness)))) / 1000
            row[f"{name}: {measured:g} (%)"] = 100 * (restitution / measured - 1)
        rows.append(row)
    return nearest_first(rows)


def craters() -> pd.DataFrame:
    """Return the largest contact diameter [mm] that every law predicts for device D.

    The head of a column contains the measured diameter of the crater.
    """
    table = pd.DataFrame({"law": yielding_laws()})
    for hardness, measured in CRATERS.items():
        strength = float(flow_stress(hardness))
        diameters = [2e3 * contact_radius(law, strength) for law in table["law"]]
        table[f"{hardness:g} HV: crater of about {1e3 * measured:.2f} mm"] = np.round(diameters, 3)
    return table


def contact_radius(law: str, strength: float) -> float:
    """Return the largest contact radius [m] of device D on steel with a yield strength [Pa]."""
    tester, sample = TESTERS["D"], steel(strength)
    overlap = tester.impact(law, sample).overlap_max
    contact_law = laws.LAWS[law](tester.pair(sample), **dented_flat(law))
    state = contact_law.State()
    return contact_law.respond(tester.ball_radius, overlap, state).contact_radius
