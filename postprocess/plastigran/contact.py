# SPDX-License-Identifier: GPL-2.0-or-later
"""Contact of two bodies computed with a law in Python, without LIGGGHTS."""

from __future__ import annotations

import warnings
from math import inf, pi, sqrt
from pathlib import Path
from typing import TYPE_CHECKING, Any

import attrs
import numpy as np
from numpy.typing import ArrayLike

from plastigran import laws
from plastigran.declared import RADIUS, Declaration, read_number
from plastigran.materials import RIGID, Material, law_class, read_material
from plastigran.physics import central
from plastigran.physics.adhesion import sticking_speed
from plastigran.physics.oblique_contact import ObliqueOutcome, oblique_impacts

if TYPE_CHECKING:
    import pandas as pd

Bodylike = Material | laws.Body | str | Path

_MASS = Declaration("m*", "kg", lower=0)


class RangeWarning(UserWarning):
    """A contact exceeds the validity range of its law."""


class Contact:
    """Contact of two bodies that follows a contact law.

    Args:
        law: Name of the law.
        a, b: Materials of the two bodies. Each is a result of `plastigran.material`, the name of a
            material, the path of a material file, or `plastigran.RIGID`.
        radius: Radius of body a [m].
        radius_other: Radius of body b [m]; None for a flat.
        mass_eff: Effective mass m* [kg]. The default follows from the densities of the materials,
            for spheres or for cylinders of length `cylinder_length`. A flat, and a body without
            density, have an infinite mass.
        friction: Coefficient of friction [-].
        tangential: Name of the tangential law, for `oblique_impact`.
        rings: Number of concentric rings into which the tangential law `partial_slip` divides the
            contact area, 2 to 8.
        constants: Constants and options of the law. You can omit constants that the material of
            body a defines (of body b if body a is rigid). If `surface_energy` is given, a law that
            is elastic before yield includes JKR adhesion, as with `adhesion jkr` in a deck.

    Attributes:
        law: Law between the bodies, an instance of a class of `plastigran.laws.LAWS`.
        pair: Combined constants of the two bodies, such as the effective Young's modulus E*.
        tangential: Tangential law between the bodies, of `plastigran.laws.TANGENTIAL_LAWS`.
        radius_eff: Effective radius R* [m].

    Raises:
        ValueError: The law or material does not exist, or a value is missing, not a number or out
            of range; the message names it.
    """

    def __init__(
        self,
        law: str,
        a: Bodylike,
        b: Bodylike,
        *,
        radius: float,
        radius_other: float | None = None,
        mass_eff: float | None = None,
        friction: float = 0.0,
        tangential: str = "partial_slip",
        rings: int = 4,
        **constants: float | str,
    ) -> None:
        law_type = law_class(law, adhesive="surface_energy" in constants)
        if tangential not in laws.TANGENTIAL_LAWS:
            known = ", ".join(laws.TANGENTIAL_LAWS)
            raise ValueError(f"tangential is {tangential!r}; it must be one of: {known}")
        self.tangential: laws.PartialSlip | laws.Incremental
        if tangential == "partial_slip":
            self.tangential = laws.PartialSlip(friction, rings)
        else:
            self.tangential = laws.TANGENTIAL_LAWS[tangential](friction)
        self._bodies = [_read_body(name, body) for name, body in (("a", a), ("b", b))]
        self._radii = [read_number("radius", radius, RADIUS), inf]
        if radius_other is not None and radius_other != inf:
            self._radii[1] = read_number("radius_other", radius_other, RADIUS)
        if mass_eff is not None:
            mass_eff = read_number("mass_eff", mass_eff, _MASS)
        self._mass_eff, self._constants = mass_eff, constants
        self.pair = laws.combine(*(_properties(body) for body in self._bodies))
        material = next((body for body in self._bodies if isinstance(body, Material)), None)
        if material is None:
            self.law = law_type(self.pair, **constants)
        else:
            self.law = material.law(law, self.pair, **constants)
        self.radius_eff = 1 / sum(1 / radius for radius in self._radii)

    @property
    def mass_eff(self) -> float:
        """Effective mass m* [kg].

        Raises:
            ValueError: No body has a finite mass, and no `mass_eff` was given.
        """
        if self._mass_eff is None:
            inverse = sum(1 / mass for mass in map(self._mass, self._bodies, self._radii))
            if inverse == 0:
                raise ValueError(
                    "the effective mass is unknown, because no body has both a density and a "
                    "radius. Give mass_eff [kg]"
                )
            return 1 / inverse
        return self._mass_eff

    def _mass(self, body: Material | laws.Body, radius: float) -> float:
        if not isinstance(body, Material) or radius == inf:
            return inf
        if self.law.shape == "sphere":
            return 4 / 3 * pi * radius**3 * body.density
        return pi * radius**2 * self._constants["cylinder_length"] * body.density

    def path(self, overlaps: ArrayLike) -> pd.DataFrame:
        """Return the response of a new contact along a path of overlaps.

        Args:
            overlaps: Overlaps (N,) [m].

        Returns:
            N rows with the columns overlap [m], force [N], contact_radius [m], elastic_energy [J]
            (recoverable) and plastic_work [J] (dissipated). A law with adhesion also has the column
            surface_energy [J].

        Warns:
            RangeWarning: An overlap exceeds the range of the law.
        """
        import pandas as pd  # imported here, because pandas is slow to load

        overlaps = np.array(overlaps, dtype=float, ndmin=1)
        self._warn("overlap", "m", overlaps[overlaps > self.overlap_range])
        response = self.law.follow(self.radius_eff, overlaps)
        names = ["force", "contact_radius", "elastic_energy", "plastic_work"]
        names += ["surface_energy"] if self.law.adhesive else []
        return pd.DataFrame({"overlap": overlaps} | {name: response[name] for name in names})

    @property
    def overlap_range(self) -> float:
        """Largest valid overlap of the law [m]; `law.range` describes the range in words."""
        return self.law.overlap_range * self.radius_eff

    @property
    def yield_overlap(self) -> float:
        """Overlap at which the weaker body first yields [m]; infinite for a law without yield.

        For spheres, the yield overlap is R* (pi p_y/(2 E*))^2. R* is the effective radius, and E*
        the effective Young's modulus. At this overlap, the largest Hertzian pressure equals the
        yield pressure p_y of the weaker body (Johnson, Contact Mechanics, 1985, sec. 6.1). For
        cylinders, the mean pressure at yield is 1.5 sigma_Y, with the yield strength sigma_Y (Katta
        & Polycarpou 2010, J. Tribol. 132:041402). All laws for the same shape have the same yield
        overlap. Nevertheless, the force of a law may leave the elastic curve at a smaller or larger
        overlap.

        Raises:
            ValueError: The contact of a cylinder at yield is too large for the thickness of the
                body.
        """
        return self._yield()[1]

    @property
    def yield_force(self) -> float:
        """Force at `yield_overlap` [N]; infinite for a law without yield.

        The yield force is pi^3 p_y^3 R*^2/(6 E*^2) for spheres, and 36 sigma_Y^2 R* L/(pi E*) for
        cylinders of length L. The docstring of `yield_overlap` defines the other symbols and gives
        the sources and exceptions.
        """
        return self._yield()[0]

    @property
    def yield_speed(self) -> float:
        """Closing speed v_y of a central impact that just reaches `yield_overlap` [m/s].

        The yield speed follows from 1/2 m* v_y^2 = W_y, where W_y is the elastic work up to yield.
        For spheres, W_y is 2/5 of the product of `yield_force` and `yield_overlap`. For a law
        without yield, the yield speed is infinite.

        Source: Thornton 1997, J. Appl. Mech. 64:383, eq. 22.

        Raises:
            ValueError: No body has a mass; or as for `yield_overlap`.
        """
        return sqrt(2 * self._yield()[2] / self.mass_eff)

    @property
    def sticking_speed(self) -> float:
        """Largest closing speed of a central impact at which the bodies stick [m/s].

        The sticking speed is 0 for a law without adhesion, and if the bodies rebound at all speeds
        above 1e-6 m/s. For the law `jkr`, `plastigran.physics.adhesion.jkr_sticking_speed` is the
        closed form of the sticking speed.

        Raises:
            ValueError: The bodies still stick at the highest speed that can be computed, at most
                100 m/s; or no body has a mass.
        """
        if not self.law.adhesive:
            return 0.0
        return float(sticking_speed(self.law, self.radius_eff, self.mass_eff))

    def _yield(self) -> tuple[float, float, float]:
        """Return force [N], overlap [m] and work [J] at yield."""
        if not self.law.yields:
            return inf, inf, inf
        if self.law.shape == "sphere":
            return central.sphere_yield(self.pair, self.radius_eff)
        lengths = (self._constants[name] for name in ("cylinder_length", "body_thickness"))
        return central.line_yield(self.pair, self.radius_eff, *lengths)

    def _warn(self, name: str, unit: str, outside: np.ndarray) -> None:
        if outside.size:
            warnings.warn(
                f"{name} {outside.min():.3g} {unit} exceeds the validity range of law "
                f"{self.law.name}, which ends at an overlap of {self.overlap_range:.3g} m "
                f"({self.law.range})",
                RangeWarning,
                stacklevel=3,
            )

    def impact(self, speeds: ArrayLike) -> laws.ImpactOutcome:
        """Compute central impacts.

        Args:
            speeds: Closing speeds [m/s], a number or an array. The results have the same shape.

        Raises:
            ValueError: A speed is out of range, or no body has a mass.
        """
        return self.law.central_impact(self.radius_eff, self.mass_eff, speeds)

    def oblique_impact(self, speeds: ArrayLike, angles: ArrayLike) -> ObliqueOutcome:
        """Compute oblique impacts with friction, for bodies that do not spin before the impact.

        Args:
            speeds: Relative speeds of the bodies before the impact [m/s].
            angles: Angles between the relative velocity and the normal, 0 or more and below 90
                [degrees]. Speeds and angles broadcast together.

        Raises:
            ValueError: A value is out of range, no body has a mass, or the law does not support
                oblique impacts.

        Warns:
            RangeWarning: The overlap exceeds the range of the law.
        """
        if self.law.shape != "sphere" or self.law.adhesive:
            raise ValueError(
                f"law {self.law.name}: oblique impacts need a law for spheres without adhesion"
            )
        speeds, angles = np.broadcast_arrays(
            np.asarray(speeds, dtype=float), np.asarray(angles, dtype=float)
        )
        wrong = angles[~((angles >= 0) & (angles < 90))]
        if wrong.size:
            raise ValueError(f"angle is {wrong[0]:g}; it must be 0 or more and below 90 degrees")
        closing = speeds * np.cos(np.radians(angles))
        outcome = self.impact(closing)
        self._warn("normal speed", "m/s", closing[~np.asarray(outcome.in_range)])
        mass = self._mass(self._bodies[0], self._radii[0])
        torque_arm = self._radii[0] * (self.mass_eff if mass == inf else mass)

        def compute(law: laws.Law, speeds: np.ndarray, angles: np.ndarray) -> ObliqueOutcome:
            bodies = self.radius_eff, self.mass_eff, torque_arm
            return oblique_impacts(law, self.tangential, *bodies, speeds, angles)

        flat = speeds.ravel(), angles.ravel()
        if self.pair.rate_coefficient:  # the yield strength depends on the impact speed
            parts = [
                compute(self.law.at_impact(self.radius_eff, float(rate)), *np.atleast_1d(*impact))
                for rate, *impact in zip(closing.ravel(), *flat, strict=True)
            ]
        else:
            parts = [compute(self.law, *flat)]
        values = [
            np.concatenate([getattr(part, field.name) for part in parts]).reshape(speeds.shape)
            for field in attrs.fields(ObliqueOutcome)
        ]
        return ObliqueOutcome(*values)

    def restitution(self, speeds: ArrayLike) -> float | np.ndarray:
        """Return the coefficient of restitution of central impacts [-].

        Args:
            speeds: Closing speeds [m/s], a number or an array. The result has the same shape.

        Raises:
            ValueError: A speed is out of range, or no body has a mass.

        Warns:
            RangeWarning: The overlap at a speed exceeds the range of the law.
        """
        outcome = self.impact(speeds)
        self._warn("speed", "m/s", np.asarray(speeds)[~np.asarray(outcome.in_range)])
        return outcome.coefficient_of_restitution

    def timestep(self, speed: ArrayLike) -> float | np.ndarray:
        """Return the time step [s] at which the coefficient of restitution has an error of 1e-3.

        Args:
            speed: Closing speeds [m/s], of any shape; the result has the same shape.

        Raises:
            ValueError: A speed is out of range, or no body has a mass.
        """
        return self.law.recommended_timestep(self.radius_eff, self.mass_eff, speed)

    def __repr__(self) -> str:
        a, b = (_name(body) for body in self._bodies)
        values: dict[str, Any] = {"radius": self._radii[0]}
        if self._radii[1] != inf:
            values["radius_other"] = self._radii[1]
        if self._mass_eff is not None:
            values["mass_eff"] = self._mass_eff
        if self.tangential.coefficient_of_friction:
            values["friction"] = self.tangential.coefficient_of_friction
        if self.tangential.name != "partial_slip":
            values["tangential"] = self.tangential.name
        elif isinstance(self.tangential, laws.PartialSlip) and self.tangential.rings != 4:
            values["rings"] = self.tangential.rings
        values |= self._constants
        arguments = ", ".join(f"{name}={value!r}" for name, value in values.items())
        return f"Contact({self.law.name!r}, {a}, {b}, {arguments})"


def _read_body(name: str, body: Bodylike) -> Material | laws.Body:
    if isinstance(body, laws.Body):
        return body
    if isinstance(body, Material | str | Path):
        return read_material(body)
    raise ValueError(
        f"{name} is {body!r}; it must be a Material, the name or file of a material, or RIGID"
    )


def _properties(body: Material | laws.Body) -> laws.Body:
    return body.body() if isinstance(body, Material) else body


def _name(body: Material | laws.Body) -> str:
    if body == RIGID:
        return "RIGID"
    return body.name if isinstance(body, Material) else repr(body)
