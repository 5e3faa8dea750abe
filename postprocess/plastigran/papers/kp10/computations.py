# SPDX-License-Identifier: GPL-2.0-or-later
"""Finite elements and LIGGGHTS runs of the paper's cylinder."""

from __future__ import annotations

from tempfile import TemporaryDirectory

import attrs

from plastigran.experiments.collision import CollisionOutcome
from plastigran.experiments.cylinder import CylinderImpact
from plastigran.experiments.cylinder.study import BODY_THICKNESS, MASS, MATERIAL
from plastigran.experiments.runs import sweep
from plastigran.fem.cylinder.case import CylinderStrike
from plastigran.fem.cylinder.strike import strike
from plastigran.fem.cylinder.struck import Strike
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings
from plastigran.materials import read_material
from plastigran.report.computing import Computation, compute_all
from plastigran.usable_laws import laws_for

RADIUS = 1e-5
GLASS = read_material(MATERIAL)
#: Combined elasticity of both bodies, as in the material file.
BODY = ElasticPlastic(
    youngs_modulus=GLASS.youngs_modulus,
    poissons_ratio=GLASS.poissons_ratio,
    density=GLASS.density,
    hardening=LinearHardening(GLASS.yield_strength),
)
#: Glass alone: with a slider of 388 GPa and Poisson's ratio 0.22 it has the paper's E_r.
GLASS_ALONE = attrs.evolve(BODY, youngs_modulus=1.001e11)
FRICTION = 0.15
SLIDING_SPEED = 10.0

#: Impact speeds [m/s] by length/radius.
SPEEDS = {10.0: (0.2, 0.4, 0.6, 0.8, 1.0), 100.0: (1.0, 2.0, 3.0, 4.0, 5.0)}
OBLIQUE_SPEEDS = {10.0: (1.0, 0.6), 100.0: (3.0,)}
#: Impact whose residual depths the paper gives: length/radius, speed [m/s].
SHOWN = (10.0, 1.0)
LAWS = tuple(laws_for("cylinder"))
HEAD_ON = Settings(divisions=4, steps_of_contact=120)
#: An oblique impact takes ten times as long to compute, because its whole track has a fine mesh.
OBLIQUE = Settings(divisions=3, fineness=0.6, steps_of_contact=40)
COARSE = Settings(divisions=2, fineness=0.5, steps_of_contact=20)
KINDS = {"normal": "head-on", "oblique": "oblique"}  # key and word in tables


@attrs.frozen(order=True)
class Key:
    """Identity of one computation.

    `body` is "layer", "thick" (without wave reflection), "thin" (half the layer) or "glass"
    (alone).
    `kind` is "normal" or "oblique", `mesh` is "usual" or "coarse".
    """

    length_ratio: float
    speed: float
    kind: str = "normal"
    body: str = "layer"
    mesh: str = "usual"

    def settings(self) -> Settings:
        """Resolution of the computation."""
        if self.mesh == "coarse":
            return COARSE
        return OBLIQUE if self.kind == "oblique" else HEAD_ON

    def case(self) -> CylinderStrike:
        """Impact to compute."""
        thickness = {"thick": None, "thin": BODY_THICKNESS / 2}.get(self.body, BODY_THICKNESS)
        return CylinderStrike(
            material=GLASS_ALONE if self.body == "glass" else BODY,
            radius=RADIUS,
            length=self.length_ratio * RADIUS,
            mass=MASS,
            speed=self.speed,
            sliding_speed=SLIDING_SPEED if self.kind == "oblique" else 0.0,
            coefficient_of_friction=FRICTION if self.kind == "oblique" else 0.0,
            thickness=thickness,
        )


@attrs.frozen
class Computed:
    """Data of the tables and figures.

    Attributes:
        strikes: Finite-element results.
        runs: LIGGGHTS results, by length/radius, speed and law; head-on.
    """

    strikes: dict[Key, Strike]
    runs: dict[tuple[float, float, str], CollisionOutcome]


def keys(coarse: bool) -> list[Key]:
    """Return the computations, the longest first."""
    shown = [Key(*SHOWN, "oblique"), Key(*SHOWN)]
    if coarse:
        return [*shown, Key(*SHOWN, body="thick")]
    found = [
        Key(ratio, speed, "oblique") for ratio, speeds in OBLIQUE_SPEEDS.items() for speed in speeds
    ]
    for body in ("thick", "layer"):
        found += [
            Key(ratio, speed, body=body) for ratio, speeds in SPEEDS.items() for speed in speeds
        ]
    found += [attrs.evolve(key, mesh="coarse") for key in shown]
    return [*found, Key(*SHOWN, body="glass"), Key(*SHOWN, body="thin")]


def compute_finite_elements_and_runs(progress: bool, coarse: bool) -> Computed:
    """Compute `Computed`, or read it from the cache; arguments as for `Report.run`."""
    strikes = compute_all(
        {
            key: Computation(strike, (key.case(),), COARSE if coarse else key.settings())
            for key in keys(coarse)
        },
        progress,
    )
    head_on = sorted({(key.length_ratio, key.speed) for key in strikes if key.kind == "normal"})
    cases = [
        CylinderImpact(law, speed, MATERIAL, RADIUS, length_ratio=ratio)
        for ratio, speed in head_on
        for law in LAWS
    ]
    with TemporaryDirectory() as folder:
        outcomes = sweep(cases, folder, progress=progress).outcomes
    return Computed(
        strikes,
        {(case.length_ratio, case.speed, case.law): found for case, found in outcomes.items()},
    )
