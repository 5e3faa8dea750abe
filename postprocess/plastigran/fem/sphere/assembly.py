# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes, bodies and contact of a sphere on a plane or a half space."""

from __future__ import annotations

from plastigran.fem.body.body import Body
from plastigran.fem.body.pair import Pair
from plastigran.fem.contact.half_space import HalfSpace
from plastigran.fem.contact.plane import RigidPlane
from plastigran.fem.settings import Settings
from plastigran.fem.stepping.increment import Equations
from plastigran.fem.theory.hertz import HertzSphere

BASE_OVER_REACH = 2000.0  # a held base at D leaves 0.4 a/D of the approach out
BASE_OVER_WAY = 0.6  # of a compression wave within Hertz' duration: it comes back too late


def pressed(sphere: HertzSphere, reach: float, settings: Settings) -> Equations:
    """Half of a sphere, held at its equator.

    Args:
        sphere: The sphere, and the plane.
        reach: Largest contact radius to expect, m.
        settings: How fine.

    Raises:
        ValueError: Finite strain on a half space.
    """
    return _assemble(sphere, reach, settings, BASE_OVER_REACH * reach, whole=False)


def thrown(sphere: HertzSphere, reach: float, speed: float, settings: Settings) -> Equations:
    """A whole sphere, that meets the plane with `speed`, m/s; the rest as of `pressed`."""
    size = 0.0
    if sphere.plane is not None:
        size = BASE_OVER_WAY * sphere.plane.wave_speed * sphere.duration(speed)
    return _assemble(sphere, reach, settings, max(size, BASE_OVER_REACH * reach), whole=True)


def _assemble(
    sphere: HertzSphere, reach: float, settings: Settings, size: float, whole: bool
) -> Equations:
    if sphere.plane is not None and settings.strain != "small":
        raise ValueError(
            f"strain is {settings.strain}; on a half space it must be small, for there the "
            "surfaces may not slide far"
        )
    mesh = settings.mesh(sphere, reach, whole).build()
    body = Body(mesh, sphere.material, kinematics=settings.kinematics)
    seen = min(2 * reach, 0.9 * sphere.radius)
    if sphere.plane is None:
        return Equations(body, RigidPlane(body, sphere.radius, seen, settings.penalty))
    pair = Pair(body, Body(settings.block(sphere, reach, size).build(), sphere.plane))
    return Equations(pair, HalfSpace(pair, sphere.radius, seen, settings.penalty))
