# SPDX-License-Identifier: GPL-2.0-or-later
"""LAMMPS counts contacts beyond the range of their law, and reports them like LIGGGHTS."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from lammps_scenes import FRICTION, MATERIAL, RADIUS, body, box, numbered, run, sphere

import plastigran as pg
from plastigran.engine.log import find_excess, find_warnings

LAW, SPEED = "vu_quoc_zhang", 0.15
REPORT = (
    r"model (\w+): (\d+) contacts have exceeded the validity range of the law \(.*\)\. "
    r"The largest overlap was (\S+) times"
)
STEP, STEPS = 2e-7, 1000


def scene(speed: float = SPEED, lines: str = "") -> str:
    """Return a script in which two spheres collide with each other, and one with a plane."""
    apart, gap = 4 * RADIUS, 1e-9
    spheres = numbered(
        [
            sphere(RADIUS + gap, 0, 0, -speed),
            sphere(-RADIUS - gap, 0, 0, speed),
            sphere(RADIUS + gap, apart, 0, -speed),
        ]
    )
    return f"""processors * 1 1
        {lines}
        {box(2 * apart)}{spheres}
        group third id 3
        {contact_lines()}
        restart 30 restart
        run {STEPS}
        """


def contact_lines() -> str:
    """Return the lines that follow the creation of the particles or `read_restart`."""
    return f"""
        pair_style granular/plastigran
        pair_coeff * * {LAW} {body()} {FRICTION}
        fix plane third wall/gran/plastigran granular {LAW} rigid {FRICTION} xplane 0 NULL
        fix motion all nve/sphere
        timestep {STEP}
        """


def reports(log: str) -> list[tuple[str, ...]]:
    return [report for text in find_warnings(log) for report in re.findall(REPORT, text)]


@pytest.mark.parametrize(("ranks", "newton"), [(1, "on"), (2, "on"), (2, "off")])
def test_contacts_are_counted_once(ranks, newton, tmp_path):
    """Each contact counts once, also if its spheres are on different ranks.

    The relative tolerance 1e-3 covers the error of the time step.
    """
    log = run(tmp_path, scene(lines=f"newton {newton}"), ranks)
    ((law, count, furthest),) = reports(log)
    assert (law, count) == (LAW, "2")
    contact = pg.Contact(LAW, MATERIAL, pg.RIGID, radius=RADIUS)
    pair = pg.Contact(LAW, MATERIAL, MATERIAL, radius=RADIUS, radius_other=RADIUS)
    ratios = [
        contact.impact(SPEED).overlap_max / (contact.law.overlap_range * RADIUS),
        pair.impact(2 * SPEED).overlap_max / (pair.law.overlap_range * pair.radius_eff),
    ]
    assert float(furthest) == pytest.approx(max(ratios), rel=1e-3)
    assert find_excess(log) == {LAW: float(furthest)}


def test_the_forecast_names_the_range(tmp_path):
    warnings = " ".join(find_warnings(run(tmp_path, scene())))
    assert f"model {LAW}: impacts at the current speeds (up to 0.3 m/s) will exceed" in warnings


@pytest.mark.parametrize("group", ["resting", "all"])
def test_the_forecast_of_a_wall_is_for_its_group(group, tmp_path):
    """A wall warns only of impacts of its own group of particles, not of those of other walls."""
    spheres = numbered([sphere(2 * RADIUS, 0, 0, 0), sphere(2 * RADIUS, 4 * RADIUS, 0, -SPEED)])
    log = run(
        tmp_path,
        f"""{box(8 * RADIUS)}{spheres}
        group resting id 1
        group moving id 2
        pair_style granular/plastigran
        pair_coeff * * hertz {body()} {FRICTION}
        fix soft {group} wall/gran/plastigran granular {LAW} rigid {FRICTION} xplane 0 NULL
        fix hard moving wall/gran/plastigran granular hertz rigid {FRICTION} xplane 0 NULL
        timestep {STEP}
        run 0
        """,
    )
    assert (f"model {LAW}: impacts at the current speeds" in log) == (group == "all")


def test_the_forecast_omits_types_of_other_pair_styles(tmp_path):
    """In `pair_style hybrid`, impacts of types without a contact law cause no warning."""
    spheres = numbered([sphere(x, 0, 0, 0) for x in (-2 * RADIUS, 2 * RADIUS)])
    log = run(
        tmp_path,
        f"""{box(8 * RADIUS, types=2)}{spheres}
        set atom 2 type 2 vx 1000
        pair_style hybrid granular/plastigran zero 0.01
        pair_coeff * * zero
        pair_coeff 1 1 granular/plastigran {LAW} {body()} {FRICTION}
        timestep {STEP}
        run 0
        """,
    )
    assert "Loop time" in log
    assert "is recommended for impacts" not in log and "will exceed" not in log


def test_no_report_within_the_range(tmp_path):
    log = run(tmp_path, scene(speed=0.002))
    assert not reports(log) and not find_excess(log)
    assert "will exceed the validity range" not in log


def test_a_restart_continues_the_count(tmp_path):
    """A run that continues when both contacts are beyond the range counts them only once."""
    whole = reports(run(tmp_path, scene()))
    step = last_restart(tmp_path, within=60)
    log = run(
        tmp_path,
        f"""read_restart restart.{step}
        comm_modify vel yes
        neighbor {0.05 * RADIUS} bin
        {contact_lines()}
        run {STEPS - step}
        """,
    )
    assert reports(log) == whole


def last_restart(folder: Path, within: int) -> int:
    """Return the latest step, up to `within`, that has a restart file."""
    steps = [int(file.suffix[1:]) for file in folder.glob("restart.*")]
    return max(step for step in steps if step <= within)
