# SPDX-License-Identifier: GPL-2.0-or-later
"""Contacts beyond the validity range of their law are counted and reported at the end of a run."""

from __future__ import annotations

import re
from math import pi
from pathlib import Path

import pytest
from scipy.optimize import brentq

from plastigran import laws
from plastigran.engine.process import run_deck
from plastigran.experiments.central import CentralImpact

REPORT = (
    r"model (\w+): (\d+) contacts have exceeded the validity range of the law \(.*\)\. "
    r"The largest overlap was (\S+) times"
)


def excess(geometry: str, law: str, speed: float, folder: Path, ranks: int = 1, **more) -> list:
    variables = {"law": law, "speed": speed, **more}
    return re.findall(REPORT, run_deck(f"collision/{geometry}.in", variables, folder, ranks=ranks))


def vu_quoc_zhang_limit(pair: laws.MaterialPair, radius_eff: float) -> float:
    # The law is calibrated up to 41 times the yield force P_Y. Its range ends at 42 P_Y, which
    # allows for rounding.
    law = laws.VuQuocZhang(pair)
    return law.overlap(radius_eff, 42 * law.yield_force(radius_eff), law.State())


def kogut_etsion_limit(pair: laws.MaterialPair, radius_eff: float) -> float:
    hardness = (0.454 + 0.41 * pair.poissons_ratio) * 2.8 * pair.yield_strength
    return 110 * radius_eff * (pi * hardness / (2 * pair.youngs_modulus_eff)) ** 2


def jackson_green_limit(pair: laws.MaterialPair, radius_eff: float) -> float:
    def beyond(overlap: float) -> float:
        law = laws.JacksonGreen(pair)
        return law.respond(radius_eff, overlap, law.State()).contact_radius - 0.41 * radius_eff

    return brentq(beyond, 1e-4 * radius_eff, 0.1 * radius_eff)


def smallness_limit(pair: laws.MaterialPair, radius_eff: float) -> float:
    return 0.1 * radius_eff


CASES = [
    ("vu_quoc_zhang", 0.2, vu_quoc_zhang_limit),
    ("kogut_etsion", 0.5, kogut_etsion_limit),
    ("jackson_green", 30.0, jackson_green_limit),
    ("thornton", 40.0, smallness_limit),
]


@pytest.mark.parametrize(("law", "speed", "limit"), CASES)
def test_the_range_is_the_published_one(law, speed, limit, aluminium, tmp_path):
    """The log reports the largest overlap, divided by the largest overlap of the published range.

    The relative tolerance 1e-3 covers the error of the time step and the distance between frames.
    """
    model = CentralImpact(law, speed, aluminium, 0.1)
    reports = excess("sphere_wall", law, speed, tmp_path, timestep=model.timestep)
    assert [line[:2] for line in reports] == [(law, "1")]
    expected = model.predict().overlap_max / limit(model.pair, model.radius_eff)
    assert expected > 1
    assert float(reports[0][2]) == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_contact_is_counted_once(ranks, tmp_path):
    """A contact counts once even if its spheres belong to different ranks."""
    reports = excess("two_spheres", "vu_quoc_zhang", 0.2, tmp_path, ranks=ranks)
    assert [line[1] for line in reports] == ["1"]


def test_no_report_within_the_range(tmp_path):
    assert excess("sphere_wall", "vu_quoc_zhang", 0.02, tmp_path) == []
