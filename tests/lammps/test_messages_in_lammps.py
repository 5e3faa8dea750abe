# SPDX-License-Identifier: GPL-2.0-or-later
"""The LAMMPS plugin refuses wrong lines and prints warnings."""

from __future__ import annotations

import pytest
from lammps_scenes import FRICTION, box, numbered, run, sphere

from plastigran.engine.process import EngineError

BODY = "7e10 0.3 yield_strength 3e8"
PAIR = "pair_style granular/plastigran\n"
GOOD = f"{PAIR}pair_coeff * * thornton {BODY} {FRICTION}\n"
PLAIN = f"{PAIR}pair_coeff * * thornton {BODY}"
TWO = f"{PAIR}pair_coeff 1 1 thornton {BODY} {FRICTION}\npair_coeff 2 2 "
WALL = "fix floor all wall/gran/plastigran granular "
RESTART = """run 0
write_restart spheres.restart
clear
read_restart spheres.restart
comm_modify vel yes
"""


def line(words: str) -> str:
    return f"{PAIR}pair_coeff * * {words} {FRICTION}"


def script(lines: str) -> str:
    spheres = numbered([sphere(0.0051, 0, 0, -0.1), sphere(-0.0051, 0, 0, 0.1)])
    motion = "fix motion all nve/sphere\ntimestep 1e-7\n"
    return f"{box(0.05, types=2)}{spheres}{motion}{lines}\nrun 0\n"


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (line(f"thorton {BODY}"), "there is no law `thorton`; choose one of"),
        (line("thornton 7e10 soft"), "the law is followed by `7e10 soft`; give Young's modulus"),
        (line("thornton body unobtainium"), "body: there is no file unobtainium; give the path"),
        (line("thornton 7e10 0.7 yield_strength 3e8"), "poissons_ratio is 0.7"),
        (line("thornton 7e10 0.3"), "thornton: yield_strength"),
        (line("thornton 7e10 0.3 yield_strength high"), "yield_strength is `high`; it must be a"),
        (line(f"thornton {BODY} hardness 3"), "there is no constant or option `hardness`; the law"),
        (line(f"thornton {BODY} viscous -1"), "viscous is -1; it must be a number, 0 or more"),
        (
            line(f"thornton {BODY} viscous 2") + " damping tsuji",
            "viscous is 2; with this damping model it must be a coefficient of restitution, 0 to 1",
        ),
        (f"{PLAIN} tangential partial_slip", "give the coefficient of friction, 0 or more"),
        (f"{PLAIN} tangential partial_slip 0.5 rings 9", "rings is `9`; it must be a whole number"),
        (f"{PLAIN} tangential partial_slip 0.5 rings inf", "rings is `inf`; it must be a whole"),
        (f"{PLAIN} tangential partial_slip 0.5 rings 8 rings 3", "`rings` is given twice"),
        (f"{PLAIN} {FRICTION} tangential incremental 0.5", "`tangential` is given twice"),
        (
            f"{PLAIN} tangential incremental 0.5 twisting marshall",
            "works only with LAMMPS' own tangential models, not with `incremental`",
        ),
        (f"{PAIR}pair_coeff * * thornton {BODY} cutoff", "Illegal pair_coeff"),
        (f"{PAIR}pair_coeff * * thornton {BODY} hardness", "the value of hardness is missing"),
        (
            line(f"thornton {BODY} yield_strength 3e9"),
            "yield_strength is given twice; give it once",
        ),
        (f"{GOOD}compute energy all plastigran/energy all", "unknown word all; remove it"),
        (f"{PAIR}pair_coeff * *", "pair_coeff: words are missing; give atom types, law and body"),
        (line(f"jkr {BODY}"), "jkr: surface_energy"),
        (line(f"universal {BODY} yielding cube"), "yielding is cube; it must be"),
        (line(f"lim_stronge {BODY}"), "the law is for cylinders; use a law for spheres"),
        (line(f"thornton {BODY} adhesion glue"), "adhesion is glue; it must be off or jkr"),
        (line(f"thornton {BODY} adhesion jkr"), "thornton: surface_energy is missing"),
        (line(f"jkr {BODY} adhesion jkr"), "not supported, because the law has its own adhesion"),
        (line("thornton mixed"), "with the atom type `*`; give two single atom types, 1 to 2"),
        (
            f"{TWO}thornton {BODY} {FRICTION}\npair_coeff 1 7 thornton mixed {FRICTION}",
            "with the atom type `7`; give two single atom types, 1 to 2",
        ),
        (f"{PAIR}pair_coeff 1 2 thornton mixed {FRICTION}", "has no body; give `pair_coeff"),
        (
            f"{GOOD}pair_coeff 1 1 thornton mixed {FRICTION}",
            "pair_coeff 1 1: `mixed` needs two different atom types",
        ),
        (f"{TWO}universal {BODY} {FRICTION}", "types 1 and 2 have different laws, constants or"),
        (f"{TWO}thornton {BODY} tangential mindlin NULL 1.0 0.5", "types 1 and 2 have different"),
        (
            f"{PAIR}pair_coeff 1 1 thornton {BODY} tangential incremental 0.5\n"
            f"pair_coeff 2 2 thornton {BODY} tangential partial_slip 0.5",
            "types 1 and 2 have different laws, constants or models",
        ),
        (
            f"{PAIR}pair_coeff 1 1 thornton {BODY} tangential partial_slip 0.5 rings 2\n"
            f"pair_coeff 2 2 thornton {BODY} tangential partial_slip 0.5",
            "types 1 and 2 have different laws, constants or models",
        ),
        (f"{GOOD}{WALL}hertz", "fix wall/gran/plastigran: the style must be followed by `granular"),
        (f"{WALL}hertz rigid {FRICTION} xplane 0 NULL", "the bodies of the particles are missing"),
        (
            f"{GOOD}{WALL}hertz mixed {FRICTION} xplane 0 NULL",
            "`mixed` is only for pairs of atom types; give",
        ),
        (
            f"{TWO}thornton 9e10 0.3 yield_strength 3e8 {FRICTION}\n"
            f"{WALL}thornton rigid {FRICTION} xplane 0 NULL",
            "the atom types have different shear moduli, but a wall has one tangential stiffness",
        ),
        (
            "pair_style hybrid/overlay granular granular/plastigran\n"
            f"pair_coeff * * granular hertz/material 7e10 0.5 0.3 {FRICTION}\n"
            f"pair_coeff * * granular/plastigran thornton {BODY} {FRICTION}",
            "`pair_style hybrid` has a second granular style",
        ),
        ("compute energy all plastigran/energy", "needs `pair_style granular/plastigran`"),
        (f"{GOOD}minimize 0 0 1 1", "`minimize` would change the contact history"),
        (
            f"{GOOD}compute energy all plastigran/energy\nunfix plastigran_energy",
            "compute energy plastigran/energy: `unfix` has removed its fix plastigran_energy",
        ),
        (
            f"{GOOD}compute energy all plastigran/energy\nunfix plastigran_work",
            "`unfix` has removed the fix plastigran_work, which stores values of the particles",
        ),
        ("pair_style granular/plastigran 1 2", "unknown word 2; give at most a cutoff"),
        (
            line(f"thornton {BODY} rate_coefficient 0.01 surface_energy 0.1 adhesion jkr"),
            "rate_coefficient is 0.01; it must be 0 with adhesion",
        ),
        (
            f"{GOOD}run 0\npair_coeff * * universal {BODY} {FRICTION}",
            "atom types 1 and 1 have another law or other models than in the last run",
        ),
        (
            f"{TWO}thornton {BODY} {FRICTION}\nrun 0\n"
            f"pair_coeff 2 2 thornton {BODY} rate_coefficient 0.01 {FRICTION}\n"
            f"pair_coeff 1 2 thornton mixed {FRICTION}",
            "atom types 2 and 2 have another law or other models than in the last run",
        ),
        (
            f"{TWO}thornton {BODY} {FRICTION}\n{RESTART}pair_coeff 1 2 universal mixed {FRICTION}",
            "atom types 1 and 2 have another law or other models than in the last run",
        ),
        (
            # The third line replaces the model of the second line, whose history has more values.
            # LAMMPS deletes this unused model only at the restart.
            f"{TWO}thornton {BODY} rate_coefficient 0.01 {FRICTION}\n"
            f"pair_coeff 2 2 thornton {BODY} {FRICTION}\n{RESTART}",
            "new pair_coeff lines move the values in the contact history",
        ),
        (
            f"{GOOD}{WALL}thornton rigid {FRICTION} xplane 0 NULL\n{RESTART}"
            f"{WALL}stronge rigid {FRICTION} xplane 0 NULL",
            "fix floor: the restart file has another law or other models",
        ),
        (
            f"{GOOD}{WALL}thornton rigid {FRICTION} xplane 0 NULL\n{RESTART}"
            f"{WALL}thornton rigid tangential partial_slip 0.5 xplane 0 NULL",
            "fix floor: the restart file has another law or other models",
        ),
        (
            f"{GOOD}{WALL}thornton rigid {FRICTION} xplane 0 NULL\n"
            f"pair_coeff * * thornton {BODY} rate_coefficient 0.01 {FRICTION}",
            "new pair_coeff lines change the number of history values",
        ),
        (
            f"{GOOD}{WALL}thornton rigid {FRICTION} xplane 0 NULL\npair_style none",
            "fix wall/gran/plastigran: the pair style has changed",
        ),
    ],
)
def test_a_wrong_line_is_refused(lines, message, tmp_path):
    with pytest.raises(EngineError) as error:
        run(tmp_path, script(lines))
    assert message in str(error.value)


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (["youngs_modulus index 7e10"], "does not define poissons_ratio; add a line"),
        (
            ["youngs_modulus index 7e10", "poissons_ratio index 0.3", "poissons_ratio index 0.2"],
            "defines poissons_ratio twice; define it once",
        ),
    ],
)
def test_a_wrong_material_file_is_refused(lines, message, tmp_path):
    file = tmp_path / "metal.in"
    file.write_text("".join(f"variable {line}\n" for line in lines))
    with pytest.raises(EngineError) as error:
        run(tmp_path / "run", script(line(f"hertz body {file}")))
    assert message in str(error.value)


def test_units_with_conversion_factors_are_refused(tmp_path):
    with pytest.raises(EngineError, match="needs units in which force is mass times acceleration"):
        run(tmp_path, script(GOOD).replace("units si", "units metal"))


def test_warnings(tmp_path):
    """The log warns of a long time step, and of an overlap outside the range of `vu_quoc_zhang`."""
    log = run(
        tmp_path,
        script(line("vu_quoc_zhang 7e10 0.3 yield_strength 1e8") + "\ntimestep 1e-5\nrun 115"),
    )
    assert "the time step is 1e-05 s; at most" in log
    assert "have exceeded the validity range of the law" in log
