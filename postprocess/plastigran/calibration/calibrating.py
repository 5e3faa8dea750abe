# SPDX-License-Identifier: GPL-2.0-or-later
"""Constants of a metal, a law and deck lines from one measurement."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import attrs
import numpy as np

from plastigran import laws
from plastigran.calibration import strength
from plastigran.calibration.drop_test import DropTest, read_drop_test
from plastigran.calibration.expected_errors import (
    DEFAULT_LAW,
    USUAL_SPEEDS,
    ExpectedError,
    expected_error,
)
from plastigran.calibration.finite_elements import press_sphere
from plastigran.calibration.hardness import Hardness, read_hardness
from plastigran.calibration.metal import CalibratedMetal
from plastigran.contact import Contact
from plastigran.declared import RADIUS, Declaration, read_number
from plastigran.materials import RIGID, Material

FEM_RADIUS = 0.1  # radius of the finite-element sphere [m]
SPHERE_RADIUS = 1e-2  # radius of a sphere on a rigid plane [m]; restitution does not depend on it
UNITS = {
    "youngs_modulus": (Declaration("", "Pa", 1e6, 2e12), "Check the unit: Pa, not MPa or GPa"),
    "density": (Declaration("", "kg/m^3", 10, 3e4), "Check the unit: kg/m^3, not g/cm^3"),
}


def calibrate(
    *,
    youngs_modulus: float,
    poissons_ratio: float,
    density: float,
    yield_strength: float | None = None,
    hardness: Hardness | float | str | None = None,
    leeb: float | str | None = None,
    drops: DropTest | str | Path | None = None,
    plastic_modulus: float = 0.0,
    rate_coefficient: float | None = None,
    scatter: float | None = None,
    law: str = DEFAULT_LAW,
    speeds: float | Sequence[float] | None = None,
    force_ratio: float | None = None,
    radius: float = FEM_RADIUS,
    strain: str = "small",
    name: str = "metal",
    progress: bool = False,
) -> CalibratedMetal:
    """Find the constants of a metal from its yield strength, hardness, rebound hardness or drops.

    Args:
        youngs_modulus: E [Pa].
        poissons_ratio: nu [-].
        density: Density [kg/m^3].
        yield_strength: sigma_Y [Pa], if known.
        hardness: HV, or a text such as "45HRC" or "200HB".
        leeb: Reading of a rebound tester: HLD, or a text such as "750HLG".
        drops: A drop test, or a file of one with a ball of the metal and a rigid plate.
        plastic_modulus: H, stress over plastic strain [Pa]; 0 for perfectly plastic.
        rate_coefficient: Relative increase of yield strength per e-fold increase of strain rate,
            with
            the strength given at 1/s. None for the value of steel with a steel's hardness or
            rebound hardness, which are measured at very different rates, and otherwise for 0.
        scatter: Relative standard deviation of one measured restitution; None for 0.02 for drops,
            and
            for the scatter of conversions of rebound hardness.
        law: Name of the law.
        speeds: Slowest and fastest impact speed of the intended simulation [m/s], for a sphere of
            the metal on a rigid plane; None for those of the measurement, or else up to 300 yield
            speeds.
        force_ratio: Largest force / yield force of a finite-element fit of `vu_quoc_zhang`; None
            for no finite elements.
        radius: Radius of the finite-element sphere [m].
        strain: Kinematics of the finite elements, small or finite.
        name: Name of the metal.
        progress: Whether to show a bar for the finite elements.

    Raises:
        ValueError: There is not exactly one measurement; or a value has no effect, is out of range,
            seems to have another unit, or does not determine the strength. The message names it and
            the range.
        OSError: A file cannot be read.

    Warns:
        UserWarning: Measurements scatter about the law more than stated.
        SmallStrainWarning: As of `press_sphere`.

    Sources: see `hardness`, `physics.rebound_hardness` and `inversion` for each method.
    """
    quantity, value = _one_measurement(
        yield_strength=yield_strength, hardness=hardness, leeb=leeb, drops=drops
    )
    finite_elements = {"radius": (radius, FEM_RADIUS), "strain": (strain, "small")}
    _refuse_idle(quantity, scatter, {} if force_ratio is not None else finite_elements)
    _check_units(youngs_modulus=youngs_modulus, density=density)
    strength.check_law(law)
    read_number("plastic_modulus", plastic_modulus, Declaration("", "Pa", 0, lower_allowed=True))
    if scatter is not None:
        read_number("scatter", scatter, Declaration("", "-", 0, 0.5))
    if force_ratio is not None:
        read_number("force_ratio", force_ratio, Declaration("", "-", 0))
        read_number("radius", radius, RADIUS)
    rate, rate_notes = _rate(rate_coefficient, quantity, youngs_modulus)
    metal = Material(
        name,
        youngs_modulus,
        poissons_ratio,
        density,
        yield_strength=youngs_modulus,  # until it is known
        tangent_modulus=youngs_modulus * plastic_modulus / (youngs_modulus + plastic_modulus),
        rate_coefficient=rate,
    )
    test = _drop_test(value) if quantity == "drops" else None
    result = _strength(quantity, test or value, law, metal, plastic_modulus, scatter)
    _check_strength(result.value, youngs_modulus)
    metal = attrs.evolve(metal, yield_strength=result.value)
    contact = Contact(law, metal, RIGID, radius=SPHERE_RADIUS)
    notes = [*result.notes, *rate_notes]
    if plastic_modulus and not laws.LAWS[law].hardens:
        notes.append(f"{law} does not include hardening: it uses only the yield strength")
    pressed = None
    if force_ratio is not None:
        pressed = press_sphere(
            youngs_modulus, poissons_ratio, density, result.value, plastic_modulus, force_ratio,
            radius, strain, progress,
        )  # fmt: skip
    return CalibratedMetal(
        metal,
        result.interval,
        result.source,
        law,
        _error(contact, result, speeds, plastic_modulus > 0, test),
        strength.yield_speed_of(contact),
        tuple(notes),
        test,
        pressed,
    )


def _one_measurement(**measured: Any) -> tuple[str, Any]:
    """Return the name and the value of the only measurement that is given.

    Raises:
        ValueError: There is none, or more than one.
    """
    given = [(name, value) for name, value in measured.items() if value is not None]
    if len(given) != 1:
        names = " and ".join(name for name, _ in given) or "none"
        raise ValueError(f"{names} of {', '.join(measured)} is given; exactly one is needed")
    return given[0]


def _rate(
    rate_coefficient: float | None, quantity: str, youngs_modulus: float
) -> tuple[float, list[str]]:
    """Return the rate coefficient and the notes on it.

    Steel has a published one, and hardness and rebound are measured at very different rates.
    """
    depends_on_rate = quantity in ("hardness", "leeb")
    if rate_coefficient is None and depends_on_rate and strength.STEEL.allows(youngs_modulus):
        rate = strength.STEEL_RATE_COEFFICIENT
    else:
        rate = rate_coefficient or 0.0
    if rate:
        return rate, [
            f"the strength is for a strain rate of 1/s; the rate coefficient is C = {rate:g}"
        ]
    if depends_on_rate and rate_coefficient is None:
        return rate, [
            "no dependence on the strain rate is assumed; docs/rate_factor.md lists published "
            "coefficients of other metals than steel: give rate_coefficient"
        ]
    return rate, []


def _drop_test(drops: DropTest | str | Path) -> DropTest:
    """Return a drop test, read from a file if it is one.

    Raises:
        ValueError: It is neither.
    """
    if isinstance(drops, DropTest):
        return drops
    if not isinstance(drops, str | Path):
        raise ValueError(f"drops is {drops!r}; it must be a DropTest or the file of one")
    return DropTest(**read_drop_test(drops))


def _strength(
    quantity: str,
    value: Any,
    law: str,
    metal: Material,
    plastic_modulus: float,
    scatter: float | None,
) -> strength.Strength:
    """Return the yield strength that follows from a measured quantity."""
    if quantity == "yield_strength":
        return strength.given(read_number(quantity, value, Declaration("", "Pa", 0)))
    if quantity == "hardness":
        return strength.from_hardness(read_hardness(value), plastic_modulus, metal.youngs_modulus)
    method = strength.from_leeb if quantity == "leeb" else strength.from_drops
    return method(value, law, metal, scatter)


def _error(
    contact: Contact,
    found: strength.Strength,
    speeds: Sequence[float] | None,
    hardening: bool,
    drops: DropTest | None,
) -> ExpectedError:
    """Return the error of the law for the intended speeds, the measured ones, or usual ones."""
    ratio = found.speed_ratio or USUAL_SPEEDS
    if speeds is not None:
        said = Declaration("", "m/s", 0)
        read = sorted(read_number("speeds", speed, said) for speed in np.ravel(speeds).tolist())
        if not read:
            raise ValueError("speeds is empty; it must be the smallest and the largest [m/s]")
        ratio = tuple(speed / strength.yield_speed_of(contact) for speed in (read[0], read[-1]))
    elif found.contact is not None:
        contact = found.contact
        if drops is not None and (drops.ball is not None or drops.plate != RIGID):
            return ExpectedError.of_another_pair(ratio)
    fastest = contact.impact(max(ratio[1], 1.0) * strength.yield_speed_of(contact))
    widest = contact.law.follow(contact.radius_eff, [fastest.overlap_max])["contact_radius"][0]
    return expected_error(contact.law.name, ratio, hardening, widest / contact.radius_eff)


def _refuse_idle(measured: str, scatter: float | None, others: dict[str, tuple]) -> None:
    """Refuse values without effect.

    These are `scatter` for a measurement without scatter, and settings of finite elements that are
    not computed.

    Raises:
        ValueError: There is such a value; the message names it.
    """
    if scatter is not None and measured not in ("leeb", "drops"):
        raise ValueError(
            f"scatter is {scatter!r}, but it applies only to leeb or drops, not to {measured}"
        )
    for name, (value, usual) in others.items():
        if value != usual:
            raise ValueError(
                f"{name} is {value!r}, but it applies only to finite elements. Give force_ratio"
            )


def _check_units(**values: float) -> None:
    for name, value in values.items():
        said, question = UNITS[name]
        try:
            read_number(name, value, said)
        except ValueError as error:
            raise ValueError(f"{error}. {question}") from None


def _check_strength(value: float, youngs_modulus: float) -> None:
    """Refuse a strength that no solid of that modulus has.

    Raises:
        ValueError: It is below 1e-6 of Young's modulus or above 0.3 of it.
    """
    least, largest = (
        share * youngs_modulus for share in (strength.LEAST_RATIO, strength.LARGEST_RATIO)
    )
    if not least < value < largest:
        raise ValueError(
            f"yield_strength is {value:.4g} Pa; with youngs_modulus {youngs_modulus:.4g} Pa it "
            f"must lie between {least:.3g} and {largest:.3g} Pa. Check the units: Pa, not MPa "
            "or GPa"
        )
