# SPDX-License-Identifier: GPL-2.0-or-later
"""Energy, adhesion, mixed atom types and deleted grains in LAMMPS."""

from __future__ import annotations

import re
from pathlib import Path

import attrs
import numpy as np
import pandas as pd
import pytest
from lammps_scenes import (
    FRICTION,
    MATERIAL,
    RADIUS,
    body,
    box,
    constants,
    numbered,
    run,
    sphere,
    thermo,
    words,
)
from numpy.testing import assert_allclose

import plastigran as pg
from plastigran.engine.process import EngineError
from plastigran.materials import read_material

#: Kinetic, elastic, plastic and surface energy, and loss by adhesion.
ENERGY = [f"c_energy[{k}]" for k in (1, 3, 4, 11, 12)]


def pair_of_spheres(
    folder: Path, lines: str, speed: float, step: float, steps: int, ranks: int = 1, first: str = ""
) -> pd.DataFrame:
    """Collide two spheres, of types 1 and 2, head-on; return 100 outputs.

    Args:
        folder: Folder of the run.
        lines: Lines `pair_coeff`.
        speed: Speed of each sphere [m/s].
        step, steps: Time step [s] and number of time steps.
        ranks: Number of MPI ranks; the spheres are on different ranks.
        first: First line of the script.
    """
    spheres = [sphere(RADIUS + 1e-9, 0, 0, -speed), sphere(-RADIUS - 1e-9, 0, 0, speed)]
    log = run(
        folder,
        f"""{first}
        processors * 1 1
        {box(8 * RADIUS, types=2)}{numbered(spheres)}
        set atom 2 type 2
        pair_style granular/plastigran
        {lines}
        fix motion all nve/sphere
        compute energy all plastigran/energy
        variable overlap equal {2 * RADIUS:.17g}-x[1]+x[2]
        variable out equal vx[1]
        timestep {step:.17g}
        thermo {steps // 100}
        thermo_style custom step ke c_energy[*] v_overlap v_out
        thermo_modify norm no format float %.15g
        run {steps // 100 * 100}
        """,
        ranks,
    )
    return thermo(log)


def check_balance(table: pd.DataFrame) -> None:
    """Check the sum of kinetic, elastic and surface energy, plastic work and loss by adhesion. It
    is constant to a relative 1e-4, because the force of a law may jump by some per cent within a
    step.
    """
    total = table[ENERGY].sum(axis=1)
    assert_allclose(total, total[0], rtol=1e-4)
    assert table["c_energy[4]"].iloc[-1] > 0.3 * total[0]  # plastic work
    assert (table["c_energy[13]"].iloc[10], table["c_energy[13]"].iloc[-1]) == (1, 0)  # contacts


@pytest.mark.parametrize("law", ["thornton", "kogut_etsion", "universal", "thornton_ning_1998"])
def test_energy_is_conserved_in_a_collision(law, tmp_path):
    line = f"pair_coeff * * {law} {body()} {words(constants(law))} {FRICTION}"
    check_balance(pair_of_spheres(tmp_path, line, 0.05, 2e-8, 20000))


@pytest.mark.parametrize("newton", ["on", "off"])
def test_energy_is_conserved_in_a_collision_between_ranks(newton, tmp_path):
    line = f"pair_coeff * * universal {body()} {FRICTION}"
    check_balance(pair_of_spheres(tmp_path, line, 0.05, 2e-7, 1000, 2, f"newton {newton}"))


def test_a_contact_with_adhesion_stretches_until_it_breaks(tmp_path):
    contact = pg.Contact(
        "jkr", MATERIAL, MATERIAL, radius=RADIUS, radius_other=RADIUS, surface_energy=10
    )
    line = f"pair_coeff * * jkr {body()} surface_energy 10 {FRICTION}"
    table = pair_of_spheres(tmp_path, line, 0.01, 1e-8, 20000)
    stretched = table[(table["c_energy[13]"] == 1) & (table["v_overlap"] < 0)]
    reach = contact.law.pull_off_distance(contact.radius_eff)
    assert -reach < stretched["v_overlap"].min() < -0.5 * reach
    assert (stretched["c_energy[11]"] < 0).all()  # surface energy
    lost = 1 - contact.restitution(0.02) ** 2
    # The relative error 1e-3 arises in the steps in which the contact forms and breaks.
    assert_allclose(table["c_energy[12]"].iloc[-1] / table["KinEng"][0], lost, rtol=1e-3)


