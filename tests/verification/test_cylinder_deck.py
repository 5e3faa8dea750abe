# SPDX-License-Identifier: GPL-2.0-or-later
"""Cylinders in LIGGGHTS: lengths in the deck, errors, damping, and impacts of any size."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from plastigran.engine.process import EngineError, inputs_folder, run_deck
from plastigran.experiments.collision import measure
from plastigran.experiments.cylinder import CylinderImpact
from plastigran.usable_laws import laws_for

CYLINDER_LAWS = laws_for("cylinder")


def deck(**changes: str) -> str:
    """Return the text of cylinder_wall.in after replacements; each change is a pair of old and new
    text."""
    text = (inputs_folder() / "collision" / "cylinder_wall.in").read_text()
    for old, new in changes.values():
        assert old in text
        text = text.replace(old, new)
    return text


def run(text: str, folder, **variables):
    folder.mkdir(exist_ok=True)
    (folder / "deck.in").write_text(text)
    return run_deck(folder / "deck.in", variables, folder)


def lengths(cylinder_length: str, body_thickness: str) -> tuple[str, str]:
    """Return a change for `deck` that replaces the lengths of both atom types."""
    given = f"""
unfix cylinder_length
unfix body_thickness
fix cl all property/global cylinderLength peratomtype {cylinder_length}
fix bt all property/global bodyThickness peratomtype {body_thickness}
pair_style"""
    return "\npair_style", given


def test_either_body_may_bring_either_length(tmp_path):
    """A rigid cylinder on a yielding body equals a yielding cylinder on a rigid wall, and the
    larger of two given lengths is used.
    """
    found = []
    for case, given in enumerate(
        [("1e-4 0", "1e-4 0"), ("1e-4 0", "0 1e-4"), ("1e-4 1e-5", "2e-5 1e-4")]
    ):
        run(deck(lengths=lengths(*given)), tmp_path / str(case))
        found.append(measure(tmp_path / str(case) / "trajectory.dump").coefficient_of_restitution)
    assert found[0] == found[1] == found[2]
    assert found[0] == pytest.approx(0.942746, rel=1e-3)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (
            ("1e-4 0", "0 0"),
            r"bodyThickness is 0; it must be between .* one of the bodies needs it .* 1 and 2",
        ),
        (
            ("0 0", "1e-4 0"),
            r"cylinderLength is 0; it must be between .* one of the bodies needs it",
        ),
        (("-1e-4 0", "1e-4 0"), r"cylinderLength is -0.0001; it must be .* \(atom type 1\)"),
        (("1e-4 0", "1e9 0"), r"bodyThickness is 1e\+09; it must be .* \(atom type 1\)"),
    ],
)
def test_lengths_that_cannot_be_are_refused(given, said, tmp_path):
    with pytest.raises(EngineError, match=f"model lim_stronge: {said}"):
        run(deck(lengths=lengths(*given)), tmp_path, law="lim_stronge")


def test_a_missing_length_is_named(tmp_path):
    text = deck(lengths=("\npair_style", "\nunfix cylinder_length\npair_style"))
    with pytest.raises(EngineError, match="katta_polycarpou: property cylinderLength is missing"):
        run(text, tmp_path)


@pytest.mark.parametrize("name", CYLINDER_LAWS)
def test_a_deck_in_three_dimensions_is_refused(name, tmp_path):
    with pytest.raises(EngineError, match=f"model {name}: the law is for cylinders.*dimension 2"):
        run_deck("collision/sphere_wall.in", {"law": name}, tmp_path)


@pytest.mark.parametrize(("radius", "speed"), [(1e-6, 0.1), (1e-5, 1e-3), (5e-4, 1), (5e-2, 0.01)])
def test_the_deck_runs_until_the_cylinder_has_left(radius, speed, tmp_path):
    """Cylinders of any size, slow and fast, have the restitution of the law within 1.1e-3. The
    recommended step causes this error.
    """
    case = CylinderImpact("lim_stronge", speed, "glass_kp10", radius, body_thickness=10 * radius)
    expected = case.predict().coefficient_of_restitution
    assert case.run(tmp_path).coefficient_of_restitution == pytest.approx(expected, abs=1.1e-3)


@pytest.mark.parametrize("name", CYLINDER_LAWS)
def test_viscous_damping(name, tmp_path):
    """With `viscous_damping on`, a dashpot 2 sqrt(5/6) beta sqrt(S m) acts in addition to the law.

    S is the slope of the elastic force, m the mass, and beta the damping ratio that follows from
    the restitution. The impact is below yield. The reference is the motion, integrated by scipy.
    """
    damped = ("xplane 0.0", "xplane 0.0 viscous_damping on")
    given = "fix r all property/global coefficientRestitution peratomtypepair 2 .8 .8 .8 .8"
    text = deck(wall=damped, given=("\npair_style", f"\nunfix restitution\n{given}\npair_style"))
    run(text, tmp_path, law=name, speed=0.2, timestep=4e-9)
    found = measure(tmp_path / "trajectory.dump").coefficient_of_restitution

    impact = CylinderImpact(name, 0.2, "glass_kp10", 1e-5)
    law, state = impact.contact_law(), impact.contact_law().State()
    beta = -np.log(0.8) / np.hypot(np.log(0.8), np.pi)

    def motion(_, y):
        answer = law.respond(1e-5, y[0], state)
        if answer.force == 0:
            return [y[1], 0]
        far = 2 * np.log(2e-4 / answer.contact_radius) - 0.23 / 0.77
        slope = np.pi * 83.96e9 * 1e-4 / (far - 1)
        dashpot = 2 * np.sqrt(5 / 6) * beta * np.sqrt(slope * 1.59e-6)
        return [y[1], -max(0, answer.force + dashpot * y[1]) / 1.59e-6]

    path = solve_ivp(motion, (0, 5e-6), [1e-12, 0.2], "DOP853", rtol=1e-9, max_step=5e-9)
    assert 0.75 < found < 0.9
    assert found == pytest.approx(-path.y[1, -1] / 0.2, rel=1e-3)


def test_bodies_that_come_later_are_refused_at_their_touch(tmp_path):
    """A contact whose type pair appears after the check of the run is refused when it forms.

    Here, the cylinder gets the atom type of the wall after the first run.
    """
    later = """
timestep ${timestep}
fix i all nve/sphere
run 1
set atom 1 type 2
run 100 pre no
"""
    text = deck(run=("include ${inputs}/collision/parts/run.in", later))
    with pytest.raises(EngineError, match=r"cylinderLength is 0; .* \(atom types 2 and 2\)"):
        run(text, tmp_path, gap=1e-7)
    assert "Step" in (tmp_path / "log.liggghts").read_text(errors="replace")
