# SPDX-License-Identifier: GPL-2.0-or-later
"""Equations of a sphere on a plane or a half space: meshes, bodies and contact."""

from __future__ import annotations

from plastigran.fem.body.body import Body
from plastigran.fem.body.pair import Pair
from plastigran.fem.contact.half_space import HalfSpace
from plastigran.fem.contact.plane import RigidPlane
from plastigran.fem.settings import Settings
from plastigran.fem.stepping.increment import Equations
from plastigran.fem.theory.hertz import HertzSphere

# Radius D of the fixed base of the half space / contact radius a. Relative to an infinite half
# space, the base reduces the approach by the fraction 0.4 a/D.
BASE_OVER_REACH = 2000.0
# Radius of the base / distance that a compression wave travels during a Hertz contact. With this
# value, the reflected wave arrives after the contact has ended.
BASE_OVER_PATH = 0.6


def pressed(sphere: HertzSphere, reach: float, settings: Settings) -> Equations:
    """Return the equations of half a sphere, fixed at its equator, on a plane or half space.

    Args:
        sphere: Sphere and plane.
        reach: Largest expected contact radius, m.
        settings: Settings of mesh and contact.

    Raises:
        ValueError: Finite strain is chosen for a half space.
    """
    return _assemble(sphere, reach, settings, BASE_OVER_REACH * reach, whole=False)


def thrown(sphere: HertzSphere, reach: float, speed: float, settings: Settings) -> Equations:
    """Return the equations of a whole sphere for an impact at `speed`, m/s.

    The other arguments are those of `pressed`.
    """
    size = 0.0
    if sphere.plane is not None:
        size = BASE_OVER_PATH * sphere.plane.wave_speed * sphere.duration(speed)
    return _assemble(sphere, reach, settings, max(size, BASE_OVER_REACH * reach), whole=True)


def _assemble(
    sphere: HertzSphere, reach: float, settings: Settings, size: float, whole: bool
) -> Equations:
    if sphere.plane is not None and settings.strain != "small":
        raise ValueError(
            f"strain is {settings.strain}; on a half space it must be small. Use small strain or "
            "a rigid plane"
        )
    mesh = settings.mesh(sphere, reach, whole).build()
    body = Body(mesh, sphere.material, kinematics=settings.kinematics)
    contact_zone = min(2 * reach, 0.9 * sphere.radius)
    if sphere.plane is None:
        return Equations(body, RigidPlane(body, sphere.radius, contact_zone, settings.penalty))
    pair = Pair(body, Body(settings.block(sphere, reach, size).build(), sphere.plane))
    return Equations(pair, HalfSpace(pair, sphere.radius, contact_zone, settings.penalty))
