# SPDX-License-Identifier: GPL-2.0-or-later
"""Rebound hardness of steel by finite elements: the elastic ball of Leeb device D on a half space.

    python -m plastigran.validation.dented_steel

This command computes the impacts that are not in the cache, and writes the table
`plastigran/data/finite_elements_leeb.csv`. The steel is perfectly plastic, with the yield strength
hardness/2.8. The computation assumes small strain, which is accurate up to a contact radius of 0.1
ball radii; some impacts exceed this value.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import partial
from importlib.resources import files
from math import pi, sqrt
from pathlib import Path

import numpy as np
import pandas as pd

import plastigran
from plastigran.calibration.expected_errors import KINDS
from plastigran.calibration.hardness import flow_stress, indentation_pressure, leeb_table
from plastigran.fem.cache import cached
from plastigran.fem.limits import SmallStrainWarning
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.press import press
from plastigran.fem.sphere.results import Pressing
from plastigran.physics.rebound_hardness import TESTERS, ReboundTester
from plastigran.report.computing import compute_all
from plastigran.validation.spheres import contact_kinds
from plastigran.validation.spheres import table as spheres
from plastigran.validation.steel import POISSONS_RATIO, YOUNGS_MODULUS, speed_ratio, steel

FINITE_ELEMENTS = "finite elements"
TABLE = "finite_elements_leeb.csv"
#: Hardnesses of the table, HV. For softer steel, a/R exceeds 0.2, and the computation in small
#: strain does not converge.
HARDNESSES = (211, 304, 550, 940)
#: Forces from which the ball is unloaded, divided by an estimate of the impact force. The estimate
#: holds for a rigid ball and a constant pressure H. The results for the impact are interpolated
#: between these unloadings.
SHARES = (0.65, 0.85, 1.1)
#: Settings of the finite elements. At 550 HV, a finer mesh gives a restitution 0.4 % higher.
SETTINGS = Settings(divisions=4, fineness=0.7, growth=1.08, unloading_steps=10)


def table() -> pd.DataFrame:
    """Read the table of computed impacts from the data files of the package.

    Returns:
        Table with the columns HV (Vickers hardness), HLD (Leeb hardness), speed_ratio (impact
        speed / yield speed), restitution, force_max [N] and contact_radius_over_radius.
    """
    with (files("plastigran") / "data" / TABLE).open() as file:
        return pd.read_csv(file)


def computation(hardness: float) -> Callable[[], Pressing]:
    """Return a function that computes the compression of the ball on steel of a hardness [HV]."""
    tester, strength = TESTERS["D"], float(flow_stress(hardness))
    ball = ElasticPlastic(
        youngs_modulus=tester.ball.youngs_modulus, poissons_ratio=tester.ball.poissons_ratio
    )
    plane = ElasticPlastic(
        youngs_modulus=YOUNGS_MODULUS,
        poissons_ratio=POISSONS_RATIO,
        hardening=LinearHardening(strength),
    )
    # `guess` is an estimate of the impact force, for a rigid ball and a constant pressure H: with
    # the force F = pi a^2 H at the depth a^2/2R, the work F^2/(4 pi R H) equals the impact energy.
    pressure = float(indentation_pressure(hardness))
    guess = 2 * sqrt(pi * tester.ball_radius * pressure * _energy(tester))
    forces = tuple(share * guess for share in SHARES)
    return partial(cached, press, ball, tester.ball_radius, forces, settings=SETTINGS, plane=plane)


def row(hardness: float, pressing: Pressing) -> dict[str, float]:
    """Return the results for the impact of device D, interpolated between the unloadings.

    Args:
        hardness: Vickers hardness of the steel [HV].
        pressing: Compression of the ball on this steel.

    Returns:
        Values of one row, by the column names of `table`.
    """
    tester, unloadings = TESTERS["D"], pressing.unloadings
    work = np.log(unloadings["work_loading"] / _energy(tester))

    def at_impact(name: str) -> float:
        coefficients = np.polyfit(work, np.log(unloadings[name]), len(work) - 1)
        return float(np.exp(coefficients[-1]))

    return {
        "HV": hardness,
        "HLD": leeb_table().set_index("HV")["HLD"][hardness],
        "speed_ratio": speed_ratio(tester, float(flow_stress(hardness))),
        "restitution": at_impact("coefficient_of_restitution"),
        "force_max": at_impact("force"),
        "contact_radius_over_radius": at_impact("contact_radius") / tester.ball_radius,
    }


def comparison(law: str) -> pd.DataFrame:
    """Compare restitutions by finite elements with measured values, values at small a/R, and a law.

    Args:
        law: Name of the law.

    Returns:
        Table with a row for each hardness of `table`; the differences are in per cent.
    """
    impacts = table()
    measured, computed = impacts["HLD"] / 1000, impacts["restitution"]
    at_small_radius = small_radius_restitution(impacts["speed_ratio"].to_numpy())
    samples = [steel(float(strength)) for strength in flow_stress(impacts["HV"])]
    by_law = np.array([TESTERS["D"].reading(law, sample) / 1000 for sample in samples])
    return pd.DataFrame(
        {
            "HV": impacts["HV"],
            "v/v_Y": impacts["speed_ratio"],
            "a/R": impacts["contact_radius_over_radius"],
            "measured": measured,
            FINITE_ELEMENTS: computed,
            f"{FINITE_ELEMENTS} vs measured (%)": 100 * (computed / measured - 1),
            f"{FINITE_ELEMENTS} vs small a/R (%)": 100 * (computed / at_small_radius - 1),
            f"{law} vs {FINITE_ELEMENTS} (%)": 100 * (by_law / computed - 1),
        }
    )


def small_radius_restitution(ratios: np.ndarray) -> np.ndarray:
    """Return the restitution of perfectly plastic spheres at small a/R.

    Args:
        ratios: Impact speeds / yield speed.

    The values are interpolated in the finite-element table of spheres, for the metal with the
    lowest sigma_Y/E*. Its a/R is below 0.025. Beyond the highest speed of this metal, a power law
    is extrapolated from its fastest impacts.
    """
    rows = spheres()
    rows = rows[contact_kinds(rows) == KINDS[0]].sort_values("speed_ratio")
    rows = rows[rows["yield_strength_ratio"] == rows["yield_strength_ratio"].min()]
    speed, restitution = np.log(rows[["speed_ratio", "coefficient_of_restitution"]].to_numpy().T)
    fast = speed > speed[-1] - 1
    beyond = np.polyval(np.polyfit(speed[fast], restitution[fast], 1), np.log(ratios))
    within = np.interp(np.log(ratios), speed, restitution)
    return np.exp(np.where(np.log(ratios) > speed[-1], beyond, within))


def _energy(tester: ReboundTester) -> float:
    return tester.mass * tester.speed**2 / 2


if __name__ == "__main__":
    warnings.simplefilter("ignore", SmallStrainWarning)
    results = compute_all({hardness: computation(hardness) for hardness in HARDNESSES}, True)
    rows = pd.DataFrame([row(hardness, results[hardness]) for hardness in sorted(HARDNESSES)])
    rows.round(5).to_csv(Path(plastigran.__file__).parent / "data" / TABLE, index=False)
    print(rows.to_string())
