# SPDX-License-Identifier: GPL-2.0-or-later
"""Every law compared with its reference, an independent implementation of the source's
equations in numpy.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from references import impacts
from references.contact import MATERIALS, Contact, work
from test_cases import CASES, OUTCOMES, impact

from plastigran import laws
from plastigran.materials import RIGID, read_material

RADIUS, LENGTH = 0.1, 1.0  # radius of sphere or cylinder, length of the cylinder [m]
#: Largest overlaps, divided by the overlap at which the elastic formula ends.
PEAKS = (0.5, 0.9, 1.001, 1.05, 1.5, 3, 6.03, 20, 60, 139.3, 1500)
#: Relative tolerance. Energies and motion of a reference agree to 1e-9; the default constants of
#: `vu_quoc_zhang` have six digits.
TOLERANCE = dict.fromkeys(impacts.LAWS, 1e-9) | {"vu_quoc_zhang": 3e-6}
#: Laws whose contact radius other tests check.
RADIUS_ELSEWHERE = {"hertz", "viscoelastic_hertz", "vu_quoc_zhang", "katta_polycarpou"}
RADIUS_ELSEWHERE |= {"lim_stronge"}


@pytest.mark.parametrize("case", CASES)
def test_impacts(case):
    """A law gives the same impacts as its reference.

    The reference computes an impact from energies and from the motion, which agree to 1e-9.
    """
    law, index = CASES[case]
    expected, found = impacts.outcome(law, index), impact(law, index).predict()
    for quantity in OUTCOMES:
        # A residual overlap is a difference, so its tolerance is relative to the largest overlap.
        margin = expected.overlap_max if quantity == "overlap_res" else 0
        assert getattr(found, quantity) == pytest.approx(
            getattr(expected, quantity), rel=TOLERANCE[law], abs=TOLERANCE[law] * margin
        ), quantity


def options(name: str) -> list[str]:
    """Return the options to test for a law: its defaults, each alternative interpretation of its
    source, and the law without energy guard.
    """
    kind = impacts.reference(name)
    return ["", *kind.readings, *(["energy_guard off"] if kind.energy_guard else [])]


@pytest.fixture(
    params=[
        pytest.param((name, option), id=f"{name} {option}".strip())
        for name in impacts.LAWS
        for option in options(name)
    ]
)
def twins(request, law_between):
    """Return a law's name, the law and its reference for a body on a rigid plane.

    With `reading pair`, both bodies are of the material, so E* is half.
    """
    name, option = request.param
    kind = impacts.reference(name)
    material, body = MATERIALS[kind.material_name], read_material(kind.material_name).body()
    pair = laws.combine(body, RIGID)
    if option == "reading pair":
        material = replace(material, youngs_modulus=material.youngs_modulus / 2)
        pair = laws.combine(body, body)
    others = {"mass": 1.0, "length_ratio": LENGTH / RADIUS, "body_thickness": LENGTH}
    reference = kind(material, RADIUS, speed=1.0, **(others if "mass" in kind.cases else {}))
    if option == "energy_guard off":
        reference.energy_guard = False
    else:
        reference.reading = option
    given = dict([option.split()]) if option else {}
    given = {key: float(word) if word[0].isdigit() else word for key, word in given.items()}
    return name, law_between(name, pair, LENGTH, **given), reference


def test_every_option_is_held(law_name):
    """Each choice of each option of a law is the default of the law, or `options` tests it."""
    given = [option.split() for option in options(law_name) if option]
    for option in laws.LAWS[law_name].options():
        taken = {choice for name, choice in given if name == option["name"]}
        assert taken == {*option["choices"]} - {option["default"]}


def peaks(reference) -> np.ndarray:
    elastic = reference.pieces[0][0]
    if elastic == np.inf:
        elastic = reference.overlap_at(reference.material.yield_pressure)
    return elastic * np.array(PEAKS)


def test_force_on_a_path(twins):
    """Law and reference give the same force on a path of loading to increasing overlaps, with full
    unloading between them."""
    name, law, reference = twins
    share = np.concatenate([np.linspace(0, 1, 7), np.linspace(0.97, 0, 12)])
    path = np.concatenate([peak * share for peak in peaks(reference)])
    found = law.follow(RADIUS, path, law.State())["force"]
    expected = reference.follow(path)
    scale = np.maximum.accumulate(expected)
    assert (expected > 0).sum() > 60
    off = np.abs(found - expected)
    assert (off <= TOLERANCE[name] * scale).all()


def test_contact_radius(twins):
    """Law and reference have the same contact radius.

    It is compared during first loading, and where 0.6 of the unloading curve remains. The relative
    tolerance during unloading is 1e-6, because the reference uses finite differences.
    """
    name, law, reference = twins
    if type(reference).contact_radius is Contact.contact_radius:
        assert name in RADIUS_ELSEWHERE
        return
    for peak in peaks(reference):
        if peak <= reference.pieces[0][0]:
            continue
        state = law.State()
        largest = law.respond(RADIUS, peak, state).contact_radius
        assert largest == pytest.approx(reference.contact_radius(peak), rel=TOLERANCE[name])
        recovery, shape = reference.rebound(peak)
        found = law.respond(RADIUS, peak - 0.4 * recovery, state).contact_radius
        expected = reference.released_radius(0.6, shape) * largest
        assert found == pytest.approx(expected, rel=1e-6)


def test_energies(twins):
    """Plastic work and elastic energy at the largest overlap agree with the work of the force by
    quadrature, relative to the loading work.
    """
    name, law, reference = twins
    for peak in peaks(reference):
        found = law.respond(RADIUS, peak, law.State())
        recovery, shape = reference.rebound(peak)
        stored = reference.loading_force(peak) * recovery * work(shape, 0, 1)
        put_in = reference.loading_work(peak)
        within = TOLERANCE[name] * put_in
        assert found.elastic_energy == pytest.approx(stored, rel=0, abs=within)
        assert found.plastic_work == pytest.approx(put_in - stored, rel=0, abs=within)
