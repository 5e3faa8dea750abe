# SPDX-License-Identifier: GPL-2.0-or-later
"""A random scene: bodies, materials, walls, ranks, and events between runs."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import product
from math import pi

import numpy as np
from events import AXES, CREATED_RADIUS, Event, random_events

from plastigran import laws
from plastigran.laws import Body
from plastigran.usable_laws import laws_for

#: Limit of overlap / smallest radius for an impact with the smallest radius and the largest mass of
#: the scene. The initial speeds are reduced until impacts are below this limit. Overlaps are larger
#: if several particles press on one particle. The plugin stops the run at an overlap / radius of 1.
DEEPEST = 0.6


@dataclass(frozen=True)
class Scene:
    """Input of a deck and of its replay, which follows from the seed alone.

    Attributes:
        seed: Seed of the random numbers.
        law_name: Name of the contact law.
        options: Options and constants of the law.
        bodies: Body of each atom type.
        densities: Density of each atom type [kg/m3].
        radius, types, positions, velocities: Arrays over the particles [m, -, m, m/s].
        low, high: Corners of the box [m].
        walled: Axes with walls at both ends; the others are periodic.
        wall_type: Atom type of the walls.
        meshed: Whether the lower z wall is a mesh of triangles; all sides then have walls.
        timestep: Time step [s].
        sort: Number of steps between sorts of particles in memory; 0 for never.
        events: Events, each followed by a run; the first event does nothing.
    """

    seed: int
    law_name: str
    options: dict[str, object]
    bodies: list[Body]
    densities: np.ndarray
    radius: np.ndarray
    types: np.ndarray
    positions: np.ndarray
    velocities: np.ndarray
    low: np.ndarray
    high: np.ndarray
    walled: str
    wall_type: int
    meshed: bool
    timestep: float
    sort: int
    events: list[Event] = field(repr=False)

    def law(self, one: int, other: int) -> laws.Law:
        """Return the law between two atom types."""
        pair = laws.combine(self.bodies[one - 1], self.bodies[other - 1])
        return laws.LAWS[self.law_name](pair, **self.options)


def random_scene(seed: int) -> Scene:
    """Return the scene of a seed, in which particles approach each other."""
    random = np.random.default_rng(seed)
    law_name = str(random.choice([n for n in laws_for("sphere") if _in_engine(laws.LAWS[n])]))
    law = laws.LAWS[law_name]
    options = {o["name"]: str(random.choice(o["choices"])) for o in law.options()}
    if law.rate_dependent:
        options["dissipative_constant"] = float(10 ** random.uniform(-7, -5))
    rate = law.yields and law_name not in INTERPOLATED
    bodies = [_body(random, law.yields, rate) for _ in range(random.integers(1, 4))]
    densities = 10 ** random.uniform(2.7, 4, len(bodies))
    count = random.integers(2, 15)
    radius = random.uniform(CREATED_RADIUS, 0.09, count)
    types = random.integers(1, len(bodies) + 1, count)
    speed = 10 ** random.uniform(-1, 1.3)
    between = [
        (law(laws.combine(bodies[i], bodies[j]), **options), min(densities[i], densities[j]))
        for i, j in product(range(len(bodies)), repeat=2)
    ]
    while _deepest(between, densities.max(), radius, 2 * speed) > DEEPEST * radius.min():
        speed /= 2
    timestep = _timestep(between, radius.min(), 2 * speed)
    gap = 30 * speed * timestep  # a gap of this size closes in about 30 steps
    positions = _cluster(random, radius, gap)
    inward = positions.mean(axis=0) - positions
    inward /= np.linalg.norm(inward, axis=1, keepdims=True)
    walled = "".join(axis for axis in AXES if random.random() < 0.6)
    low, high = _box(random, positions, radius, walled, gap)
    return Scene(
        seed=seed,
        law_name=law_name,
        options=options,
        bodies=bodies,
        densities=densities,
        radius=radius,
        types=types,
        positions=positions,
        velocities=speed * (inward + 0.7 * random.standard_normal((count, 3))),
        low=low,
        high=high,
        walled=walled,
        wall_type=int(random.integers(1, len(bodies) + 1)),
        meshed=bool(random.random() < 0.5) and walled == AXES,
        timestep=timestep,
        sort=int(random.choice([0, 1, 1000])),
        events=list(random_events(random, positions, radius, low, high, walled, gap)),
    )


#: Laws for which the plugin interpolates the response at a rate factor (docs/rate_factor.md), while
#: the Python module computes the exact response.
INTERPOLATED = {"universal", "mdr", "jackson_green", "ghaednia", "ghaednia_2019"}
INTERPOLATED |= {"kogut_komvopoulos", "ye_komvopoulos"}


def _in_engine(law: type[laws.Law]) -> bool:
    return law.shape == "sphere" and law.name != "hertz"  # LIGGGHTS has its own `hertz`


def _body(random: np.random.Generator, yields: bool, rate: bool) -> Body:
    modulus = 10 ** random.uniform(7, 11.5)
    strength = modulus * 10 ** random.uniform(-3.5, -2) if yields else float("inf")
    return Body(
        modulus,
        random.uniform(0, 0.45),
        strength,
        yield_pressure_factor=float(random.choice([0, 1.3, 1.61])),
        tangent_modulus=modulus * float(random.choice([0, 0.01, 0.05])),
        rate_coefficient=float(random.choice([0, 0, 0.014, 0.05])) if rate else 0.0,
    )


def _deepest(
    between: list[tuple[laws.Law, float]], density: float, radius: np.ndarray, speed: float
) -> float:
    """Return the largest overlap [m] for the largest mass and the smallest radius of a scene."""
    mass = 4 / 3 * pi * radius.max() ** 3 * density / 2
    impacts = (law.central_impact(radius.min() / 2, mass, speed) for law, _ in between)
    return max(float(impact.overlap_max) for impact in impacts)


def _timestep(between: list[tuple[laws.Law, float]], smallest: float, speed: float) -> float:
    """Return a third of the time step that the stiffest possible impact needs [s]."""
    volume = 4 / 3 * pi * smallest**3
    steps = (
        law.recommended_timestep(smallest / 2, volume * density / 2, speed)
        for law, density in between
    )
    return float(min(steps)) / 3


def _cluster(random: np.random.Generator, radius: np.ndarray, gap: float) -> np.ndarray:
    """Return centers [m] such that each particle is within `gap` of another and touches none."""
    places = [np.zeros(3)]
    while len(places) < len(radius):
        k, near = len(places), random.integers(len(places))
        away = random.standard_normal(3)
        away *= (radius[k] + radius[near] + gap * random.random()) / np.linalg.norm(away)
        apart = np.linalg.norm(np.array(places) - places[near] - away, axis=1)
        if (apart > radius[:k] + radius[k]).all():
            places.append(places[near] + away)
    return np.array(places)


def _box(
    random: np.random.Generator, positions: np.ndarray, radius: np.ndarray, walled: str, gap: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners [m]; periodic sides exceed twice the range of the neighbor lists."""
    low = (positions - radius[:, None]).min(axis=0) - gap * random.random(3)
    high = (positions + radius[:, None]).max(axis=0) + gap * random.random(3)
    periodic = np.array([axis not in walled for axis in AXES])
    return low, np.where(periodic, np.maximum(high, low + 0.5), high)
