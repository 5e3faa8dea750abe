# SPDX-License-Identifier: GPL-2.0-or-later
"""Laws for bodies of a shape and the constants of materials."""

from __future__ import annotations

import warnings
from collections.abc import Iterable

from plastigran import laws
from plastigran.materials import Material, has_constants


def laws_for(shape: str, bodies: Iterable[Material] = ()) -> list[str]:
    """Return the names of the laws for bodies of a shape, "sphere" or "cylinder".

    Laws with constants that no material can have, such as the surface energy of two bodies, are
    left out.

    Args:
        shape: Shape of the bodies.
        bodies: Materials; laws that need a constant that one of them lacks are left out.
    """
    bodies = list(bodies)
    fitting = [
        name for name, law in laws.LAWS.items() if law.shape == shape and has_constants(name)
    ]
    return [name for name in sorted(fitting) if not any(body.missing(name) for body in bodies)]


def choose_laws(given: Iterable[str], shape: str, bodies: Iterable[Material] = ()) -> list[str]:
    """Return names of laws, each once; "all" means those of `laws_for`.

    Raises:
        ValueError: A law does not exist.

    Warns:
        UserWarning: "all" leaves out a law, because the material lacks its constants.
    """
    given, usable = list(given), laws_for(shape, bodies)
    for name in given:
        if name not in laws.LAWS and name != "all":
            raise ValueError(f"no law {name!r}; there are {', '.join(sorted(laws.LAWS))}")
    left = sorted(set(laws_for(shape)) - set(usable) - set(given))
    if "all" in given and left:
        warnings.warn(
            f"left out, because the material lacks their constants: {', '.join(left)}", stacklevel=2
        )
    expanded = [usable if name == "all" else [name] for name in given]
    return list(dict.fromkeys(name for some in expanded for name in some))
