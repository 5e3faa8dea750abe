# SPDX-License-Identifier: GPL-2.0-or-later
"""Yield strength from a measurement: hardness, reading of a rebound tester, or drops."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable
from functools import partial
from math import inf

import attrs
import numpy as np

from plastigran.calibration.drop_test import DropTest
from plastigran.calibration.hardness import (
    CONSTRAINT_FACTOR,
    INDENTATION_STRAIN,
    SCALES,
    Hardness,
    flow_stress,
    leeb_table,
    steel_yield_strength,
)
from plastigran.calibration.inversion import estimate_strength
from plastigran.contact import Contact, RangeWarning
from plastigran.declared import Declaration, read_number
from plastigran.materials import Material
from plastigran.physics.rebound_hardness import TESTERS, ReboundTester, dented_flat

LEAST_RATIO, LARGEST_RATIO = 1e-6, 0.3  # search range of yield strength / Young's modulus
DENTED_FLAT_NOTE = (
    "the expected errors are for spheres that flatten; for indented flats see "
    "docs/validation_steel.md"
)
DROP_SCATTER = 0.02  # default of the relative standard deviation of one measured restitution
# Relative standard deviation of the restitution from a Leeb reading: 95 % of conversions are
# within 4.5 %.
LEEB_SCATTER = 0.045 / 1.96
TREND_SIGNIFICANCE = 0.01  # significance level for a trend of the deviation with impact speed
LEEB_RANGE = Declaration("rebound hardness", "HL", 100, 1000, True, True)
STEEL = Declaration("Young's modulus of steel", "Pa", 1.9e11, 2.2e11)
# Rate coefficient C of steel 4340 for a yield strength at 1/s: Johnson & Cook, 7th Int. Symp.
# Ballistics 1983.
STEEL_RATE_COEFFICIENT = 0.014


@attrs.frozen
class Strength:
    """Yield strength and its source.

    Attributes:
        value: Yield strength [Pa].
        interval: 95 % confidence interval [Pa].
        source: Method and data, one phrase.
        speed_ratio: Slowest and fastest speed of the measurement / yield speed [-]; None if the
            measurement has no impacts.
        contact: Contact of the measured impacts, with this strength; None without impacts.
        notes: Remarks for the user, one sentence each.
    """

    value: float
    interval: tuple[float, float]
    source: str
    speed_ratio: tuple[float, float] | None = None
    contact: Contact | None = None
    notes: tuple[str, ...] = ()


def from_hardness(hardness: Hardness, plastic_modulus: float, youngs_modulus: float) -> Strength:
    """Return the yield strength for a hardness.

    The strength is the flow stress at 8 % strain minus the hardening up to this strain. The flow
    stress is H/2.8, where H is the mean pressure of the indentation.

    Args:
        hardness: Hardness of the metal.
        plastic_modulus: Plastic modulus, the slope of stress versus plastic strain [Pa].
        youngs_modulus: Young's modulus E [Pa], by which the function recognizes steel.

    Raises:
        ValueError: Hardening alone exceeds the flow stress.
    """
    flow = float(flow_stress(hardness.vickers))
    hardening = INDENTATION_STRAIN * plastic_modulus
    at_strain = f"the flow stress at {INDENTATION_STRAIN:.0%} strain is {flow:.4g} Pa"
    if not hardening < flow:
        raise ValueError(
            f"plastic_modulus is {plastic_modulus:g} Pa; for {hardness} it must be below "
            f"{flow / INDENTATION_STRAIN:.3g} Pa, because {at_strain} and includes the hardening"
        )
    half_width = hardness.scatter * flow
    conversion = SCALES[hardness.scale].source
    converted = f" = {hardness.vickers:.0f} HV ({conversion})" if conversion else ""
    source = (
        f"{hardness}{converted}, flow stress H/{CONSTRAINT_FACTOR} with an error of "
        f"{hardness.scatter:.0%} (reading, conversion, constraint factor 2.6 to 3.0)"
    )
    notes = [at_strain] if hardening else []
    tensile = steel_yield_strength(hardness.vickers)
    is_steel = STEEL.allows(youngs_modulus)
    if is_steel and 0 < tensile < flow:
        notes.append(f"a tensile test of steel of this hardness gives about {tensile:.3g} Pa")
    if conversion and not is_steel:
        notes.append(f"the conversion is for steel ({conversion}); for another metal, measure HV")
    value = flow - hardening
    interval = max(value - half_width, 0.0), value + half_width
    return Strength(value, interval, source, notes=tuple(notes))


def read_leeb(reading: float | str) -> tuple[ReboundTester, float]:
    """Return rebound tester and reading from a number, which is HLD, or a text such as "750HLG".

    Raises:
        ValueError: `reading` is not a valid text or number, or is out of range.
    """
    match = re.fullmatch(r"\s*([-+.\dE]+?)\s*(?:HL([A-Z]*))?\s*", str(reading).upper())
    device = (match and match[2]) or "D"
    if match is None or device not in TESTERS:
        raise ValueError(
            f"leeb is {reading!r}; it must be a number and a device of "
            f"{', '.join('HL' + name for name in TESTERS)}, for example 540HLD"
        )
    return TESTERS[device], read_number("leeb", match[1], LEEB_RANGE)


def from_leeb(leeb: float | str, law: str, metal: Material, scatter: float | None) -> Strength:
    """Return the yield strength at which `law` reproduces the reading of a rebound tester.

    Args:
        leeb: Reading, see `read_leeb`.
        law: Name of the law.
        metal: Material of the sample; the function does not use its strength.
        scatter: Relative standard deviation of the restitution; None for `LEEB_SCATTER`.

    Raises:
        ValueError: As for `read_leeb` and `estimate_strength`.
    """
    tester, reading = read_leeb(leeb)
    scatter = LEEB_SCATTER if scatter is None else scatter

    def contact(sample: Material) -> Contact:
        body = {"radius": tester.ball_radius, "mass_eff": tester.mass}
        return Contact(law, sample, tester.ball, **body, **dented_flat(law))

    rate = (
        f" at a strain rate of 1/s (C = {metal.rate_coefficient:g})"
        if metal.rate_coefficient
        else ""
    )
    source = f"{reading:g} HL{tester.name}, by the law {law}{rate}"
    measured = [tester.restitution(reading)]
    strength = _fit(contact, [tester.speed], measured, metal, scatter, source)
    notes = [*strength.notes, DENTED_FLAT_NOTE]
    table = leeb_table()
    covered = table["HLD"].min() <= reading <= table["HLD"].max()
    if tester.name == "D" and STEEL.allows(metal.youngs_modulus) and covered:
        vickers = float(np.interp(reading, table["HLD"], table["HV"]))
        notes.append(
            f"for steel, testers convert the reading to {vickers:.0f} HV, a flow stress of "
            f"{flow_stress(vickers):.4g} Pa"
        )
    return attrs.evolve(strength, notes=tuple(notes))


def from_drops(drops: DropTest, law: str, metal: Material, scatter: float | None) -> Strength:
    """Return the yield strength at which `law` reproduces the restitutions of a drop test.

    Args:
        drops: Drop test.
        law: Name of the law.
        metal: Material of ball or plate that is calibrated; the function does not use its strength.
        scatter: Relative standard deviation of one restitution; None for `DROP_SCATTER`.

    Raises:
        ValueError: As for `estimate_strength`.

    Warns:
        UserWarning: The measurements scatter much more about the law than stated.
    """
    scatter = DROP_SCATTER if scatter is None else scatter
    count = len(drops.speed)
    source = f"{count} drop{'s' * (count > 1)} of {drops.ball_name} on {drops.plate_name}, "
    source += f"by the law {law}"
    contact = partial(drops.contact, law)
    strength = _fit(contact, drops.speed, drops.restitution, metal, scatter, source)
    if drops.ball is None:
        return strength
    return attrs.evolve(strength, notes=(*strength.notes, DENTED_FLAT_NOTE))


def _fit(
    contact_of: Callable[[Material], Contact],
    speed: np.ndarray,
    measured: np.ndarray,
    metal: Material,
    scatter: float,
    source: str,
) -> Strength:
    """Find the yield strength of `metal` at which its contact reproduces the restitutions."""
    speeds, inverse = np.unique(speed, return_inverse=True)

    def contact(strength: float) -> Contact:
        return contact_of(attrs.evolve(metal, yield_strength=strength))

    def restitution(strength: float) -> np.ndarray:
        return contact(strength).impact(speeds).coefficient_of_restitution[inverse]

    bounds = LEAST_RATIO * metal.youngs_modulus, LARGEST_RATIO * metal.youngs_modulus
    estimate = estimate_strength(restitution, measured, bounds, scatter)
    fitted = contact(estimate.yield_strength)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", RangeWarning)
        fitted.restitution(speeds)
    notes = [str(warning.message) for warning in caught]
    if estimate.residual_scatter > 3 * scatter:
        warnings.warn(
            f"the restitutions scatter by {estimate.residual_scatter:.1%} about the law "
            f"{fitted.law.name}; the stated scatter is {scatter:.1%}. Check the range of the law "
            "and the materials of ball and plate, or raise scatter",
            stacklevel=2,
        )
    if fitted.pair.yield_strength < estimate.yield_strength:
        notes.append(
            f"the other body yields first, at {fitted.pair.yield_strength:.4g} Pa. The strength "
            "is a lower bound"
        )
    elif estimate.interval[1] == inf:
        notes.append(
            "the impacts are nearly elastic: the interval of the yield strength has no upper end"
        )
    notes += _trend(np.log(speed), measured / restitution(estimate.yield_strength), scatter)
    return Strength(
        estimate.yield_strength,
        estimate.interval,
        f"{source}, with an error of {1.96 * scatter:.1%} in restitution",
        (float(speeds[0] / fitted.yield_speed), float(speeds[-1] / fitted.yield_speed)),
        fitted,
        tuple(notes),
    )


def _trend(logarithm: np.ndarray, ratio: np.ndarray, scatter: float) -> list[str]:
    """Return a note if the ratio of measured to predicted restitution has a trend with speed.

    The trend must be significant (p < 0.01) and larger than the scatter of one measurement.
    """
    if len(logarithm) < 4 or np.ptp(logarithm) == 0:
        return []
    from scipy.stats import linregress  # imported here: scipy.stats is slow

    line = linregress(logarithm, np.log(ratio))
    ends = np.array([logarithm.min(), logarithm.max()])
    slow, fast = np.expm1(line.intercept + line.slope * ends)
    if not line.pvalue < TREND_SIGNIFICANCE or abs(fast - slow) < scatter:
        return []
    return [
        f"the deviation from the law depends on speed: {slow:+.1%} at the slowest and "
        f"{fast:+.1%} at the fastest impact (p < 0.01). Try another law or another "
        "rate_coefficient"
    ]
