# SPDX-License-Identifier: GPL-2.0-or-later
"""What the test folders share: which laws there are, found and never listed."""

from __future__ import annotations

import re
from dataclasses import replace
from math import pi
from pathlib import Path

import pytest

from plastigran import laws
from plastigran.engine.process import PROJECT
from plastigran.experiments.central import laws_for
from plastigran.materials import RIGID, read_material

# Laws with a model in the engine: one binding header each.
ENGINE_LAWS = sorted(
    path.stem.removeprefix("normal_model_")
    for path in (PROJECT / "contact_models" / "liggghts" / "models").glob("normal_model_*.h")
)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """`law_name` runs a test for every law, `engine_law` for every law with an engine model,
    `sphere_law` for those of them for spheres, `yielding_law` for those of these that yield,
    `rod_law` for those the oblique rod takes."""
    if "law_name" in metafunc.fixturenames:
        metafunc.parametrize("law_name", sorted(laws.LAWS))
    if "rod_law" in metafunc.fixturenames:  # its equations of motion know no rate of overlap
        names = [name for name in laws_for("sphere") if not laws.LAWS[name].rate_dependent]
        metafunc.parametrize("rod_law", names)
    if "sphere_law" in metafunc.fixturenames:
        spheres = [name for name in ENGINE_LAWS if laws.LAWS[name].shape == "sphere"]
        metafunc.parametrize("sphere_law", spheres)
    if "yielding_law" in metafunc.fixturenames:
        spheres = [name for name in ENGINE_LAWS if laws.LAWS[name].shape == "sphere"]
        metafunc.parametrize("yielding_law", [n for n in spheres if laws.LAWS[n].yields])
    if "engine_law" in metafunc.fixturenames:
        metafunc.parametrize("engine_law", ENGINE_LAWS)


@pytest.fixture(scope="session")
def law_between(aluminium):
    """Makes a law between two bodies, `law_between(name, pair, length, **options)`: `length` [m] is
    a cylinder's and its body's thickness, for laws that ask for them.
    """

    def make(name: str, pair: laws.MaterialPair, length: float = 0.1, **options: str):
        brought = [p["name"] for p in laws.LAWS[name].parameters() if p["per_body"]]
        return aluminium.law(name, pair, **dict.fromkeys(brought, length), **options)

    return make


@pytest.fixture
def decks() -> Path:
    """Folder of the conformance decks."""
    return PROJECT / "tests" / "conformance" / "decks"


@pytest.fixture(scope="session")
def aluminium():
    """The paper's aluminium, with a constant the paper does not give, for laws that must have it:
    restitution near 0.8 for its sphere."""
    return replace(read_material("aluminium_zv02"), dissipative_constant=3e-5)


@pytest.fixture(scope="session")
def paper_pair(aluminium):
    """The paper's sphere on a rigid plane."""
    return laws.combine(aluminium.body(), RIGID)


@pytest.fixture(scope="session")
def paper_mass(aluminium) -> float:
    """Mass of the paper's sphere [kg]."""
    return 4 / 3 * pi * 0.1**3 * aluminium.density


@pytest.fixture(scope="session")
def declared_jumps() -> dict[str, list[tuple[float, float]]]:
    """Jumps of the virgin force that each law's source has: `# jump OVERLAP SIZE` lines at the head
    of its verification cases, in overlaps at yield of the paper's aluminium, and as a share of the
    force.
    """
    jumps = {}
    for law in laws.LAWS:
        text = (PROJECT / "tests" / "verification" / "cases" / f"{law}.csv").read_text()
        found = re.findall(r"^# jump (\S+) (\S+)", text, re.MULTILINE)
        jumps[law] = [(float(place), float(size)) for place, size in found]
    return jumps
