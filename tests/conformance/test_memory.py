# SPDX-License-Identifier: GPL-2.0-or-later
"""Contact history survives the commands of decks between two runs, and restart files contain it."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from scenes import GEOMETRIES, Cylinders, scene

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import EngineStopped

# What the deck between_runs.in did before each frame. It writes one frame per step, and one at the
# start of each run.
STAGES = (
    "held",
    "held",
    "deleted",
    "deleted twice",
    "created",
    "created and deleted",
    "of another type",
    "moved to other ranks",
    *["run in pieces"] * 3,
    *["step count restarted"] * 2,
    "restart file written",
    *["neighbor pages changed"] * 2,
    "nothing deleted",
    "pair_style again",
    "wall again",
    *["inserted"] * 5,
)


def held_forces(folder: Path) -> np.ndarray:
    """Return the forces (frame, body, axis) [N]; the bodies are the sphere at the wall and the
    pair, from left to right.
    """
    table = read_dump(folder / "trajectory.dump")
    bodies = [frame.sort_values("x")[["fx", "fy", "fz"]] for _, frame in table.groupby("step")]
    return np.array([frame.to_numpy() for frame in bodies])


def assert_held(forces: np.ndarray, stages: tuple[str, ...]) -> None:
    """Check that the forces stay the same after all commands of the deck (`stages`).

    The tangential spring must contribute to them. The tolerance is 1e-9 of the largest component,
    because moving all bodies by 70 mm changes the round-off of the overlap, which is only 7 um.
    """
    first = forces[0]
    assert np.all(np.abs(first[:, 1]) > 0.03 * np.abs(first[:, 0])), "no spring is stretched"
    assert len(forces) == len(stages)
    scale = np.abs(first).max(axis=1)
    for stage, now in zip(stages, forces, strict=True):
        assert np.abs(now - first).max(axis=1) / scale == pytest.approx(0, abs=1e-9), stage


def between_runs(law: str, folder: Path, ranks: int = 1, **variables: object) -> None:
    bodies, stages = scene(law), STAGES
    if isinstance(bodies, Cylinders):
        variables, stages = {"other": 1, **variables}, STAGES[: STAGES.index("inserted") + 1]
    bodies.run("between_runs", folder, ranks=ranks, **variables)
    assert_held(held_forces(folder), stages)


def test_memory_outlives_what_decks_do_between_runs(engine_law, tmp_path):
    between_runs(engine_law, tmp_path)


@pytest.mark.parametrize(
    ("grid", "variables"),
    [
        ("1 1", {"sort": 0, "compress": "no", "wall": "mesh"}),
        ("2 1", {"sort": 1, "compress": "yes", "wall": "mesh"}),
        ("1 2", {"sort": 0, "compress": "yes"}),
        ("2 2", {"sort": 1, "compress": "no"}),
    ],
)
def test_memory_outlives_them_on_all_ranks(grid, variables, tmp_path):
    """Contacts keep their history after all commands of between_runs.in, on one to four ranks.

    The contact of the pair lies on the border between ranks, at x = 0 and y = 0, and moves.
    """
    ranks = int(np.prod([int(number) for number in grid.split()]))
    between_runs("thornton", tmp_path, ranks, grid=grid, **variables)


def run_with(
    commands: str, law: str, folder: Path, deck: str = "held_commands", **variables
) -> str:
    """Run a deck that includes commands, which `; ` separates; return the log."""
    folder.mkdir(exist_ok=True)
    (folder / "commands.in").write_text(commands.replace("; ", "\n") + "\n")
    return scene(law).run(deck, folder, commands=folder / "commands.in", **variables)


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("wall", ["plane", "mesh"])
def test_memory_outlives_a_restart_file_without_the_lines(wall, ranks, tmp_path):
    """Contacts keep their history if a deck replaces their pair_style line and deletes their wall.

    The deck then writes a restart file, deletes particles, and gives both lines again.
    """
    commands = (
        "pair_style gran model hertz tangential history; pair_coeff * *; unfix wall; "
        "delete_atoms group first compress yes; write_restart ${output}/middle.restart; "
        "delete_atoms group third compress yes; "
        "pair_style gran model ${law} tangential history; pair_coeff * *; "
        "include ${decks}/held_${wall}.in"
    )
    run_with(commands, "thornton", tmp_path, ranks=ranks, grid=f"{ranks} 1", wall=wall)
    assert_held(held_forces(tmp_path), ("held",) * 3)


def test_memory_of_hertz_outlives_what_decks_do_between_runs(tmp_path):
    """Contacts of LIGGGHTS' own hertz keep their history between runs, too.

    The pair_style line has hertz in all runs. The wall gets a law before the second run.
    """
    commands = (
        "unfix wall; "
        "fix wall all wall/gran model thornton tangential history primitive type 2 xplane -0.45; "
        "run 1; neigh_modify one 3000 page 300000; delete_atoms group first compress yes; run 1; "
        "pair_style gran model hertz tangential history; pair_coeff * *; "
        "delete_atoms group third compress yes"
    )
    (tmp_path / "commands.in").write_text(commands.replace("; ", "\n") + "\n")
    case = {"law": "hertz", "commands": tmp_path / "commands.in"}
    scene("thornton").run("held_commands", tmp_path, **case)
    assert_held(held_forces(tmp_path)[:, 1:], ("held",) * 5)


OTHER_LINES = {
    "pair_style": (
        "pair_style gran model stronge tangential history unloading original_radius; "
        "pair_coeff * *",
        [1, 2],
    ),
    "fix wall": (
        "unfix wall; fix wall all wall/gran model thornton tangential history "
        "primitive type 2 xplane -0.45",
        [0],
    ),
}


@pytest.mark.parametrize("owner", OTHER_LINES)
def test_contacts_of_another_line_begin_anew(owner, tmp_path):
    """The log reports a changed option or law, and only the contacts of that line start without
    history. Their force changes by at least 30 %, because the contacts were unloaded by a tenth of
    the overlap.
    """
    commands, changed = OTHER_LINES[owner]
    log = run_with(commands, "stronge", tmp_path)
    begins = f"WARNING: plastigran: {owner}: contacts start without history, because the models "
    assert (
        f"{begins}of these contacts changed from `model stronge tangential history unloading book"
        in log
    )
    assert log.count("start without history") == 1
    before, after = held_forces(tmp_path)[[0, -1]]
    ratio = np.abs(after[:, 0] / before[:, 0])
    stays = [k for k in range(3) if k not in changed]
    assert ratio[stays] == pytest.approx(1, rel=1e-9)
    assert np.all(np.abs(ratio[changed] - 1) > 0.3)
    assert np.all(np.abs(after[changed, 1]) < 1e-3 * np.abs(before[changed, 1])), "springs remain"


def test_a_wall_elsewhere_is_another(tmp_path):
    """If a deck defines a plane again one micrometer away, its contact starts without history.

    The plane has the same ID. The log reports the lost history.
    """
    line = "unfix wall; fix wall all wall/gran model stronge tangential history primitive type 2 "
    log = run_with(line + "xplane -0.450001", "stronge", tmp_path)
    assert (
        "fix wall: contacts start without history, because the position of the wall changed" in log
    )
    before, after = held_forces(tmp_path)[[0, -1]]
    assert abs(after[0, 1]) < 1e-3 * abs(before[0, 1]), "the tangential spring is stretched"
    assert after[1:] == pytest.approx(before[1:], rel=1e-9)


def test_memory_that_ends_with_a_line_is_told_of(tmp_path):
    """If a repeated `pair_style` line has models without contact history, LIGGGHTS deletes the
    stored histories, and the log says so.
    """
    log = run_with(
        "pair_style gran model hertz tangential off; pair_coeff * *", "stronge", tmp_path
    )
    assert "the models of these contacts changed from `model stronge tangential history" in log
    assert log.count("pair_style: contacts start without history") == 1


def test_contacts_without_memory_begin_anew_in_silence(tmp_path):
    commands = "pair_style gran model thornton tangential off; pair_coeff * *"
    log = run_with(commands, "viscoelastic_hertz", tmp_path, tangential="off")
    assert "start without history" not in log


SETTINGS = "unloading original_radius viscous_damping on tangential_damping off overlap_limit 0.25"


def test_restart_has_the_settings_of_the_line(tmp_path):
    """Without a pair_style line, a run from a restart file has the options and settings of the
    file, and is bitwise identical.
    """
    case, before = {"after": 160, "coefficient_of_restitution": 0.7}, 40
    bodies = scene("stronge")
    for name, options in (("whole", SETTINGS), ("other", SETTINGS.replace(" on", " off"))):
        bodies.run("restart_write", tmp_path / name, before=before, options=options, **case)
    restart = (tmp_path / "whole" / "middle.restart").resolve()
    log = bodies.run("restart_read", tmp_path / "rest", restart=restart, **case)
    assert "unloading original_radius" in log
    tables = {name: read_dump(tmp_path / name / "trajectory.dump") for name in ("whole", "rest")}
    # The dashpot force at the start of a run uses the velocities at that time.
    whole, rest = (
        table[table["step"] > before].drop_duplicates(["step", "id"]) for table in tables.values()
    )
    assert len(rest) == len(whole)
    assert (rest.to_numpy() == whole.to_numpy()).all()
    other = read_dump(tmp_path / "other" / "trajectory.dump")
    assert abs(other["vx"].iloc[-1] / rest["vx"].iloc[-1] - 1) > 0.01, "the settings have no effect"


@pytest.mark.parametrize(
    ("owner", "commands", "variables"),
    [
        ("pair_style", "pair_style gran model stronge tangential history; pair_coeff * *", {}),
        ("fix wall", "", {"wall_options": "unloading original_radius"}),
    ],
)
def test_restart_with_another_law_is_refused(owner, commands, variables, tmp_path):
    case = {"geometry": "plane", "after": 1}
    options = SETTINGS if owner == "pair_style" else ""
    scene("stronge").run("restart_write", tmp_path, before=40, options=options, **case)
    case["restart"] = (tmp_path / "middle.restart").resolve()
    with pytest.raises(
        EngineStopped, match=f"{owner}: the restart file has contacts of `model str"
    ):
        run_with(commands, "stronge", tmp_path, "restart_read", **case, **variables)


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_a_restart_with_other_constants_is_told_of(geometry, ranks, tmp_path):
    """The log reports constants that differ from the restart file.

    The residual indentations of the contacts belong to the constants of the file.
    """
    case = {"geometry": geometry, "after": 1}
    bodies = scene("stronge")
    bodies.run("restart_write", tmp_path, before=40, **case)
    case["restart"] = (tmp_path / "middle.restart").resolve()
    assert "other constants" not in bodies.run("restart_read", tmp_path / "same", ranks, **case)
    log = bodies.run("restart_read", tmp_path / "other", ranks, yield_strength=5e8, **case)
    owner = "pair_style" if geometry == "pair" else "fix wall"
    said = (
        rf"{owner}: contacts continue with other constants: `model stronge, .*yield strength 1e\+08"
    )
    assert re.search(said + r" Pa.*` is now `model stronge, .*yield strength 5e\+08 Pa", log)


def test_other_constants_between_runs_are_told_of(tmp_path):
    other = "fix yield_strength all property/global yieldStrength peratomtype 5e8 1e30"
    log = run_with(f"unfix yield_strength; {other}", "stronge", tmp_path)
    assert log.count("pair_style: contacts continue with other constants") == 1
    elastic = {"tangential": "off", "yield_strength": 1e30}
    log = run_with(f"unfix yield_strength; {other}", "stronge", tmp_path, **elastic)
    assert "other constants" not in log, "contacts without history have no earlier constants"
    another = "pair_style gran model thornton tangential history; pair_coeff * *"
    log = run_with(another, "stronge", tmp_path)
    assert "start without history" in log and "other constants" not in log


STRENGTH = "fix yield_strength all property/global yieldStrength peratomtype {} 1e30"
#: Command that sets up the contacts without a run.
SET_UP = "delete_atoms overlap 1e-6 all all"


def test_constants_are_compared_from_run_to_run(tmp_path):
    """Constants that are changed and restored between two runs do not matter, even if a command
    sets up the contacts meanwhile.
    """
    again = [STRENGTH.format(strength) for strength in ("5e8", "1e8", "7e8")]
    there = f"unfix yield_strength; {again[0]}; {SET_UP}; unfix yield_strength; "
    assert "other constants" not in run_with(there + again[1], "stronge", tmp_path / "back")
    log = run_with(there + again[2], "stronge", tmp_path / "on")
    (said,) = re.findall("pair_style: contacts continue with other constants: (.*)", log)
    assert "strength 1e+08 Pa" in said and "strength 7e+08 Pa" in said


def test_a_default_that_is_said_is_the_same_constant(tmp_path):
    log = run_with("", "vu_quoc_zhang", tmp_path / "assumed")
    assumed = re.search(r"contactRadiusCoefficient (\S+) \(default\)", log)[1]
    said = (
        f"fix c all property/global contactRadiusCoefficient peratomtypepair 2{4 * f' {assumed}'}"
    )
    log = run_with(said, "vu_quoc_zhang", tmp_path / "said")
    assert "other constants" not in log


@pytest.mark.parametrize("fix", ["range", "step", "motion", "history"])
def test_own_fixes_may_be_removed(fix, tmp_path):
    """A deck may remove a fix that the plugin added. The forces of the next run do not change.

    The next run then does its setup, even with `pre no`.
    """
    log = run_with(f"unfix plastigran_{fix}; run 2 pre no", "thornton", tmp_path)
    assert_held(held_forces(tmp_path), ("held",) * 5)
    assert log.count("Setting up run") == 5


LEDGER, LINE = {"options": "energy_ledger on"}, "gran model {} tangential history; pair_coeff * *"
NO_LONGER = "the line has no energy_ledger on, but an earlier line"
REFUSED = {
    "energy_ledger on: its fix was removed": ("unfix energy_ledger; run 3 pre no", LEDGER),
    "its fix plastic_work was removed": ("unfix plastic_work; run 3 pre no", LEDGER),
    f"{NO_LONGER}": ("pair_style " + LINE.format("thornton"), LEDGER),
    f"{NO_LONGER}.": ("pair_style " + LINE.format("hertz"), LEDGER),
    "A command in `run ... every` cannot remove it": (
        "run 4 pre no every 1 'unfix plastigran_range'",
        {},
    ),
    "LIGGGHTS cannot replace a wall with the same ID": (
        "fix wall all wall/gran model thornton tangential history primitive type 2 xplane -0.45",
        {},
    ),
    "energy_ledger on: fix rigid is not supported": ("fix body pair rigid single", LEDGER),
}


@pytest.mark.parametrize("message", REFUSED)
def test_what_would_go_wrong_is_refused(message, tmp_path):
    commands, variables = REFUSED[message]
    with pytest.raises(EngineStopped, match=message):
        run_with(commands, "thornton", tmp_path, **variables)


def test_a_ledger_ends_with_its_fixes_and_lines(tmp_path):
    commands = "unfix energy_ledger; unfix plastic_work; pair_style " + LINE.format("thornton")
    run_with(commands, "thornton", tmp_path, **LEDGER)
    assert_held(held_forces(tmp_path), ("held",) * 3)


def test_a_laws_options_are_in_restart_files(engine_law, tmp_path):
    """Restart files contain every option of the law with its name."""
    run_with(f"write_restart {tmp_path}/held.restart", engine_law, tmp_path)
    held = (tmp_path / "held.restart").read_bytes()
    assert b"overlap_limit" in held
    for option in laws.LAWS[engine_law].options():
        assert re.search(rf"{option['name']} {option['default']}[\s\0]".encode(), held)
