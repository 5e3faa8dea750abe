# SPDX-License-Identifier: GPL-2.0-or-later
"""Finite-element and LIGGGHTS computations of the sphere of Zhang & Vu-Quoc (2002)."""

from __future__ import annotations

from functools import partial
from math import pi

import attrs
from skfem import MeshQuad2

from plastigran import laws
from plastigran.experiments.collision import CollisionOutcome
from plastigran.experiments.runs import Runs
from plastigran.fem.cache import cached
from plastigran.fem.limits import force_of_impact
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.press import press
from plastigran.fem.sphere.results import Pressing, Throw
from plastigran.fem.sphere.throw import throw
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.materials import RIGID, read_material
from plastigran.papers.base import run_impacts
from plastigran.report.computing import compute_all

RADIUS = 0.1
MATERIAL = read_material("aluminium_zv02")
ELASTIC = ElasticPlastic(
    youngs_modulus=MATERIAL.youngs_modulus,
    poissons_ratio=MATERIAL.poissons_ratio,
    density=MATERIAL.density,
)
METAL = attrs.evolve(ELASTIC, hardening=LinearHardening(MATERIAL.yield_strength))
SPHERE = HertzSphere(METAL, RADIUS)
PAIR = laws.combine(MATERIAL.body(), RIGID)
MASS = 4 / 3 * pi * RADIUS**3 * MATERIAL.density

#: Impact speeds [m/s]: three speeds of the paper, and 0.06 m/s.
SPEEDS = (0.20, 0.10, 0.06, 0.02)
#: Speeds of the impacts that the paper computes without plastic flow [m/s].
ELASTIC_SPEEDS = (0.02, 0.10)
#: Impact speed in the movie [m/s].
SHOWN = 0.10
#: Largest forces of the quasi-static compressions [N]: just above the yield force, the loads of the
#: paper, and the largest force of its fastest impact.
FORCES = (40.0, 100.0, 500.0, 1500.0, 3000.0, 8375.0)
#: Force up to which the paper fits the constants of its law [N], 41 times the yield force.
CALIBRATION_FORCE = 1500.0
#: Laws of the paper, and the two laws that are closest to finite elements.
LAWS = ("vu_quoc_zhang", "thornton", "stronge", "kogut_etsion", "jackson_green")


@attrs.frozen
class Computed:
    """Computed data of the tables and figures of this paper.

    Attributes:
        impacts: Finite-element impacts with plastic flow, by speed.
        elastic_impacts: Finite-element impacts without plastic flow, by speed.
        pressing: Quasi-static compression to each of `FORCES`.
        elastic_pressing: Compression to each of `FORCES` without plastic flow.
        fit: Compression to `CALIBRATION_FORCE`, from which the constants of the law are fitted.
        onset: Compression to just above the yield force in small steps, on a finer mesh.
        mesh: Mesh of the impact at `SHOWN`.
        runs: LIGGGHTS runs with each of `LAWS` and with Hertz, at every speed.
    """

    impacts: dict[float, Throw]
    elastic_impacts: dict[float, Throw]
    pressing: Pressing
    elastic_pressing: Pressing
    fit: Pressing
    onset: Pressing
    mesh: MeshQuad2
    runs: Runs

    def run(self, law: str, speed: float) -> CollisionOutcome:
        """Return the LIGGGHTS run with a law at an impact speed [m/s]."""
        outcomes = self.runs.outcomes
        return next(o for case, o in outcomes.items() if (case.law, case.speed) == (law, speed))


def compute(progress: bool, coarse: bool) -> Computed:
    """Compute all results, or read them from the cache; arguments as for `Evidence.run`."""
    usual, frames = Settings(), 50
    if coarse:
        usual, frames = Settings(divisions=4, fineness=0.5, growth=1.15, steps_of_contact=80), 12
    # Continue the computation for two periods of the fundamental mode after the contact.
    long = attrs.evolve(usual, free_steps=usual.steps_of_contact // 4, frames=frames)
    fine = attrs.evolve(usual, divisions=2 * usual.divisions, growth=1.002, unloading_steps=8)
    speeds = (SHOWN, 0.02) if coarse else SPEEDS
    forces = list(FORCES[:4] if coarse else FORCES)
    computations = {
        **{("impact", v): partial(cached, throw, METAL, RADIUS, v, settings=long) for v in speeds},
        "pressing": partial(cached, press, METAL, RADIUS, forces, settings=usual),
        **{
            ("elastic", v): partial(cached, throw, ELASTIC, RADIUS, v, settings=usual)
            for v in ELASTIC_SPEEDS
        },
        "elastic_pressing": partial(cached, press, ELASTIC, RADIUS, forces, settings=usual),
        "fit": partial(cached, press, METAL, RADIUS, [CALIBRATION_FORCE], settings=usual),
        "onset": partial(cached, press, METAL, RADIUS, [1.04 * SPHERE.yield_force], settings=fine),
    }
    results = compute_all(computations, progress)
    return Computed(
        impacts={v: results.pop(("impact", v)) for v in sorted(speeds)},
        elastic_impacts={v: results.pop(("elastic", v)) for v in ELASTIC_SPEEDS},
        mesh=usual.mesh(SPHERE, force_of_impact(SPHERE, SHOWN)[1], whole=True).build(),
        runs=run_impacts([*LAWS, "hertz"], sorted(speeds), MATERIAL, RADIUS),
        **results,
    )
