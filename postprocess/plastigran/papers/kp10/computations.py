# SPDX-License-Identifier: GPL-2.0-or-later
"""Finite-element and LIGGGHTS computations of a cylinder on glass (Katta & Polycarpou 2010)."""

from __future__ import annotations

from functools import partial
from tempfile import TemporaryDirectory

import attrs

from plastigran.experiments.collision import CollisionOutcome
from plastigran.experiments.cylinder import CylinderImpact
from plastigran.experiments.cylinder.study import BODY_THICKNESS, MASS, MATERIAL
from plastigran.experiments.runs import sweep
from plastigran.fem.cache import cached
from plastigran.fem.cylinder.case import CylinderStrike
from plastigran.fem.cylinder.strike import strike
from plastigran.fem.cylinder.struck import Strike
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings
from plastigran.materials import read_material
from plastigran.report.computing import compute_all
from plastigran.usable_laws import laws_for

RADIUS = 1e-5
GLASS = read_material(MATERIAL)
#: Body with the combined elasticity of glass and slider, as in the material file of the glass.
BODY = ElasticPlastic(
    youngs_modulus=GLASS.youngs_modulus,
    poissons_ratio=GLASS.poissons_ratio,
    density=GLASS.density,
    hardening=LinearHardening(GLASS.yield_strength),
)
#: Body with the elasticity of the glass alone. In contact with a slider of 388 GPa and Poisson's
#: ratio 0.22, it has the reduced modulus E_r of the paper.
GLASS_ALONE = attrs.evolve(BODY, youngs_modulus=1.001e11)
FRICTION = 0.15
SLIDING_SPEED = 10.0

#: Impact speeds [m/s] by length/radius.
SPEEDS = {10.0: (0.2, 0.4, 0.6, 0.8, 1.0), 100.0: (1.0, 2.0, 3.0, 4.0, 5.0)}
OBLIQUE_SPEEDS = {10.0: (1.0, 0.6), 100.0: (3.0,)}
#: Impact for which the paper states residual depths: length/radius, speed [m/s].
SHOWN = (10.0, 1.0)
LAWS = tuple(laws_for("cylinder"))
HEAD_ON = Settings(divisions=4, steps_of_contact=120)
#: Coarser resolution for oblique impacts. Their computation takes ten times as long as for head-on
#: impacts, because the whole track of the sliding cylinder needs a fine mesh.
OBLIQUE = Settings(divisions=3, fineness=0.6, steps_of_contact=40)
COARSE = Settings(divisions=2, fineness=0.5, steps_of_contact=20)


@attrs.frozen(order=True)
class Case:
    """Impact of the cylinder by finite elements.

    Attributes:
        length_ratio: Length / radius of the cylinder [-].
        speed: Impact speed [m/s].
        direction: "head-on" or "oblique".
        body: Body that is hit: "layer" (100 µm thick), "thick" (a body without reflected waves),
            "thin" (half the thickness of the layer) or "glass" (the layer without the elasticity of
            the slider).
        mesh: "usual" or "coarse".
    """

    length_ratio: float
    speed: float
    direction: str = "head-on"
    body: str = "layer"
    mesh: str = "usual"

    def settings(self) -> Settings:
        """Return the resolution of the computation."""
        if self.mesh == "coarse":
            return COARSE
        return OBLIQUE if self.direction == "oblique" else HEAD_ON

    def strike(self) -> CylinderStrike:
        """Return the impact as an input of the finite-element program."""
        sliding = self.direction == "oblique"
        thickness = {"thick": None, "thin": BODY_THICKNESS / 2}.get(self.body, BODY_THICKNESS)
        return CylinderStrike(
            material=GLASS_ALONE if self.body == "glass" else BODY,
            radius=RADIUS,
            length=self.length_ratio * RADIUS,
            mass=MASS,
            speed=self.speed,
            sliding_speed=SLIDING_SPEED if sliding else 0.0,
            coefficient_of_friction=FRICTION if sliding else 0.0,
            thickness=thickness,
        )


@attrs.frozen
class Computed:
    """Computed data of the tables and figures of this paper.

    Attributes:
        strikes: Finite-element results by case.
        runs: LIGGGHTS results of head-on impacts, by length/radius, speed and law.
    """

    strikes: dict[Case, Strike]
    runs: dict[tuple[float, float, str], CollisionOutcome]


def cases(coarse: bool) -> list[Case]:
    """Return the impacts to compute; the longest computations come first."""
    shown = [Case(*SHOWN, "oblique"), Case(*SHOWN)]
    if coarse:
        return [*shown, Case(*SHOWN, body="thick")]
    head_on = [(ratio, speed) for ratio, speeds in SPEEDS.items() for speed in speeds]
    return [
        *(
            Case(ratio, speed, "oblique")
            for ratio, speeds in OBLIQUE_SPEEDS.items()
            for speed in speeds
        ),
        *(Case(*impact, body=body) for body in ("thick", "layer") for impact in head_on),
        *(attrs.evolve(case, mesh="coarse") for case in shown),
        *(Case(*SHOWN, body=body) for body in ("glass", "thin")),
    ]


def compute(progress: bool, coarse: bool) -> Computed:
    """Compute all results, or read them from the cache; arguments as for `Evidence.run`."""
    strikes = compute_all(
        {
            case: partial(
                cached, strike, case.strike(), settings=COARSE if coarse else case.settings()
            )
            for case in cases(coarse)
        },
        progress,
    )
    impacts = sorted({(c.length_ratio, c.speed) for c in strikes if c.direction == "head-on"})
    experiments = [
        CylinderImpact(law, speed, MATERIAL, RADIUS, length_ratio=ratio)
        for ratio, speed in impacts
        for law in LAWS
    ]
    with TemporaryDirectory() as folder:
        outcomes = sweep(experiments, folder, progress=progress).outcomes
    return Computed(
        strikes,
        {(case.length_ratio, case.speed, case.law): run for case, run in outcomes.items()},
    )
