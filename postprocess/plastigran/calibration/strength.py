# SPDX-License-Identifier: GPL-2.0-or-later
"""Yield strength from a measurement: hardness, reading of a rebound tester, or drops."""

from __future__ import annotations

import re
import warnings
from math import inf

import attrs
import numpy as np
from scipy.stats import linregress

from plastigran import laws
from plastigran.calibration.drop_test import DropTest
from plastigran.calibration.hardness import (
    CONSTRAINT_FACTOR,
    DENT_STRAIN,
    SCALES,
    Hardness,
    leeb_table,
    steel_yield_strength,
)
from plastigran.calibration.inversion import estimate_strength
from plastigran.contact import Contact, RangeWarning
from plastigran.declared import Declaration, read_number
from plastigran.materials import Material
from plastigran.physics.central import yield_speed
from plastigran.physics.rebound_hardness import TESTERS, ReboundTester, dented_flat

LEAST_RATIO, LARGEST_RATIO = 1e-6, 0.3  # search range of yield strength / Young's modulus
DENTS = (
    "the expected errors are for spheres that flatten; for indented flats see "
    "docs/validation_steel.md"
)
DROP_SCATTER = 0.02  # default standard deviation of one restitution
# relative standard deviation of a Leeb restitution; conversions are within 4.5 % (95 %)
LEEB_SCATTER = 0.045 / 1.96
CHANCE = 0.01  # significance level of a trend with speed
LEEB_RANGE = Declaration("rebound hardness", "HL", 100, 1000, True, True)
STEEL = Declaration("Young's modulus of steel", "Pa", 1.9e11, 2.2e11)
STEEL_RATE_COEFFICIENT = 0.014  # for 4340 at 1/s: Johnson & Cook, 7th Int. Symp. Ballistics 1983


@attrs.frozen
class Strength:
    """Yield strength and its source.

    Attributes:
        value: Yield strength [Pa].
        interval: 95 % confidence interval [Pa].
        source: Method and data, one phrase.
        speed_ratio: Speeds of the measurement / yield speed [-]; None without impacts.
        contact: Contact of the measurement, with that strength; None without one.
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

    It is the flow stress H/2.8 at 8 % strain minus the hardening up to that strain.

    Args:
        hardness: Hardness of the metal.
        plastic_modulus: H_p, stress over plastic strain [Pa].
        youngs_modulus: E [Pa], which identifies steel.

    Raises:
        ValueError: Hardening alone exceeds the flow stress.
    """
    flow = float(hardness.flow_stress)
    added = DENT_STRAIN * plastic_modulus
    if not added < flow:
        raise ValueError(
            f"plastic_modulus is {plastic_modulus:g} Pa; for {hardness} it must be below "
            f"{flow / DENT_STRAIN:.3g} Pa. The flow stress at {DENT_STRAIN:.0%} strain is "
            f"{flow:.4g} Pa, and hardening alone would exceed it"
        )
    half = hardness.scatter * flow
    scale = SCALES[hardness.scale]
    converted = "" if scale.name == "HV" else f" = {hardness.vickers:.0f} HV ({scale.source})"
    source = (
        f"{hardness}{converted}, flow stress H/{CONSTRAINT_FACTOR} within {hardness.scatter:.0%} "
        "(reading, conversion, constraint factor 2.6 to 3.0)"
    )
    notes = [f"the flow stress at {DENT_STRAIN:.0%} strain is {flow:.4g} Pa"] if added else []
    tensile = steel_yield_strength(hardness.vickers)
    if STEEL.allows(youngs_modulus) and 0 < tensile < flow:
        notes.append(f"a tensile test of steel of this hardness gives about {tensile:.3g} Pa")
    if scale.of_steel and not STEEL.allows(youngs_modulus):
        notes.append(f"the conversion is for steel ({scale.source}); for another metal, measure HV")
    value = flow - added
    return Strength(value, (max(value - half, 0.0), value + half), source, notes=tuple(notes))


def read_leeb(given: float | str) -> tuple[ReboundTester, float]:
    """Return device and reading from a number, which is HLD, or a text such as "750HLG".

    Raises:
        ValueError: The value is neither, or out of range.
    """
    found = re.fullmatch(r"\s*([-+.\dE]+?)\s*(?:HL([A-Z]*))?\s*", str(given).upper())
    device = (found and found[2]) or "D"
    if found is None or device not in TESTERS:
        raise ValueError(
            f"leeb is {given!r}; it must be a number and a device of "
            f"{', '.join('HL' + name for name in TESTERS)}, for example 540HLD"
        )
    return TESTERS[device], read_number("leeb", found[1], LEEB_RANGE)