def test_types_of_one_material_behave_as_one_type(tmp_path):
    """Types of one material give the same motion as one type, also with the stiffness `NULL`.

    For `NULL`, LAMMPS itself would use another tangential stiffness between two types.
    """
    line = f"thornton {body()} {FRICTION}"
    tables = [
        pair_of_spheres(tmp_path / str(k), lines, 0.05, 1e-7, 2000)
        for k, lines in enumerate(
            [f"pair_coeff * * {line}", f"pair_coeff 1 1 {line}\npair_coeff 2 2 {line}"]
        )
    ]
    assert_allclose(tables[1], tables[0], rtol=1e-12)


def test_types_of_two_materials_get_the_law_between_both(tmp_path):
    """Types of two materials collide by the law between both, in any order of the lines.

    Restitution has an error of 1e-6 at a fifth of the recommended time step.
    """
    other = attrs.evolve(read_material("steel"), density=MATERIAL.density)
    bodies = {1: body(), 2: body(other)}
    own = [f"pair_coeff {k} {k} thornton {words} {FRICTION}\n" for k, words in bodies.items()]
    between = f"pair_coeff 1 2 thornton mixed {FRICTION}"
    contact = pg.Contact("thornton", MATERIAL, other, radius=RADIUS, radius_other=RADIUS)
    for k, lines in enumerate((own, own[::-1], [*own, between])):
        table = pair_of_spheres(tmp_path / str(k), "".join(lines), 0.05, 2e-8, 5000)
        assert_allclose(table["v_out"].iloc[-1] / 0.05, contact.restitution(0.1), atol=1e-6)


def test_grains_on_a_wall_with_adhesion_are_independent(tmp_path):
    """A grain that slides on the wall moves in the same way with and without distant grains."""
    results = []
    for places in ([(0, 0)], [(0, 0), (5e-4, 0), (0, 5e-4)]):
        grains = numbered([sphere(x, y, 9.995e-5, 0.02, 0.01) for x, y in places])
        law = "thornton 1e9 0.3 yield_strength 5e7 surface_energy 0.5 adhesion jkr"
        log = run(
            tmp_path / str(len(places)),
            f"""{box(1e-3)}{grains}
            set group all diameter 2e-4 density 2500
            pair_style granular/plastigran
            pair_coeff * * {law} tangential partial_slip 0.3
            fix floor all wall/gran/plastigran granular {law} tangential partial_slip 0.3 &
              zplane 0 NULL
            fix motion all nve/sphere
            timestep 2e-9
            variable vx equal vx[1]
            variable vy equal vy[1]
            thermo_style custom step v_vx v_vy
            thermo_modify format float %.15g
            run 2000
            """,
        )
        results.append(thermo(log).iloc[-1])
    assert results[0]["v_vx"] < 0.015
    assert_allclose(results[1], results[0], rtol=1e-12)


@pytest.mark.parametrize("wall", ["", "region/"])
def test_each_grain_on_a_wall_has_the_adhesion_of_its_type(wall, tmp_path):
    """A soft grain sticks until its own pull-off distance, also if a stiff grain touches the wall.

    The soft grain moves away from the wall, to half of its pull-off distance. The pull-off distance
    of the stiff grain is 100 times smaller.
    """
    soft = attrs.evolve(MATERIAL, youngs_modulus=1e7)
    contact = pg.Contact("jkr", soft, pg.RIGID, radius=RADIUS, surface_energy=0.5)
    reach = contact.law.pull_off_distance(RADIUS)
    spheres = [sphere(RADIUS - reach, 0, 0, 0.15 * reach), sphere(RADIUS - 1e-8, 0.03, 0, 0)]
    models = "surface_energy 0.5 tangential incremental 0"
    log = run(
        tmp_path,
        f"""{box(8 * RADIUS, types=2)}{numbered(spheres)}
        set atom 2 type 2
        pair_style granular/plastigran
        pair_coeff 1 1 jkr {soft.youngs_modulus} {soft.poissons_ratio} {models}
        pair_coeff 2 2 jkr 1e10 {soft.poissons_ratio} {models}
        region wall plane 0 0 0 1 0 0
        fix wall all wall/gran/{wall}plastigran granular jkr rigid {models} &
          {"region wall" if wall else "xplane 0 NULL"}
        fix motion all nve/noforce
        timestep 1
        variable force equal fx[1]
        thermo_style custom step v_force
        thermo_modify format float %.15g
        run 10
        """,
    )
    expected = contact.law.follow(RADIUS, [reach, -0.5 * reach])["force"][-1]
    assert expected < 0
    # The overlap has a round-off of 1e-16 RADIUS, which is 1e-12 of the reach.
    assert_allclose(thermo(log)["v_force"].iloc[-1], expected, rtol=1e-9)


