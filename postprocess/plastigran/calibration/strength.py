# SPDX-License-Identifier: GPL-2.0-or-later
"""Yield strength from what was measured: hardness, a rebound tester's reading, or drops."""

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

LEAST_RATIO, LARGEST_RATIO = 1e-6, 0.3  # strengths over Young's modulus that are looked at
DENTS = (
    "the expected errors are for spheres that flatten; for indented flats see "
    "docs/validation_steel.md"
)
DROP_SCATTER = 0.02  # standard deviation of one restitution, where no other is stated
LEEB_SCATTER = 0.045 / 1.96  # of a reading, conversions' 95 % being 4.5 %
CHANCE = 0.01  # of a change with the speed that is none
LEEB_RANGE = Declaration("rebound hardness", "HL", 100, 1000, closed=True)
STEEL = Declaration("Young's modulus of steel", "Pa", 1.9e11, 2.2e11)
STEEL_RATE_COEFFICIENT = 0.014  # of 4340, at 1/s: Johnson & Cook, 7th Int. Symp. Ballistics 1983


@attrs.frozen
class Strength:
    """A yield strength and what it rests on.

    Attributes:
        value: sigma_Y [Pa].
        interval: 95 % [Pa].
        source: In words.
        speed_ratio: Speeds of the measurement over the yield speed [-]; None where nothing moved.
        contact: Of the measurement, at that strength; None where there was none.
        notes: Sentences.
    """

    value: float
    interval: tuple[float, float]
    source: str
    speed_ratio: tuple[float, float] | None = None
    contact: Contact | None = None
    notes: tuple[str, ...] = ()


def from_hardness(hardness: Hardness, plastic_modulus: float, youngs_modulus: float) -> Strength:
    """H/2.8, the flow stress at 8 % strain, less what hardening adds until then.

    Args:
        hardness: Of the metal.
        plastic_modulus: H_p, stress over plastic strain [Pa].
        youngs_modulus: E [Pa], by which a steel is known.

    Raises:
        ValueError: Hardening alone would give more than the flow stress.
    """
    flow = float(hardness.flow_stress)
    added = DENT_STRAIN * plastic_modulus
    if not added < flow:
        raise ValueError(
            f"the plastic modulus is {plastic_modulus:g} Pa; with {hardness} it must be below "
            f"{flow / DENT_STRAIN:.3g} Pa, for at {DENT_STRAIN:.0%} strain the flow stress is "
            f"{flow:.4g} Pa"
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
    """Device and reading from a number, which is HLD, or a text such as "750HLG".

    Raises:
        ValueError: It is neither, or out of range.
    """
    found = re.fullmatch(r"\s*([-+.\dE]+?)\s*(?:HL([A-Z]*))?\s*", str(given).upper())
    device = (found and found[2]) or "D"
    if found is None or device not in TESTERS:
        raise ValueError(
            f"leeb is {given!r}; it must be a number and a device of "
            f"{', '.join('HL' + name for name in TESTERS)}, as 540HLD"
        )
    return TESTERS[device], read_number("leeb", found[1], LEEB_RANGE)


def from_leeb(given: float | str, law: str, metal: Material, scatter: float | None) -> Strength:
    """The strength with which a law gives a rebound tester's reading.

    Args:
        given: The reading, as of `read_leeb`.
        law: Name of the law.
        metal: Of the sample; its strength is not used.
        scatter: Standard deviation of the restitution [share]; None for that of conversions.

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
    """The strength with which a law gives the restitutions of a drop test.

    Args:
        drops: The test.
        law: Name of the law.
        metal: Of ball or plate; its strength is not used.
        scatter: Standard deviation of one restitution [share]; None for `DROP_SCATTER`.

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
    """The strength of a contact whose impacts were measured."""
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
            f"the restitutions scatter by {found.residual_scatter:.1%} about {at.law.name}, more "
            f"than the {scatter:.1%} stated: does the law hold there, and do the bodies?",
            stacklevel=2,
        )
    if at.pair.yield_strength < found.yield_strength:
        notes.append(
            f"the other body yields first, at {at.pair.yield_strength:.4g} Pa: take the strength "
            "as a lower bound"
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
    """A note where measured restitutions over the law's change with the speed, by more than one of
    them scatters: chance would do so once in a hundred times.
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
        f"the restitutions lie {slow:+.1%} off the law at the slowest impacts and {fast:+.1%} at "
        "the fastest, which chance hardly does: is the law theirs, and the rate coefficient?"
    ]


def given(yield_strength: float) -> Strength:
    """A strength that is known."""
    return Strength(yield_strength, (yield_strength, yield_strength), "as given")


def yield_speed_of(contact: Contact) -> float:
    """Closing speed at which the contact reaches yield [m/s]."""
    return yield_speed(contact.pair, contact.radius_eff, contact.mass_eff)


def check_law(law: str) -> None:
    """Refuse a law that has no yield strength to find.

    Raises:
        ValueError: There is no such law, or it is not for spheres that yield.
    """
    known = sorted(
        name for name, kind in laws.LAWS.items() if kind.shape == "sphere" and kind.yields
    )
    if law not in known:
        raise ValueError(f"law is {law!r}; laws of spheres that yield are {', '.join(known)}")
