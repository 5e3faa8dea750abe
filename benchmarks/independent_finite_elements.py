#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compress a sphere with plastigran.fem and with FElupe, and print the differences.

    .venv/bin/pip install felupe==11.3.0     # the extra `independent` of this package
    .venv/bin/python benchmarks/independent_finite_elements.py small finite

The script takes some minutes on one core.

FElupe (GPL-3, by another author) has its own elements, assembly, contact at the nodes, Newton
method, and plasticity in small strain. In finite strain, this script defines the plasticity for
FElupe: F = F_e F_p with the exponential return mapping of Simo (1992, Comput. Methods Appl. Mech.
Eng. 99:61), and a tangent by finite differences. In plastigran.fem, the logarithmic strain is the
sum of an elastic and a plastic part. Both codes have the same mesh.
"""

from __future__ import annotations

import argparse
import warnings
from math import pi
from types import ModuleType

import attrs
import numpy as np
import pandas as pd

from plastigran.fem.limits import SmallStrainWarning, contact_reach
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.press import press
from plastigran.fem.theory.hertz import HertzSphere

RADIUS = 0.1  # radius of the sphere [m]
STEP = 1e-6  # relative step of the finite differences for the tangent
PENALTY = 10.0  # nodal contact force / (penetration * E* * circumference of the contact)
ALUMINIUM = ElasticPlastic(
    youngs_modulus=70e9, poissons_ratio=0.3, hardening=LinearHardening(100e6)
)
HARD = attrs.evolve(ALUMINIUM, hardening=LinearHardening(1e9))


@attrs.frozen
class Case:
    """Compression of a sphere, and its resolution.

    Attributes:
        material: Metal.
        force: Largest force, N.
        settings: Resolution of plastigran.fem.
    """

    material: ElasticPlastic
    force: float
    settings: Settings


SETTINGS = Settings(divisions=5, growth=1.04)
CASES = {
    "elastic": Case(attrs.evolve(ALUMINIUM, hardening=None), 1500.0, SETTINGS),
    "small": Case(ALUMINIUM, 1500.0, SETTINGS),
    "finite": Case(HARD, 1.5e6, attrs.evolve(SETTINGS, strain="finite")),
}


class FiniteMetal:
    """Von Mises plasticity without hardening, F = F_e F_p, with the methods of a FElupe material.

    The state is (F_p^T F_p)^-1 - I, with the unit tensor I, as nine numbers. It is zero before
    yield, because FElupe begins with zero states.
    """

    def __init__(self, material: ElasticPlastic) -> None:
        self.shear, self.bulk = material.shear_modulus, material.bulk_modulus
        self.strength = material.hardening.yield_strength

    def stress(self, x: list[np.ndarray], **_: object) -> list[np.ndarray]:
        """Return the first Piola-Kirchhoff stress, Pa, and the new state."""
        deformation, state = np.moveaxis(x[0], (0, 1), (-2, -1)), np.moveaxis(x[-1], 0, -1)
        stress, state = self._respond(deformation, state.reshape(*state.shape[:-1], 3, 3))
        state = state.reshape(*state.shape[:-2], 9)
        return [np.moveaxis(stress, (-2, -1), (0, 1)), np.moveaxis(state, -1, 0)]

    def elasticity(self, x: list[np.ndarray], **_: object) -> list[np.ndarray]:
        """Return dP/dF of the stress P and the deformation gradient F, by finite differences."""
        result = np.empty((3, 3, *x[0].shape))
        for row, column in np.ndindex(3, 3):
            change = np.zeros((3, 3, 1, 1))
            change[row, column] = STEP
            above, below = (self.stress([x[0] + s * change, x[-1]])[0] for s in (1, -1))
            result[:, :, row, column] = (above - below) / (2 * STEP)
        return [result]

    def _respond(self, deformation: np.ndarray, state: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        transposed = deformation.swapaxes(-1, -2)
        trial = deformation @ (np.eye(3) + state) @ transposed
        squares, vectors = np.linalg.eigh((trial + trial.swapaxes(-1, -2)) / 2)
        strain = np.log(squares) / 2
        volumetric = strain.sum(axis=-1, keepdims=True)
        deviator = 2 * self.shear * (strain - volumetric / 3)
        mises = np.sqrt(1.5 * (deviator**2).sum(axis=-1, keepdims=True))
        share = np.minimum(1, self.strength / np.maximum(mises, 1e-30))
        principal = self.bulk * volumetric + share * deviator
        elastic = volumetric / 3 + share * deviator / (2 * self.shear)

        def tensor(values: np.ndarray) -> np.ndarray:
            return (vectors * values[..., None, :]) @ vectors.swapaxes(-1, -2)

        inverse = np.linalg.inv(deformation)
        state = inverse @ tensor(np.exp(2 * elastic)) @ inverse.swapaxes(-1, -2) - np.eye(3)
        return tensor(principal) @ inverse.swapaxes(-1, -2), state


def by_felupe(case: Case, approaches: np.ndarray) -> np.ndarray:
    """Return the force [N] that FElupe computes for each approach of the plane [m]."""
    import felupe  # an optional dependency

    sphere = HertzSphere(case.material, RADIUS)
    reach = contact_reach(sphere, case.force)
    source = case.settings.mesh(sphere, reach, whole=False).build()
    corners, edges = source.t[:4].T, source.nvertices + source.t2f.T
    # In FElupe, the first coordinate is along the axis, so the nodes of each element need the
    # reverse order.
    cells = np.hstack([corners[:, [0, 3, 2, 1]], edges[:, [3, 2, 1, 0]]])
    nodes = np.unique(cells)
    points = source.doflocs[::-1, nodes].T
    mesh = felupe.Mesh(points, np.searchsorted(nodes, cells), "quad8")
    mesh.add_points([0.0, 0.0])  # this point moves like the plane
    region = felupe.RegionQuadraticQuad(mesh, quadrature=felupe.GaussLegendre(order=1, dim=2))
    field = felupe.FieldContainer([felupe.FieldAxisymmetric(region, dim=2)])
    solid = felupe.SolidBody(_metal(felupe, case), field)
    height, radius = mesh.points.T
    surface = (np.abs(np.hypot(radius, height - RADIUS) - RADIUS) < 1e-9) & (radius < 2 * reach)
    surface[-1] = False
    contact = felupe.ContactRigidPlane(
        field,
        points=np.flatnonzero(surface),
        centerpoint=-1,
        normal=np.array([1.0, 0.0]),
        multiplier=PENALTY * sphere.modulus * 2 * pi * reach,
    )
    carrier = np.arange(mesh.npoints) == mesh.npoints - 1
    boundaries = {
        "axis": felupe.Boundary(field[0], mask=(radius == 0) | carrier, skip=(1, 0)),
        "equator": felupe.Boundary(field[0], mask=height > RADIUS * (1 - 1e-9), skip=(0, 1)),
        "plane": felupe.Boundary(field[0], mask=carrier, skip=(0, 1)),
    }
    step = felupe.Step(
        [solid, contact], ramp={boundaries["plane"]: approaches}, boundaries=boundaries
    )
    forces = []

    def store_force(*_: object) -> None:
        nodal = contact.results.force.toarray().reshape(-1, 2)
        forces.append(abs(float(nodal[-1, 0])))

    felupe.Job([step], plugins=[store_force]).evaluate(verbose=0, tol=1e-6)
    return np.array(forces)


def _metal(felupe: ModuleType, case: Case):
    material = case.material
    modulus, ratio = material.youngs_modulus, material.poissons_ratio
    if material.hardening is None:
        return felupe.LinearElastic(E=modulus, nu=ratio)
    if case.settings.strain == "finite":
        metal = FiniteMetal(material)
        return felupe.Material(metal.stress, metal.elasticity, nstatevars=9)
    strength = material.hardening.yield_strength
    return felupe.LinearElasticPlasticIsotropicHardening(E=modulus, nu=ratio, sy=strength, K=0.0)


def compare(case: Case) -> pd.DataFrame:
    """Return the forces of both codes for the approaches that plastigran.fem has computed."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SmallStrainWarning)
        history = press(case.material, RADIUS, [case.force], case.settings).history
    loading = history[history["branch"] == 0].reset_index(drop=True)
    forces = by_felupe(case, loading["approach"].to_numpy())
    table = loading[["approach", "contact_radius", "force"]].iloc[: len(forces)].copy()
    table["a_over_R"] = table.pop("contact_radius") / RADIUS
    table["felupe"] = forces
    table["difference_percent"] = 100 * (table["force"] / forces - 1)
    return table


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*", choices=CASES, help="default: all")
    for name in parser.parse_args().cases or CASES:
        table = compare(CASES[name])
        print(f"{name}\n{table.iloc[::5].to_string(index=False, float_format='{:.5g}'.format)}\n")