@pytest.mark.parametrize("mixed", ["", "pair_coeff 1 2 thornton mixed"])
def test_repeated_lines_change_the_constants_of_all_pairs(mixed, tmp_path):
    """New lines before the second run add friction to all pairs of types: 1-1, 1-2 and 2-2."""
    pairs = [(x, y) for y in (0, 0.03, 0.06) for x in (0, 2 * RADIUS - 1e-6)]
    spheres = numbered([sphere(x, y, 0, 0, 0 if x else 0.01) for x, y in pairs])

    def lines(friction: float) -> str:
        laws = [f"pair_coeff {k} {k} thornton {body()}" for k in (1, 2)] + [mixed] * bool(mixed)
        return "\n".join(f"{law} tangential incremental {friction}" for law in laws)

    log = run(
        tmp_path,
        f"""{box(0.1, types=2)}{spheres}
        set atom 4*6 type 2
        pair_style granular/plastigran
        {lines(0)}
        fix motion all nve/sphere
        timestep 1e-8
        variable first equal fy[1]
        variable second equal fy[3]
        variable third equal fy[5]
        thermo_style custom step v_first v_second v_third
        run 10
        {lines(0.3)}
        run 10
        """,
    )
    forces = thermo(log)[["v_first", "v_second", "v_third"]]
    assert_allclose(forces.iloc[0], 0)
    assert (forces.iloc[-1] < -1e-3).all()
    assert_allclose(forces.iloc[-1], forces.iloc[-1, 0], rtol=1e-9)


def test_new_lines_change_the_bodies_of_a_mixed_pair(tmp_path):
    """A new line for type 1 before the second run also changes the law between types 1 and 2. The
    plastic work is the same as with this line from the start, because the compression begins in the
    second run.
    """
    weak, strong = (f"{body(attrs.evolve(MATERIAL, yield_strength=s))}" for s in (1e8, 3e8))
    lines = (
        "pair_coeff 1 1 thornton {} " + FRICTION + "\n"
        f"pair_coeff 2 2 thornton {strong} {FRICTION}\npair_coeff 1 2 thornton mixed {FRICTION}"
    )
    works = []
    for first in (weak, strong):
        spheres = [sphere(RADIUS + 1e-6, 0, 0, -0.2), sphere(-RADIUS - 1e-6, 0, 0, 0.2)]
        log = run(
            tmp_path / str(len(works)),
            f"""{box(8 * RADIUS, types=2)}{numbered(spheres)}
            set atom 2 type 2
            pair_style granular/plastigran
            {lines.format(first)}
            fix motion all nve/sphere
            compute energy all plastigran/energy
            timestep 1e-7
            thermo_style custom step c_energy[4]
            thermo_modify norm no format float %.15g
            run 1
            pair_coeff 1 1 thornton {weak} {FRICTION}
            run 1000
            """,
        )
        works.append(thermo(log)["c_energy[4]"].iloc[-1])
    assert works[0] > 0
    assert works[1] == works[0]


def test_new_lines_change_the_tangential_stiffness(tmp_path):
    """A new Young's modulus before the second run also changes the tangential stiffness `NULL`. The
    friction force is the same as with this modulus from the start, for a `mixed` pair and for a
    wall.
    """
    models = "tangential mindlin NULL 0 0.5"
    forces = []
    for first in (7e9, 7e10):
        places = (RADIUS - 1e-6, 0), (3 * RADIUS - 2e-6, 0.01), (RADIUS - 1e-6, 0.01)
        spheres = [sphere(x, 6 * RADIUS * (k > 0), 0, 0, v) for k, (x, v) in enumerate(places)]
        lines = "".join(f"pair_coeff {k} {k} hertz {{0}} 0.3 {models}\n" for k in (1, 2))
        log = run(
            tmp_path / str(first),
            f"""{box(8 * RADIUS, types=2)}{numbered(spheres)}
            set atom 1 vy 0.01
            set atom 3 vy 0
            set atom 2 type 2
            pair_style granular/plastigran
            {lines.format(first)}
            pair_coeff 1 2 hertz mixed {models}
            group first id 1
            fix wall first wall/gran/plastigran granular hertz rigid {models} xplane 0 NULL
            fix motion all nve/noforce
            timestep 1e-8
            variable pair equal fy[2]
            variable wall equal fy[1]
            thermo_style custom step v_pair v_wall
            thermo_modify format float %.15g
            run 0
            {lines.format(7e10)}
            run 10
            """,
        )
        forces.append(thermo(log).iloc[-1][["v_pair", "v_wall"]])
    assert (forces[1] < 0).all()
    assert_allclose(forces[0], forces[1], rtol=1e-12)


