# SPDX-License-Identifier: GPL-2.0-or-later
"""Surface energy of two bodies from their pull-off force or their sticking speed.

For `jkr`, the surface energy Gamma follows from a closed form (Johnson, Kendall & Roberts 1971,
Proc. R. Soc. Lond. A 324:301): the pull-off force 3/2 pi Gamma R*, or the sticking speed of
`physics.adhesion.jkr_sticking_speed`. For a law that yields, a numerical search finds the surface
energy at which the law has the measured pull-off force after a given load, or the measured sticking
speed.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import exp, inf, log, pi

import attrs
from scipy.optimize import brentq

from plastigran import laws
from plastigran.calibration.deck_lines import deck_lines
from plastigran.contact import Bodylike, Contact
from plastigran.declared import SPEED, Declaration, read_number
from plastigran.materials import (
    RIGID,
    SURFACE_ENERGY,
    Material,
    can_adhere,
    law_class,
    read_material,
)
from plastigran.physics.adhesion import jkr_surface_energy

#: Law that `calibrate_adhesion` uses by default.
DEFAULT_LAW = "jkr"
#: Smallest surface energy of the search [J/m^2].
LEAST = 1e-9
#: Distance between atoms [m]. `jkr` is valid if the elastic stretching (R* Gamma^2/E*^2)^(1/3) of
#: the contact is much larger than this distance.
ATOMS = 3e-10

_FORCE = Declaration("pull-off force", "N", 0)
_LOAD = Declaration("largest load before pull-off", "N", 0, lower_allowed=True)


@attrs.frozen
class CalibratedAdhesion:
    """Result of `calibrate_adhesion`.

    Attributes:
        surface_energy: Work of adhesion Gamma of the two bodies [J/m^2].
        sensitivity: Relative change of the surface energy / relative change of the measured value.
        source: Measurement and bodies, one phrase.
        contact: Contact of the measurement, with this surface energy.
        material: Material of body a, with this surface energy.
        pull_off_force: Pull-off force of the contact after `load` [N].
        load: Largest load before pull-off [N].
        sticking_speed: Closing speed below which the bodies stick [m/s].
        notes: Remarks for the user, one sentence each.
    """

    surface_energy: float
    sensitivity: float
    source: str
    contact: Contact
    material: Material
    pull_off_force: float
    load: float
    sticking_speed: float
    notes: tuple[str, ...]

    def to_dict(self) -> dict[str, object]:
        """Return all numbers in SI units."""
        numbers = ("surface_energy", "sensitivity", "source", "pull_off_force", "load")
        values = {name: getattr(self, name) for name in (*numbers, "sticking_speed")}
        distance = self.contact.law.pull_off_distance(self.contact.radius_eff)
        law, notes = self.contact.law.name, list(self.notes)
        return values | {"pull_off_distance": distance, "law": law, "notes": notes}

    def deck_lines(self) -> list[str]:
        """Return the lines of a deck in which atom type 1 is the material of body a."""
        law = self.contact.law
        option = " adhesion jkr" if law.name in laws.ADHESIVE_LAWS else ""
        names = ["youngs_modulus", "poissons_ratio", *(["yield_strength"] if law.yields else [])]
        body = {name: getattr(self.material, name) for name in names}
        pair = {"surface_energy": self.surface_energy}
        return deck_lines(f"{law.name} tangential history{option}", body, pair)

    @property
    def remark(self) -> str:
        """Source of the surface energy as a sentence, for the header of a material file."""
        return f"Surface energy from {self.source}, by the law {self.contact.law.name}."

    def __str__(self) -> str:
        """Return a summary as readable text."""
        numbers = self.to_dict()
        after = f" after a load of {self.load:.4g} N" if self.load else ""
        lines = {
            "surface energy": f"{self.surface_energy:.4g} J/m2",
            "from": self.source,
            "law": numbers["law"],
            "sensitivity": "a change of 1 % in the measured value changes the surface energy by "
            f"{self.sensitivity:.2f} %",
            "pull-off force": f"{self.pull_off_force:.4g} N{after}",
            "pull-off distance": f"{numbers['pull_off_distance']:.3g} m",
            "sticking speed": f"{self.sticking_speed:.4g} m/s, closing speed of the two bodies",
        } | {f"note {k}": note for k, note in enumerate(self.notes, start=1)}
        return "\n".join(f"{name:20s}{text}" for name, text in lines.items())


def calibrate_adhesion(
    a: Material | str,
    b: Bodylike = RIGID,
    *,
    radius: float,
    radius_other: float | None = None,
    pull_off_force: float | None = None,
    sticking_speed: float | None = None,
    load: float = 0.0,
    law: str = DEFAULT_LAW,
) -> CalibratedAdhesion:
    """Find the surface energy of two bodies from one measurement.

    Args:
        a: Material of body a, or its name or file.
        b: Material of body b, or RIGID.
        radius: Radius of body a [m].
        radius_other: Radius of body b [m]; None for a flat.
        pull_off_force: Force that separates the bodies [N].
        sticking_speed: Closing speed below which the bodies stick [m/s].
        load: Largest compressive force before pull-off [N]. The load has an effect only for laws
            with yield.
        law: Name of a law with a surface energy.

    Raises:
        ValueError: The number of measurements is not one; the law has no surface energy; or a value
            is out of range, or needs a surface energy that is out of range. The message names it.
    """
    law_class(law)
    if not can_adhere(law):
        names = sorted(filter(can_adhere, laws.LAWS))
        raise ValueError(f"law {law} has no surface energy. Use one of {', '.join(names)}")
    if (pull_off_force is None) == (sticking_speed is None):
        raise ValueError(
            f"pull_off_force is {pull_off_force} and sticking_speed is {sticking_speed}. Give "
            "exactly one of pull_off_force and sticking_speed"
        )
    yields = laws.LAWS[law].yields
    load = read_number("load", load, _LOAD)
    if load and (not yields or pull_off_force is None):
        reason = "applies only to pull_off_force" if yields else f"{law} does not yield"
        raise ValueError(f"load is {load:g}, but has no effect, because {reason}. Remove load")
    material = read_material(a)

    def contact(surface_energy: float) -> Contact:
        bodies = {"radius": radius, "radius_other": radius_other}
        return Contact(law, material, b, surface_energy=surface_energy, **bodies)

    if pull_off_force is not None:
        name, value = "pull_off_force", read_number("pull_off_force", pull_off_force, _FORCE)
        measured = f"pull-off force {value:g} N"
        solve = _from_force if yields else _jkr_from_force
        solve = partial(solve, contact, load)
    else:
        name, value = "sticking_speed", read_number("sticking_speed", sticking_speed, SPEED)
        measured = f"sticking speed {value:g} m/s"
        solve = partial(_from_speed if yields else _jkr_from_speed, contact)
    gamma = solve(value)
    if not LEAST < gamma < SURFACE_ENERGY.upper:
        unit = {"pull_off_force": "N", "sticking_speed": "m/s"}[name]
        raise ValueError(
            f"{name} is {value:g} {unit}; with {law}, the surface energy would lie outside of "
            f"{LEAST:g} to {SURFACE_ENERGY.upper:g} J/m2. Check the units and radius, {radius:g} m"
        )
    result = contact(gamma)
    return CalibratedAdhesion(
        gamma,
        log(solve(1.001 * value) / gamma) / log(1.001),
        f"{measured} of {_bodies(material, b, radius, radius_other)}",
        result,
        attrs.evolve(material, surface_energy=gamma),
        pull_off_after(result, load),
        load,
        _sticking_speed(result),
        tuple(_notes(result, gamma, material, b)),
    )


def pull_off_after(contact: Contact, load: float) -> float:
    """Return the pull-off force after first loading to a compressive force [N].

    Args:
        contact: Contact with a law that has a surface energy.
        load: Largest compressive force [N].

    Raises:
        ValueError: The bodies would overlap by more than the effective radius R*.
    """
    law, radius = contact.law, contact.radius_eff

    def missing(overlap: float) -> float:
        return load - law.respond(radius, overlap).force

    high = radius
    if missing(high) > 0:
        raise ValueError(
            f"load is {load:g} N; the bodies would overlap by more than R* = {radius:.3g} m. "
            "Lower load, or check its unit"
        )
    state = law.State()
    law.respond(radius, brentq(missing, 0, high, xtol=1e-18 * radius, rtol=1e-15), state)
    return float(law.pull_off_force(radius, 0.0, state))


def _jkr_from_force(contact: Callable[[float], Contact], load: float, force: float) -> float:
    return force / (1.5 * pi * contact(0.0).radius_eff)


def _jkr_from_speed(contact: Callable[[float], Contact], speed: float) -> float:
    bodies = contact(0.0)
    modulus = bodies.pair.youngs_modulus_eff
    return jkr_surface_energy(speed, bodies.radius_eff, modulus, bodies.mass_eff)


def _from_force(contact: Callable[[float], Contact], load: float, force: float) -> float:
    """Return the surface energy for a pull-off force.

    Plastic flattening increases the pull-off force. The surface energy is therefore at most the
    value for `jkr`.
    """
    upper = _jkr_from_force(contact, load, force)
    if not LEAST < upper < SURFACE_ENERGY.upper:
        return upper
    return _root(lambda gamma: pull_off_after(contact(gamma), load) >= force, upper)


def _from_speed(contact: Callable[[float], Contact], speed: float) -> float:
    def sticks(surface_energy: float) -> bool:
        return contact(surface_energy).impact(speed).coefficient_of_restitution == 0

    return _root(sticks, SURFACE_ENERGY.upper) if sticks(SURFACE_ENERGY.upper) else inf


def _root(reached: Callable[[float], bool], upper: float) -> float:
    """Return the smallest surface energy [J/m^2] for which `reached` is true.

    `reached` must be true at `upper`.
    """
    low, high = log(LEAST), log(upper)
    while high - low > 1e-13:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (low, middle) if reached(exp(middle)) else (middle, high)
    return exp(high)


def _sticking_speed(contact: Contact) -> float:
    try:
        return contact.sticking_speed
    except ValueError:  # the sticking speed exceeds the largest speed of the search
        return inf


def _bodies(material: Material, b: Bodylike, radius: float, radius_other: float | None) -> str:
    other = "rigid" if b == RIGID else read_material(b).name
    if radius_other is None:
        plate = "a rigid plate" if other == "rigid" else f"a plate of {other}"
        return f"a sphere of {material.name}, radius {radius:g} m, on {plate}"
    return f"spheres of {material.name} and {other}, radii {radius:g} m and {radius_other:g} m"


def _notes(contact: Contact, gamma: float, material: Material, b: Bodylike) -> list[str]:
    notes = []
    stretching = (contact.radius_eff * (gamma / contact.pair.youngs_modulus_eff) ** 2) ** (1 / 3)
    if stretching < 10 * ATOMS:
        notes.append(
            f"the elastic stretching (R* Gamma^2/E*^2)^(1/3) is {stretching:.2g} m; the law is "
            f"valid only if this length is much larger than the distance between atoms, {ATOMS:g} m"
        )
    if b == RIGID or read_material(b) != material:
        notes.append(
            f"the surface energy belongs to this pair of bodies; two bodies of {material.name} "
            "have another surface energy"
        )
    return notes
