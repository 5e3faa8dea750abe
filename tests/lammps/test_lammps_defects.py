# SPDX-License-Identifier: GPL-2.0-or-later
"""The decks of docs/lammps_defects.md show the defects that the page states."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from lammps_scenes import run

from plastigran.engine.process import PROJECT, EngineError

PAGE = (PROJECT / "docs" / "lammps_defects.md").read_text()
WRITE_RESTART, MIXED_TYPES, READ_RESTART, OPEN_END, CYLINDER = re.findall(
    r"```\n(.*?)```", PAGE, re.DOTALL
)


def result(folder: Path, script: str, **variables: object) -> float:
    return float(re.findall(r"^result (\S+)", run(folder, script, **variables), re.MULTILINE)[-1])


def test_write_restart_changes_the_run_that_follows(tmp_path):
    energies = [result(tmp_path, WRITE_RESTART, writes=writes) for writes in ("no", "yes")]
    for energy in energies:
        assert f"{energy:.3e}".replace("e-0", "e-") in PAGE
    assert energies[0] != energies[1]


def test_mixed_types_have_another_tangential_stiffness(tmp_path):
    """Between two types, the tangential stiffness is 1/(2 (1 - nu^2)) times that within one type.

    The relative tolerance is 2e-3, because the force slows the spheres during the step. The
    tolerance was set after the first comparison.
    """
    forces = [result(tmp_path, MIXED_TYPES, other=other) for other in (1, 2)]
    assert forces[1] / forces[0] == pytest.approx(1 / (2 * (1 - 0.3**2)), rel=2e-3)


def test_read_restart_loses_the_cutoff(tmp_path):
    """The cutoff is undefined, so LAMMPS warns that it is 0, or stops because it is too large."""
    try:
        log = run(tmp_path, READ_RESTART)
    except EngineError as error:
        log = str(error)
    assert "Communication cutoff is 0.0" in log or "box size << cutoff" in log


def test_a_contact_at_an_open_end_loses_its_history(tmp_path):
    forces = [result(tmp_path, OPEN_END, end=end) for end in (1, 0)]
    for force in forces:
        assert f"{force:.1f}".replace("-", "−") in PAGE
    assert abs(forces[1]) < 0.6 * abs(forces[0])


def test_grains_change_the_velocity_of_a_rotating_cylinder(tmp_path):
    force, other = (result(tmp_path, CYLINDER, count=count) for count in (1, 2))
    assert f"{force:.4f}".replace("-", "−") in PAGE
    assert other == 0
