# SPDX-License-Identifier: GPL-2.0-or-later
"""Calibration of a metal from one measurement: constants, law, expected error and deck lines."""

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
from plastigran.calibration.strength import LARGEST_RATIO, LEAST_RATIO, Strength
from plastigran.contact import Contact
from plastigran.declared import RADIUS, Declaration, read_number
from plastigran.materials import RIGID, Material
from plastigran.usable_laws import laws_for

FEM_RADIUS = 0.1  # radius of the finite-element sphere [m]
# Radius of the sphere [m] in impacts on a rigid plane. It affects the restitution only if the yield
# strength depends on the strain rate.
SPHERE_RADIUS = 1e-2
BOUNDS = {
    "youngs_modulus": Declaration("", "Pa", 1e6, 2e12),
    "density": Declaration("", "kg/m^3", 10, 3e4),
    "yield_strength": Declaration("", "Pa", 0),
    "plastic_modulus": Declaration("", "Pa", 0, lower_allowed=True),
    "scatter": Declaration("", "-", 0, 0.5),
    "force_ratio": Declaration("", "-", 0),
    "radius": RADIUS,
    "speeds": Declaration("", "m/s", 0),
}
CHECK_UNIT = {
    "youngs_modulus": ". Check the unit: Pa, not MPa or GPa",
    "density": ". Check the unit: kg/m^3, not g/cm^3",
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
        youngs_modulus: Young's modulus E [Pa].
        poissons_ratio: Poisson's ratio nu [-].
        density: Density [kg/m^3].
        yield_strength: Yield strength sigma_Y [Pa], if known.
        hardness: Vickers hardness HV as a number, or a text such as "45HRC" or "200HB".
        leeb: Reading of a rebound tester: HLD as a number, or a text such as "750HLG".
        drops: Drop test, or the path of its file. If a file is given, the ball consists of the
            metal and the plate is rigid.
        plastic_modulus: Plastic modulus H, the slope of stress versus plastic strain [Pa]; 0 for a
            perfectly plastic metal.
        rate_coefficient: Relative increase of yield strength per e-fold increase of strain rate.
            The resulting yield strength holds for a strain rate of 1/s. For steel with a measured
            hardness or rebound hardness, the default is the value of steel, because these tests
            have other strain rates than a simulation. Otherwise, the default is 0.
        scatter: Relative standard deviation of one measured restitution. The default is 0.02 for
            drops, and the scatter of conversions for rebound hardness.
        law: Name of the law.
        speeds: Slowest and fastest impact speed of the intended simulation [m/s], for a sphere of
            the metal on a rigid plane. The default is the range of the measured impacts, or 1 to
            300 yield speeds if no impacts were measured.
        force_ratio: Largest force / yield force of a finite-element computation, to which the
            constants of `vu_quoc_zhang` are fitted. None omits the finite elements.
        radius: Radius of the finite-element sphere [m].
        strain: Strain of the finite elements: "small", or "finite" for a/R above 0.1.
        name: Name of the metal.
        progress: Whether to show a bar for the finite elements.

    Raises:
        ValueError: The number of measurements is not one; or a value has no effect, is out of
            range, seems to have another unit, or does not determine the strength. The message names
            the value and its range.
        OSError: A file cannot be read.

    Warns:
        UserWarning: Measurements scatter about the law more than `scatter` states.
        SmallStrainWarning: As for `press_sphere`.

    Sources: see `hardness`, `physics.rebound_hardness` and `inversion` for each method.
    """
    measurements = {
        "yield_strength": yield_strength,
        "hardness": hardness,
        "leeb": leeb,
        "drops": drops,
    }
    given = [quantity for quantity, value in measurements.items() if value is not None]
    if len(given) != 1:
        raise ValueError(
            f"given measurements: {' and '.join(given) or 'none'}; exactly one is needed. Choose "
            f"one of {', '.join(measurements)}"
        )
    (quantity,) = given
    _refuse_unused(quantity, scatter, force_ratio, radius, strain)
    _check_numbers(youngs_modulus=youngs_modulus, density=density)
    _check_law(law)
    _check_numbers(plastic_modulus=plastic_modulus, scatter=scatter, force_ratio=force_ratio)
    if force_ratio is not None:
        _check_numbers(radius=radius)
    rate, rate_notes = _rate(rate_coefficient, quantity, youngs_modulus)
    metal = Material(
        name,
        youngs_modulus,
        poissons_ratio,
        density,
        yield_strength=youngs_modulus,  # placeholder until the strength is known
        tangent_modulus=youngs_modulus * plastic_modulus / (youngs_modulus + plastic_modulus),
        rate_coefficient=rate,
    )
    test = None if drops is None else _drop_test(drops)
    if quantity == "yield_strength":
        value = read_number(quantity, yield_strength, BOUNDS[quantity])
        result = Strength(value, (value, value), "as given")
    elif quantity == "hardness":
        result = strength.from_hardness(read_hardness(hardness), plastic_modulus, youngs_modulus)
    elif quantity == "leeb":
        result = strength.from_leeb(leeb, law, metal, scatter)
    else:
        result = strength.from_drops(test, law, metal, scatter)
    _check_strength(result.value, youngs_modulus)
    metal = attrs.evolve(metal, yield_strength=result.value)
    contact = Contact(law, metal, RIGID, radius=SPHERE_RADIUS)
    notes = [*result.notes, *rate_notes]
    if plastic_modulus and not laws.LAWS[law].hardens:
        notes.append(f"{law} does not include hardening: the plastic modulus has no effect")
    pressed = None
    if force_ratio is not None:
        pressed = press_sphere(metal, plastic_modulus, force_ratio, radius, strain, progress)
    return CalibratedMetal(
        metal,
        result.interval,
        result.source,
        law,
        _expected_error(contact, result, speeds, plastic_modulus > 0, test),
        (contact if test is None else result.contact).yield_speed,
        tuple(notes),
        test,
        pressed,
    )


def _refuse_unused(
    quantity: str, scatter: float | None, force_ratio: float | None, radius: float, strain: str
) -> None:
    """Reject `scatter` and finite-element settings that the calibration does not use."""
    if scatter is not None and quantity not in ("leeb", "drops"):
        raise ValueError(
            f"scatter is {scatter!r}, but it applies only to leeb or drops, not to {quantity}. "
            "Omit scatter"
        )
    if force_ratio is None:
        for name, value, default in (("radius", radius, FEM_RADIUS), ("strain", strain, "small")):
            if value != default:
                raise ValueError(
                    f"{name} is {value!r}, but it applies only to finite elements, which need "
                    f"force_ratio. Give force_ratio too, or omit {name}"
                )


def _check_numbers(**values: float | None) -> None:
    for name, value in values.items():
        if value is None:
            continue
        try:
            read_number(name, value, BOUNDS[name])
        except ValueError as error:
            raise ValueError(f"{error}{CHECK_UNIT.get(name, '')}") from None


def _check_law(law: str) -> None:
    names = [name for name in laws_for("sphere") if laws.LAWS[name].yields]
    if law not in names:
        raise ValueError(
            f"law is {law!r}; it must be a law for yielding spheres, without adhesion and without "
            f"stiffnesses as constants. Use one of {', '.join(names)}"
        )


def _rate(
    rate_coefficient: float | None, quantity: str, youngs_modulus: float
) -> tuple[float, list[str]]:
    """Return the rate coefficient of the yield strength, and notes on it for the user."""
    depends_on_rate = quantity in ("hardness", "leeb")
    rate = rate_coefficient or 0.0
    if rate_coefficient is None and depends_on_rate:
        if not strength.STEEL.allows(youngs_modulus):
            return 0.0, [
                "the strength is assumed not to depend on the strain rate; docs/rate_factor.md "
                "lists published coefficients of metals, which you can give as rate_coefficient"
            ]
        rate = strength.STEEL_RATE_COEFFICIENT
    note = f"the strength is for a strain rate of 1/s; the rate coefficient is C = {rate:g}"
    return rate, [note] if rate else []


def _drop_test(drops: Any) -> DropTest:
    if isinstance(drops, DropTest):
        return drops
    if isinstance(drops, str | Path):
        return DropTest(**read_drop_test(drops))
    raise ValueError(f"drops is {drops!r}; it must be a DropTest or the path of a table of drops")


def _check_strength(value: float, youngs_modulus: float) -> None:
    """Reject a yield strength that is impossible for a solid of this Young's modulus."""
    least, largest = LEAST_RATIO * youngs_modulus, LARGEST_RATIO * youngs_modulus
    if not least < value < largest:
        raise ValueError(
            f"yield_strength is {value:.4g} Pa; with youngs_modulus {youngs_modulus:.4g} Pa it "
            f"must lie between {least:.3g} and {largest:.3g} Pa. Check the units: Pa, not MPa "
            "or GPa"
        )


def _expected_error(
    contact: Contact,
    result: Strength,
    speeds: float | Sequence[float] | None,
    hardening: bool,
    drops: DropTest | None,
) -> ExpectedError:
    """Return the expected error of the law in a range of impact speeds.

    The range is `speeds` if given, otherwise the range of the measured impacts. For measurements
    without impacts, the range is `USUAL_SPEEDS`.
    """
    ratio = result.speed_ratio or USUAL_SPEEDS
    another_pair = drops is not None and (drops.ball is not None or drops.plate != RIGID)
    if speeds is not None:
        intended = np.ravel(speeds).tolist()
        if not intended:
            raise ValueError("speeds is empty; give the slowest and the fastest impact speed [m/s]")
        intended = [read_number("speeds", speed, BOUNDS["speeds"]) for speed in intended]
        ratio = min(intended) / contact.yield_speed, max(intended) / contact.yield_speed
    elif result.contact is not None:
        contact = result.contact
        if another_pair:
            return ExpectedError.of_another_pair(ratio)
    fastest = contact.impact(max(ratio[1], 1.0) * contact.yield_speed)
    widest = contact.law.follow(contact.radius_eff, [fastest.overlap_max])["contact_radius"][0]
    error = expected_error(contact.law.name, ratio, hardening, widest / contact.radius_eff)
    if another_pair:  # name the bodies, because the result's yield speed is for the drop test
        return attrs.evolve(error, regime=f"{error.regime}, sphere on a rigid plane")
    return error