@pytest.mark.parametrize("law", ["walton_braun", "luding_2008"])
def test_linear_laws_have_their_own_tangential_stiffness(law, tmp_path):
    """The friction force of a sticking contact is 2/7 of the loading stiffness times the
    displacement, as in LIGGGHTS (docs/deck_syntax.md)."""
    values = constants(law)
    line = f"{words(values)} tangential incremental 10"
    log = run(
        tmp_path,
        f"""{box(8 * RADIUS)}{numbered([sphere(RADIUS - 1e-6, 0, 0, 0, 0.01)])}
        pair_style granular/plastigran
        pair_coeff * * {law} {body()} {line}
        fix wall all wall/gran/plastigran granular {law} rigid {line} xplane 0 NULL
        fix motion all nve/noforce
        timestep 1e-8
        variable force equal fy[1]
        thermo_style custom step v_force
        thermo_modify format float %.15g
        run 10
        """,
    )
    displacement = 10 * 1e-8 * 0.01
    expected = -2 / 7 * values["loading_stiffness"] * displacement
    assert_allclose(thermo(log)["v_force"].iloc[-1], expected, rtol=1e-9)


def test_a_restart_does_not_depend_on_the_material_file(tmp_path):
    """A run continued after a change of the material file ends like the run without restart."""
    material = "variable youngs_modulus index 7e10\nvariable poissons_ratio index 0.3\n"
    file = tmp_path / "soft.in"
    file.write_text(f"{material}variable yield_strength index 1e8\n")
    spheres = [sphere(RADIUS + 1e-9, 0, 0, -0.2), sphere(-RADIUS - 1e-9, 0, 0, 0.2)]
    end = """
        fix motion all nve/sphere
        variable out equal vx[1]
        timestep 1e-7
        thermo_style custom step v_out
        thermo_modify format float %.15g
        run 1000 upto
        """
    whole = run(
        tmp_path,
        f"""{box(8 * RADIUS)}{numbered(spheres)}
        pair_style granular/plastigran
        pair_coeff * * thornton body soft.in yield_pressure_factor 2.8 {FRICTION}
        restart 100 restart
        {end}
        """,
    )
    file.write_text(f"{material}variable yield_strength index 3e8\n")
    continued = run(tmp_path, f"read_restart restart.100\ncomm_modify vel yes\n{end}")
    out = thermo(whole)["v_out"].iloc[-1]
    assert out > 0.01
    assert_allclose(thermo(continued)["v_out"].iloc[-1], out, rtol=1e-12)


@pytest.mark.parametrize(
    "law", ["universal {} surface_energy 0.5 adhesion jkr", "thornton {} rate_coefficient 0.02"]
)
def test_the_energy_balance_does_not_change_the_motion(law, tmp_path):
    """The motion is the same with `compute plastigran/energy` and without it.

    Without it, the plugin does not compute the energies of the laws. The tolerance 1e-12 allows
    for another order of operations.
    """
    results = []
    for compute in ("", "compute energy all plastigran/energy"):
        spheres = [sphere(RADIUS + 1e-9, 0, 0, -0.2, 0.1), sphere(-RADIUS - 1e-9, 0, 0, 0.2)]
        log = run(
            tmp_path / str(len(results)),
            f"""{box(8 * RADIUS)}{numbered(spheres)}
            pair_style granular/plastigran
            pair_coeff * * {law.format(body())} tangential partial_slip 0.3
            fix motion all nve/sphere
            {compute}
            timestep 1e-7
            variable vx equal vx[1]
            variable vy equal vy[1]
            thermo_style custom step v_vx v_vy
            thermo_modify format float %.15g
            run 1000
            """,
        )
        results.append(thermo(log).iloc[-1])
    assert results[0]["v_vx"] > 0.01  # the spheres have rebounded
    assert_allclose(results[1], results[0], rtol=1e-12)


