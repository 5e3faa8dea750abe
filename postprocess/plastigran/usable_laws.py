# SPDX-License-Identifier: GPL-2.0-or-later
"""Selection of the contact laws that suit the shape of the bodies and the given materials."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from itertools import chain

from plastigran import laws
from plastigran.materials import (
    Material,
    can_adhere,
    has_constants,
    has_surface_energy,
    law_class,
)


def laws_for(shape: str, bodies: Iterable[Material] = ()) -> list[str]:
    """Return the names of the laws for bodies of a shape, "sphere" or "cylinder".

    The result omits laws with constants that no material can define, such as stiffnesses that the
    user must choose. It also omits laws with adhesion, unless the materials have a surface energy.

    Args:
        shape: Shape of the bodies.
        bodies: Materials. A law is omitted if a material lacks a constant that the law needs.
    """
    bodies = list(bodies)
    names = [
        name
        for name, law in laws.LAWS.items()
        if law.shape == shape and has_constants(name) and (bodies or not law.adhesive)
    ]
    return [name for name in sorted(names) if not any(body.missing(name) for body in bodies)]


def choose_laws(names: Iterable[str], shape: str, bodies: Iterable[Material] = ()) -> list[str]:
    """Return names of laws without repetitions; "all" stands for the laws of `laws_for`.

    Raises:
        ValueError: A law does not exist.

    Warns:
        UserWarning: "all" omits a law, because the material lacks its constants.
    """
    names, usable = list(names), laws_for(shape, bodies)
    for name in names:
        if name != "all":
            law_class(name)
    omitted = sorted(set(laws_for(shape)) - set(usable) - set(names))
    if "all" in names and omitted:
        warnings.warn(
            "some laws are left out, because the material does not define their constants: "
            + ", ".join(omitted),
            stacklevel=2,
        )
    chosen = (usable if name == "all" else [name] for name in names)
    return list(dict.fromkeys(chain.from_iterable(chosen)))


def warn_of_idle_surface_energy(names: Iterable[str], bodies: Iterable[Material]) -> None:
    """Warn if a material has a surface energy that laws do not use.

    Args:
        names: Names of the laws in use. The user has given no surface energy for them.
        bodies: Materials.

    Warns:
        UserWarning: A surface energy has no effect; the message names the material and its value.
    """
    idle = list(dict.fromkeys(name for name in names if not has_surface_energy(name)))
    for body in dict.fromkeys(bodies):
        if idle and body.surface_energy:
            value = f"{body.surface_energy:.6g}"
            remedy = (
                f"Give --surface-energy {value} to switch on adhesion in laws that support it"
                if any(map(can_adhere, idle))
                else "Use a law with adhesion (docs/adhesion.md)"
            )
            warnings.warn(
                f"surface_energy of material {body.name} is {value} J/m2, but has no effect in "
                f"{', '.join(idle)}. {remedy}",
                stacklevel=2,
            )