def from_leeb(given: float | str, law: str, metal: Material, scatter: float | None) -> Strength:
    """Return the yield strength at which `law` reproduces the reading of a rebound tester.

    Args:
        given: Reading, see `read_leeb`.
        law: Name of the law.
        metal: Material of the sample; its strength is not used.
        scatter: Relative standard deviation of the restitution; None for that of conversions.

    Raises:
        ValueError: As of `read_leeb` and `estimate_strength`.
    """
    tester, reading = read_leeb(given)
    scatter = LEEB_SCATTER if scatter is None else scatter

    def contact(strength: float) -> Contact:
        sample = attrs.evolve(metal, yield_strength=strength)
        return Contact(
            law,
            sample,
            tester.ball,
            radius=tester.ball_radius,
            mass_eff=tester.mass,
            **dented_flat(law),
        )

    rate = f" at 1/s (C = {metal.rate_coefficient:g})" if metal.rate_coefficient else ""
    source = (
        f"{reading:g} HL{tester.name}, from the law {law}{rate}, "
        f"restitution within {1.96 * scatter:.1%}"
    )
    measured = np.array([tester.restitution(reading)])
    found = _inverted(contact, np.array([tester.speed]), measured, metal, scatter, source)
    found = attrs.evolve(found, notes=(*found.notes, DENTS))
    if tester.name == "D" and STEEL.allows(metal.youngs_modulus):
        table = leeb_table()
        if table["HLD"].min() <= reading <= table["HLD"].max():
            hardness = Hardness(float(np.interp(reading, table["HLD"], table["HV"])))
            said = (
                f"for steel, testers convert the reading to {hardness.vickers:.0f} HV, "
                "a flow stress of "
            )
            notes = (*found.notes, f"{said}{hardness.flow_stress:.4g} Pa")
            found = attrs.evolve(found, notes=notes)
    return found


def from_drops(drops: DropTest, law: str, metal: Material, scatter: float | None) -> Strength:
    """Return the yield strength at which `law` reproduces the restitutions of a drop test.

    Args:
        drops: Drop test.
        law: Name of the law.
        metal: Material of ball or plate; its strength is not used.
        scatter: Relative standard deviation of one restitution; None for `DROP_SCATTER`.

    Raises:
        ValueError: As of `estimate_strength`.

    Warns:
        UserWarning: The measurements scatter much more about the law than stated.
    """
    scatter = DROP_SCATTER if scatter is None else scatter

    def contact(strength: float) -> Contact:
        return drops.contact(law, attrs.evolve(metal, yield_strength=strength))

    count = len(drops.speed)
    source = (
        f"{count} drop{'s' * (count > 1)} of {drops.ball_said} on {drops.plate_said}, "
        f"from the law {law}, "
        f"restitution within {1.96 * scatter:.1%}"
    )
    found = _inverted(contact, drops.speed, drops.restitution, metal, scatter, source)
    if drops.ball is not None:
        found = attrs.evolve(found, notes=(*found.notes, DENTS))
    return found


def _inverted(contact, speed, measured, metal, scatter, source) -> Strength:
    """Find the yield strength at which `contact` reproduces the measured restitutions."""
    speeds, place = np.unique(speed, return_inverse=True)

    def restitution(strength: float) -> np.ndarray:
        return contact(strength).impact(speeds).coefficient_of_restitution[place]

    bounds = LEAST_RATIO * metal.youngs_modulus, LARGEST_RATIO * metal.youngs_modulus
    found = estimate_strength(restitution, measured, bounds, scatter)
    at = contact(found.yield_strength)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always", RangeWarning)
        at.restitution(speeds)
    notes = [str(warning.message) for warning in said]
    if found.residual_scatter > 3 * scatter:
        warnings.warn(
            f"the restitutions scatter by {found.residual_scatter:.1%} about the law "
            f"{at.law.name}; the stated scatter is {scatter:.1%}. Check the range of the law "
            "and the materials of ball and plate, or raise scatter",
            stacklevel=2,
        )
    if at.pair.yield_strength < found.yield_strength:
        notes.append(
            f"the other body yields first, at {at.pair.yield_strength:.4g} Pa. The strength is "
            "a lower bound"
        )
    elif found.interval[1] == inf:
        notes.append("the impacts are nearly elastic: the interval has no upper end")
    notes += _trend(speed, measured / restitution(found.yield_strength), scatter)
    ratio = speeds / yield_speed_of(at)
    return Strength(
        found.yield_strength,
        found.interval,
        source,
        (float(ratio[0]), float(ratio[-1])),
        at,
        tuple(notes),
    )


def _trend(speed: np.ndarray, ratio: np.ndarray, scatter: float) -> list[str]:
    """Return a note if the ratio of measured to predicted restitution has a trend with speed.

    The trend must be significant (p < 0.01) and larger than the scatter of one measurement.
    """
    logarithm = np.log(speed)
    if len(speed) < 4 or np.ptp(logarithm) == 0:
        return []
    line = linregress(logarithm, np.log(ratio))
    if not line.pvalue < CHANCE:
        return []
    ends = np.array([logarithm.min(), logarithm.max()])
    slow, fast = np.expm1(line.intercept + line.slope * ends)
    if abs(fast - slow) < scatter:
        return []
    return [
        f"the deviation from the law depends on speed: {slow:+.1%} at the slowest and "
        f"{fast:+.1%} at the fastest impact (p < 0.01). Try another law or another "
        "rate_coefficient"
    ]


def given(yield_strength: float) -> Strength:
    """Return a strength that is known."""
    return Strength(yield_strength, (yield_strength, yield_strength), "as given")


def yield_speed_of(contact: Contact) -> float:
    """Return the closing speed at which the contact reaches yield [m/s]."""
    return yield_speed(contact.pair, contact.radius_eff, contact.mass_eff)


def check_law(law: str) -> None:
    """Check that `law` describes spheres that yield.

    Raises:
        ValueError: The law does not exist, or is not for spheres that yield.
    """
    known = sorted(
        name for name, kind in laws.LAWS.items() if kind.shape == "sphere" and kind.yields
    )
    if law not in known:
        raise ValueError(
            f"law is {law!r}; it must be one of the laws for spheres that yield: {', '.join(known)}"
        )