def chain(delete: str, folder: Path) -> pd.DataFrame:
    """Compress a chain of three spheres, delete another sphere, and partly unload the chain."""
    places = 8, 0, 1.9, 3.79
    spheres = numbered([sphere(RADIUS * place, 0, 0, 0) for place in places])
    log = run(
        folder,
        f"""{box(10 * RADIUS)}{spheres}
        pair_style granular/plastigran
        pair_coeff * * thornton 5e7 0.25 yield_strength 5e5 {FRICTION}
        compute energy all plastigran/energy
        thermo_style custom step c_energy[*]
        thermo_modify norm no format float %.15g
        timestep 1e-7
        fix motion all nve/noforce
        run 1
        displace_atoms all ramp x 0 {0.01 * RADIUS} x 0 {4 * RADIUS} units box
        group first id 1
        {delete}
        run 1
        """,
    )
    return thermo(log)


def test_a_deleted_sphere_leaves_the_contacts_of_others(tmp_path):
    expected = chain("", tmp_path / "none")
    assert expected["c_energy[3]"].iloc[-1] < 0.95 * expected["c_energy[3]"][0]  # unloading
    assert_allclose(chain("delete_atoms group first compress no", tmp_path / "no"), expected)
    with pytest.raises(EngineError, match="atom IDs have changed since the last run"):
        chain("delete_atoms group first", tmp_path / "yes")


def test_a_rigid_body_rebounds_by_the_law(tmp_path):
    """A third sphere hits a clump of two spheres in a row. The time step causes an error of
    1e-6."""
    places = 0, 1.5, -2.0001
    spheres = numbered([sphere(RADIUS * place, 0, 0, 0) for place in places])
    log = run(
        tmp_path,
        f"""{box(8 * RADIUS)}{spheres}
        pair_style granular/plastigran
        pair_coeff * * universal {body()} {FRICTION}
        group clump id 1 2
        group third id 3
        neigh_modify exclude group clump clump
        velocity third set 0.1 0 0
        fix clump clump rigid single
        fix motion third nve/sphere
        timestep 1e-8
        run 20000
        variable rebound equal vx[1]-vx[3]
        print "rebound ${{rebound}}"
        """,
    )
    mass = 4 / 3 * np.pi * RADIUS**3 * MATERIAL.density
    spheres = {"radius": RADIUS, "radius_other": RADIUS, "mass_eff": 2 / 3 * mass}
    expected = pg.Contact("universal", MATERIAL, MATERIAL, **spheres).restitution(0.1)
    rebound = float(re.findall(r"^rebound (\S+)", log, re.MULTILINE)[-1])
    assert_allclose(rebound / 0.1, expected, atol=1e-6)


def test_grains_can_be_poured(tmp_path):
    """The results on one and on two ranks differ by less than 1e-8, the amplified round-off."""
    tables = [
        thermo(
            run(
                tmp_path / str(ranks),
                f"""
                units si
                atom_style sphere
                boundary p p f
                comm_modify vel yes
                processors * 1 1
                region box block 0 0.02 0 0.02 0 0.06
                create_box 1 box
                neighbor 0.0002 bin
                pair_style granular/plastigran
                pair_coeff * * universal 5e7 0.25 yield_strength 5e5 {FRICTION}
                fix floor all wall/gran/plastigran granular universal rigid {FRICTION} zplane 0 NULL
                region top block 0 0.02 0 0.02 0.03 0.055
                fix motion all nve/sphere
                fix pour all pour 400 1 4767 region top diam one 0.002 vol 0.3 200 dens 2500 2500 &
                    vel 0 0 0 0 -2
                fix gravity all gravity 9.81 vector 0 0 -1
                compute energy all plastigran/energy
                timestep 5e-6
                thermo 1000
                thermo_style custom step atoms c_energy[*]
                thermo_modify norm no format float %.15g
                run 4000
                """,
                ranks,
            )
        )
        for ranks in (1, 2)
    ]
    compared = ["Atoms", "c_energy[4]", "c_energy[13]"]
    assert_allclose(tables[1][compared], tables[0][compared], rtol=1e-8)
    assert tables[0]["c_energy[4]"].iloc[-1] > 0  # plastic work
