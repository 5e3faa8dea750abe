# SPDX-License-Identifier: GPL-2.0-or-later
"""Adhesive laws and laws that are plastic from first touch, in LIGGGHTS: pairs and walls."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from adhesive_grains import (
    CONSTANTS,
    GRAINS,
    MASS,
    PLATE,
    RADIUS,
    STRETCHED,
    WALL,
    energy_terms,
    law_of,
    run,
    sphere,
    table,
)

from plastigran.engine.process import EngineError
from plastigran.physics import adhesion

SPEEDS = np.geomspace(0.3, 6, 10)


def ten_impacts(law: str) -> tuple[list[str], float]:
    """Return grains that hit the wall at `SPEEDS`, and half the recommended time step [s]."""
    bodies = [
        sphere(-RADIUS * (1 + 1e-6), (k - 4.5) * 3 * RADIUS, speed)
        for k, speed in enumerate(SPEEDS)
    ]
    return bodies, 0.5 * float(np.min(law_of(law).recommended_timestep(RADIUS, MASS, SPEEDS)))


@pytest.mark.parametrize("law", CONSTANTS)
def test_restitution_at_a_wall_is_that_of_the_law(law, tmp_path):
    """Restitution at ten speeds below and above the sticking speed follows the law.

    The restitution of `jkr` also follows its closed form. The time step, half the recommended one,
    causes an error of up to 1e-3.
    """
    bodies, timestep = ten_impacts(law)
    steps = int(5e-7 / timestep)  # the slowest grain then has left
    run(law, tmp_path, bodies, f"run {steps}", timestep=timestep, every=steps)
    end = table(tmp_path)
    end = end[end["step"] == steps].sort_values("id")
    left = end["x"].to_numpy() < -1.01 * RADIUS
    restitution = np.where(left, -end["vx"].to_numpy() / SPEEDS, 0)
    expected = law_of(law).central_impact(RADIUS, MASS, SPEEDS).coefficient_of_restitution
    assert restitution == pytest.approx(expected, abs=1e-3)
    if law == "jkr":
        sticking = adhesion.jkr_sticking_speed(0.2, RADIUS, WALL.youngs_modulus_eff, MASS)
        assert 0 < (SPEEDS < sticking).sum() < len(SPEEDS)
        closed = np.sqrt(np.maximum(0, 1 - (sticking / SPEEDS) ** 2))
        assert restitution == pytest.approx(closed, abs=1e-3)


def touch_and_pull(law: str, folder: Path, bodies: list[str], **variables) -> pd.DataFrame:
    """Move the first body against its partner to an overlap of 0.004 R* in 40 steps, then away in
    160 steps.
    """
    commands = variables.pop(
        "moves",
        "unfix motion\n"
        "fix motion all move linear 0 0 0\nrun 0\nunfix motion\n"
        "fix press mover move linear 1 0 0\nrun 40\nunfix press\n"
        "fix pull mover move linear -0.5 0 0\nrun 160",
    )
    run(law, folder, bodies, "group mover id 1\n" + commands, **variables)
    return table(folder)


@pytest.mark.parametrize("law", CONSTANTS)
def test_pair_and_plane_follow_the_law(law, tmp_path):
    """The force on adhesive grains follows the law when they are pressed on and pulled off.

    A grain touches a plane, or the common edge of two triangles. Two grains of twice the radius
    follow the same path.

    At each step, the force differs from that of the law by at most 1e-9 of the largest force. The
    coordinates, 1e-5 m, have a round-off of 1e-16, which is 1e-13 of the overlap. The neighbor skin
    is just above the pull-off distance.
    """
    step = 0.004 * RADIUS / 40  # [s], for a speed of 1 m/s
    for name, bodies, pair in (
        ("plane", [sphere(-RADIUS, 0, 0)], WALL),
        ("mesh", [sphere(-RADIUS, 0, 0)], WALL),
        (
            "pair",
            [
                sphere(-16e-6 - 2 * RADIUS, 0, 0, 2 * RADIUS),
                sphere(-16e-6 + 2 * RADIUS, 0, 0, 2 * RADIUS),
            ],
            GRAINS,
        ),
    ):
        surface = {"mesh": PLATE} if name == "mesh" else {}
        trajectory = touch_and_pull(
            law, tmp_path / name, bodies, timestep=step, skin=1.3e-8, **surface
        )
        mover = trajectory[trajectory["id"] == 1].sort_values("step")
        contact_at = 0.0 if name != "pair" else -16e-6 + 2 * RADIUS
        size = RADIUS if name != "pair" else 4 * RADIUS
        overlap = size - (contact_at - mover["x"].to_numpy())
        model = law_of(law, pair)
        expected = model.follow(RADIUS, overlap, model.State())["force"]
        scale = np.abs(expected).max()
        assert -mover["fx"].to_numpy() == pytest.approx(expected, abs=1e-9 * scale)
        if model.adhesive:
            assert expected.min() < -0.05 * scale
        if law in STRETCHED:
            assert (overlap[expected < 0] < 0).any(), "the contact was not stretched"


@pytest.mark.parametrize(
    ("law", "ranks", "grid"),
    [(law, *on) for law in STRETCHED for on in ((1, "1 1 1"), (2, "1 2 1"))]
    + [("luding_2008", 2, "1 2 1"), ("edinburgh_2014", 2, "1 2 1")]
    + [("universal adhesion jkr", 4, "2 2 1")],  # the longest history
)
@pytest.mark.parametrize("geometry", ["plane", "mesh", "pair"])
def test_a_stretched_contact_outlives_restarts_ranks_and_rebuilds(
    law, geometry, ranks, grid, tmp_path
):
    """A contact is compressed, stretched and then kept in place. A restart file, `pre no` and more
    ranks do not change its force.

    Every run rebuilds the neighbor lists and sorts the atoms. Bodies without overlap have no
    contact for LIGGGHTS, so it alone would lose the history.
    """
    depth, model = 0.002 * RADIUS, law_of(law, GRAINS if geometry == "pair" else WALL)
    radius_eff = RADIUS / 2 if geometry == "pair" else RADIUS
    surface = {"mesh": PLATE} if geometry == "mesh" else {}
    path = np.linspace(depth, -model.pull_off_distance(radius_eff), 10001)
    follow = model.follow(radius_eff, path, model.State())
    if law in STRETCHED:
        held_at = 0.7 * path[np.flatnonzero(follow["contact_radius"])[-1]]
        assert held_at < 0, "the bodies overlap"
    else:
        held_at = path[follow["force"].argmin()]
    step = depth / 40  # [s], for a speed of 1 m/s
    back = round((depth - held_at) / step * 2)
    bodies = [sphere(-RADIUS, 0, 0)]
    if geometry == "pair":
        bodies = [sphere(-2 * RADIUS - 3e-6, 0, 0), sphere(-3e-6, 0, 0)]
    stretch = (
        "unfix motion\nfix press mover move linear 1 0 0\nrun 40\nunfix press\n"
        f"fix pull mover move linear -0.5 0 0\nrun {back}\nunfix pull\n"
        f"write_restart {tmp_path.resolve()}/middle.restart\n"
        "run 40\nrun 20 pre no"
    )
    run(
        law,
        tmp_path / "whole",
        bodies,
        "group mover id 1\n" + stretch,
        ranks,
        timestep=step,
        grid=grid,
        tangential="history",
        **surface,
    )
    held = table(tmp_path / "whole").query("id == 1").sort_values("step")
    force = -held["fx"].to_numpy()
    assert force[-1] < 0, "the contact is lost"
    assert force[-60:] == pytest.approx(force[-1], rel=1e-12)
    run(
        law,
        tmp_path / "rest",
        bodies,
        "unfix motion\nrun 60",
        ranks,
        timestep=step,
        grid=grid,
        tangential="history",
        **surface,
        restart=tmp_path.resolve() / "middle.restart",
    )
    rest = table(tmp_path / "rest").query("id == 1").sort_values("step")
    assert -rest["fx"].to_numpy() == pytest.approx(force[-1], rel=1e-12)


@pytest.mark.parametrize(
    ("law", "mesh"), [(law, None) for law in CONSTANTS] + [(law, PLATE) for law in STRETCHED]
)
def test_the_energy_balance_closes_at_a_wall(law, mesh, tmp_path):
    """The energy balance closes for ten adhesive impacts below and above the sticking speed.

    The balance error is below 2e-3 of the initial kinetic energy. The error is of first order in
    the time step, because the force jumps where contacts form and break.
    """
    bodies, timestep = ten_impacts(law)
    steps = int(60e-9 / timestep)
    terms = energy_terms(
        law, tmp_path, bodies, steps, timestep=timestep, options="energy_ledger on", mesh=mesh
    )
    energy = terms["kinetic"].iloc[0]
    assert terms["drift"].abs().max() < 2e-3 * energy
    lasts = law in STRETCHED or law.endswith("adhesion jkr")
    assert (terms["adhesion"].iloc[-1] > 1e-3 * energy) == lasts
    assert (terms["surface"].min() < -1e-3 * energy) == lasts
    assert (terms["plastic"].iloc[-1] > 0.05 * energy) == (law != "jkr")


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("damping", ["", "viscous_damping on"])
@pytest.mark.parametrize("tangential", ["history", "partial_slip", "incremental"])
@pytest.mark.parametrize("law", STRETCHED)
def test_the_energy_balance_closes_for_pairs(law, tangential, damping, ranks, tmp_path):
    """The energy balance closes for oblique adhesive impacts of grain pairs with friction.

    On two ranks, the contacts lie on the border between the ranks. The balance error is below 2e-3
    of the initial kinetic energy, as for walls. The friction work is small, but larger than this
    error.
    """
    bodies = []
    for k, speed in enumerate((0.5, 2.0)):
        y = (2 * k - 1) * 6 * RADIUS
        bodies += [
            sphere(-16e-6 - RADIUS * (1 + 1e-6), y, speed),
            sphere(-16e-6 + RADIUS * (1 + 1e-6), y + 0.3 * RADIUS, -speed),
        ]
    model = law_of(law, GRAINS)
    timestep = 0.3 * float(model.recommended_timestep(RADIUS / 2, MASS / 2, 1.0))
    terms = energy_terms(
        law,
        tmp_path,
        bodies,
        int(150e-9 / timestep),
        ranks=ranks,
        grid="1 2 1" if ranks == 2 else "1 1 1",
        timestep=timestep,
        tangential=tangential,
        values={**CONSTANTS[law]},
        options=f"{damping} energy_ledger on",
    )
    energy = terms["kinetic"].iloc[0]
    assert terms["drift"].abs().max() < 2e-3 * energy
    assert terms["surface"].min() < -1e-3 * energy
    assert terms["friction"].iloc[-1] > 2 * terms["drift"].abs().max()
    assert (terms["viscous"].iloc[-1] > 1e-3 * energy) == bool(damping)


def test_friction_is_limited_by_force_and_pull_off_force(tmp_path):
    """The friction force |T| is at most mu (F + F_c), with normal force F and pull-off force F_c.

    A grain with F near zero therefore slides at about mu F_c.
    """
    law = law_of("jkr")
    commands = "unfix motion\ngroup mover id 1\nfix slide mover move linear 0 1 0\nrun 2000"
    step = 1e-12
    resting = 8.3e-9  # overlap near zero force [m]
    run(
        "jkr",
        tmp_path,
        [sphere(-RADIUS + resting, 0, 0)],
        commands,
        timestep=step,
        tangential="history",
    )
    grain = table(tmp_path).query("id == 1").sort_values("step")
    pull_off = 1.5 * pi * 0.2 * RADIUS
    force = law.respond(RADIUS, resting).force
    assert abs(force) < 0.2 * pull_off
    assert grain["fy"].abs().iloc[-1] == pytest.approx(0.3 * (force + pull_off), rel=1e-9)


BAD = {
    "surfaceEnergy is missing": ("jkr", {"values": {}}),
    "surfaceEnergy is -1; it must be between 0 and 1000": (
        "jkr",
        {"values": {"surface_energy": -1}},
    ),
    "unloadingStiffness must be at least loadingStiffness": (
        "walton_braun",
        {"values": {"loading_stiffness": 2e3, "unloading_stiffness": 1e3}},
    ),
    "the neighbor skin is 1e-09; it must be at least": ("jkr", {"skin": 1e-9}),
    "cohesion sjkr adds to the adhesion of this law. Remove": ("jkr", {"models": "cohesion sjkr"}),
    "rolling_friction epsd is not supported with adhesion": (
        "jkr",
        {"models": "rolling_friction epsd", "tangential": "history"},
    ),
    "keeps the smallest particles": ("jkr", {"values": {"surface_energy": 900}}),
    "model universal adhesion jkr: surfaceEnergy is missing": (
        "universal adhesion jkr",
        {"values": {}},
    ),
    "model jkr: adhesion jkr is not supported, because the law has its own adhesion": (
        "jkr adhesion jkr",
        {"values": {"surface_energy": 0.1}},
    ),
    "model mdr: adhesion jkr is not supported, because the law does not begin": (
        "mdr adhesion jkr",
        {"values": {"surface_energy": 0.1}},
    ),
}


@pytest.mark.parametrize("message", BAD)
def test_impossible_decks_are_refused(message, tmp_path):
    law, variables = BAD[message]
    with pytest.raises(EngineError, match=message):
        run(law, tmp_path, [sphere(-2 * RADIUS, 0, 0)], "run 1", **variables)
