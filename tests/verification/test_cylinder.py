# SPDX-License-Identifier: GPL-2.0-or-later
"""The laws for cylinders, compared with closed forms and with their source, and in LIGGGHTS."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from attrs import evolve
from scipy.integrate import solve_ivp

from plastigran import laws
from plastigran.experiments.cylinder import CylinderImpact, study
from plastigran.materials import read_material
from plastigran.physics import central
from plastigran.physics.contact_time import contact_time
from plastigran.usable_laws import laws_for

CYLINDER_LAWS = laws_for("cylinder")

PUBLISHED = list(pd.read_csv(Path(__file__).parent / "cylinder_kp10.csv", comment="#").itertuples())


def glass(law: str, speed: float = 1.0, radius: float = 1e-5, ratio: float = 10) -> CylinderImpact:
    return CylinderImpact(law, speed, read_material("glass_kp10"), radius, length_ratio=ratio)


@pytest.mark.parametrize("row", PUBLISHED, ids=lambda row: f"{row.radius}-{row.speed}")
@pytest.mark.parametrize("name", CYLINDER_LAWS)
def test_published_laws(name, row):
    """Without energy guard, impacts agree with the published equations of the laws.

    The results of these equations are in cylinder_kp10.csv. The relative tolerance is 1e-5, because
    the table has six digits.
    """
    impact = glass(name, row.speed, row.radius * 1e-6, row.length_ratio)
    law = impact.contact_law(energy_guard="off")
    found = law.central_impact(impact.radius_eff, impact.mass_eff, row.speed)
    peak = law.respond(impact.radius_eff, found.overlap_max, law.State())
    width = 2 * peak.contact_radius * impact.cylinder_length
    overlap_res = getattr(row, f"{name}_overlap_res") * 1e-6
    assert impact.yield_speed() == pytest.approx(row.yield_speed, rel=1e-5)
    assert found.overlap_max == pytest.approx(row.overlap_max * 1e-6, rel=1e-5)
    assert found.force_max == pytest.approx(row.force_max, rel=1e-5)
    assert peak.contact_radius == pytest.approx(row.half_width * 1e-6, rel=1e-5)
    assert found.force_max / width / 2.41e9 == pytest.approx(row.pressure_ratio, rel=1e-5)
    assert found.overlap_res == pytest.approx(overlap_res, rel=1e-5)
    assert found.coefficient_of_restitution == pytest.approx(
        getattr(row, f"{name}_restitution"), rel=1e-5
    )


@pytest.mark.parametrize("name", CYLINDER_LAWS)
def test_yield(name):
    """Force, overlap and work of a cylinder at yield have closed forms.

    The slope of the force jumps there by a factor of 0.346 (C - 1) = 3.16, with
    C = ln(4 D^2/a^2) - nu/(1 - nu), half-width a at yield and thickness D of the body.
    """
    impact = glass(name)
    law, radius = impact.contact_law(), impact.radius_eff
    force, overlap, work = central.line_yield(impact.pair, radius, 1e-4, 1e-4)
    answer = law.respond(radius, overlap * (1 - 1e-13), law.State())
    assert answer.force == pytest.approx(force, rel=1e-11)
    assert answer.elastic_energy == pytest.approx(work, rel=1e-11)
    assert answer.contact_radius == pytest.approx(12 * 2.41e9 * radius / (np.pi * 83.96e9))
    assert force == pytest.approx(3 * 2.41e9 * answer.contact_radius * 1e-4)

    def slope(x: float) -> float:
        step = 1e-7 * overlap
        return (
            law.respond(radius, x + step, law.State()).force
            - law.respond(radius, x - step, law.State()).force
        )

    jump = slope(overlap * (1 + 2e-7)) / slope(overlap * (1 - 2e-7))
    assert jump == pytest.approx(3.16, rel=2e-3)  # three digits are given


@pytest.mark.parametrize("name", CYLINDER_LAWS)
def test_guard_only_shortens_the_rebound(name):
    """Just above yield, the energy guard keeps restitution at 1.

    Where the published law dissipates, the guard changes nothing.
    """
    slow, fast = glass(name, 0.6), glass(name, 1.0)
    assert slow.predict().coefficient_of_restitution == pytest.approx(1, abs=1e-12)
    published = slow.contact_law(energy_guard="off").central_impact(1e-5, 1.59e-6, 0.6)
    assert slow.predict().overlap_res > published.overlap_res > 0
    published = fast.contact_law(energy_guard="off").central_impact(1e-5, 1.59e-6, 1.0)
    assert fast.predict().overlap_res == published.overlap_res


@pytest.mark.parametrize("name", CYLINDER_LAWS)
def test_contact_time_is_that_of_the_motion(name):
    """Contact times by quadrature agree with the equation of motion to a relative 1e-5. The kink of
    the force at yield causes this difference.
    """
    impact = glass(name, 1.0)
    law = impact.contact_law()
    loading, total = contact_time(law, 1e-5, 1.59e-6, 1.0)
    path, duration = [0.0, 1.0], []
    dent = law.State()
    law.respond(1e-5, impact.predict().overlap_max, dent)
    end = impact.predict().overlap_res * (1 + 1e-9)
    for state, event in ((law.State, lambda t, y: y[1]), (dent.copy, lambda t, y: y[0] - end)):
        event.terminal, event.direction = True, -1

        def motion(_, y, state=state):
            return [y[1], -law.respond(1e-5, y[0], state()).force / 1.59e-6]

        found = solve_ivp(
            motion, (0, 1e-5), path, "DOP853", events=event, rtol=1e-9, atol=1e-14, max_step=1e-8
        )
        path = found.y[:, -1]
        duration.append(found.t[-1])
    assert loading == pytest.approx(duration[0], rel=1e-5)
    assert total == pytest.approx(sum(duration), rel=1e-5)


def test_finite_elements():
    """The finite elements of the source have a residual overlap of 0.12 um. Katta & Polycarpou's
    law gives 6 % more, and Lim & Stronge's 64 %. The finite-element run ended at 3 us, 1.6 times
    the contact time.
    """
    table = study.comparison()
    assert table.loc["katta_polycarpou", "overlap_res_error"] == pytest.approx(0.056, abs=0.002)
    assert table.loc["lim_stronge", "overlap_res_error"] == pytest.approx(0.636, abs=0.002)
    assert table.loc["katta_polycarpou", "contact_time"] == pytest.approx(1.8405e-6, rel=1e-4)
    # The end of the finite-element run is only an upper bound of the contact time.
    assert np.isnan(table.loc["finite elements", "contact_time"])
    assert table.loc["finite elements", "contact_time_bound"] == 3e-6


def test_study(tmp_path):
    table = study.study([2e-6, 1e-5], [0.2, 1.0], 10.0)
    assert len(table) == 8
    paper = table.set_index(["law", "radius", "speed"])
    assert paper.loc[("katta_polycarpou", 1e-5, 1.0), "overlap_res"] == pytest.approx(
        0.126752e-6, rel=1e-5
    )
    assert paper.loc[("katta_polycarpou", 1e-5, 0.2), "contact_time"] == pytest.approx(
        2.55765e-6, rel=1e-5
    )
    assert (table["coefficient_of_restitution"] <= 1).all()


def test_study_with_the_engine(tmp_path):
    """`CylinderImpact.study` writes its tables, and its impacts in LIGGGHTS agree with the laws.

    The relative tolerance 1e-3 is the error of the recommended time step.
    """
    runs = CylinderImpact.study(tmp_path, points=3, progress=False)
    runs.write(tmp_path)
    summary = runs.tables["comparison"]
    assert len(pd.read_csv(tmp_path / "maps.csv")) == len(runs.tables["maps"]) == 2 * 2 * 3 * 3
    assert list(pd.read_csv(tmp_path / "comparison.csv")["law"]) == list(summary.index)
    for name in CYLINDER_LAWS:
        assert summary.loc[name, "coefficient_of_restitution_engine"] == pytest.approx(
            summary.loc[name, "coefficient_of_restitution"], rel=1e-3
        )


def test_impacts_out_of_reach_are_refused():
    with pytest.raises(ValueError, match="vu_quoc_zhang is a law for spheres"):
        glass("vu_quoc_zhang")
    with pytest.raises(ValueError, match="mass is -1; it must be positive"):
        evolve(glass("lim_stronge"), mass=-1)
    with pytest.raises(ValueError, match=r"would overlap by .* effective radii"):
        glass("lim_stronge", 5.0, 2e-6)
    with pytest.raises(ValueError, match=r"body_thickness is 0.0001 m; .* with radius 0.005 m"):
        glass("lim_stronge", 0.1, 5e-3)


def test_required_lengths_in_python():
    pair = glass("lim_stronge").pair
    with pytest.raises(
        ValueError, match=r"lim_stronge: cylinder_length is missing\. Add a value between"
    ):
        laws.LimStronge(pair, body_thickness=1e-4)
    with pytest.raises(ValueError, match="body_thickness is -1"):
        laws.KattaPolycarpou(pair, cylinder_length=1e-4, body_thickness=-1)
