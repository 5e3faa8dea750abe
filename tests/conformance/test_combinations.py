# SPDX-License-Identifier: GPL-2.0-or-later
"""Laws combined with models of cohesion, of rolling and tangential friction, and of the surface."""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import pytest
from attrs import evolve, frozen
from soft_grains import (
    COMPANIONS,
    NO_YIELD,
    PROPERTIES,
    STRENGTH,
    assert_alike,
    execute,
    fresh,
    motion,
)

from plastigran.engine.log import read_thermo
from plastigran.engine.process import EngineError

#: Grains of all tests. Two spinning grains collide obliquely on the border between ranks. One grain
#: hits the floor, one hits the plate, and one lies on another. Each contact lasts some 300 steps.
GRAINS = """
create_atoms    1 single -0.0102 0.001 0.03
create_atoms    1 single 0.0102 -0.001 0.03
create_atoms    1 single 0.045 0.0 0.0102
create_atoms    1 single -0.0597 0.0 0.03
create_atoms    2 single -0.03 0.02 0.00999
create_atoms    1 single -0.03 0.0201 0.02798
set group all diameter 0.02 density 2500
set atom 6 diameter 0.016
set atom 1 vx 0.3 vy 0.05 omegaz 20.0 omegax 5.0
set atom 2 vx -0.3 omegay -15.0
set atom 3 vx 0.1 vz -0.3 omegay 30.0 omegaz 10.0
set atom 4 vx -0.3 vz 0.1 omegay 20.0
"""
MODELS = (
    COMPANIONS
    + """
fix damping  all property/global coefficientRollingViscousDamping peratomtypepair 2 {damping}
fix epsd3    all property/global rollingStiffness scalar 3.0
fix dynamic  all property/global FluidViscosity peratomtypepair 2 1 1 1 1
fix viscous  all property/global FrictionViscosity peratomtypepair 2 1 1 1 1
fix sliding  all property/global coeffFrictionStiffness peratomtypepair 2 1 1 1 1
fix turning  all property/global coeffRollingStiffness peratomtypepair 2 1 1 1 1
{pair}
pair_coeff      * *
fix floor  all wall/gran model {law} {at_walls} primitive type 2 zplane 0.0 {options}
fix plate  all mesh/surface file ${{inputs}}/meshes/plate.stl type 2 scale 0.01 move -0.07 0 0.03
fix side   all wall/gran model {law} {at_walls} mesh n_meshes 1 meshes plate {options}
{more}
fix integrate all nve/sphere
{thermo}
"""
)
DISC = """
units           si
atom_style      granular
dimension       2
boundary        f f p
newton          off
communicate     single vel yes
region          box block -1 1 -1 1 -0.1 0.1 units box
create_box      1 box
create_atoms    1 single 0 0 0
neighbor        0.01 bin
set group all diameter 0.02 density 2500
fix youngs   all property/global youngsModulus peratomtype 1e7
fix poisson  all property/global poissonsRatio peratomtype 0.3
fix strength all property/global yieldStrength peratomtype 1e5
fix length   all property/global cylinderLength peratomtype 1
pair_style gran model lim_stronge tangential off cohesion sjkr
pair_coeff      * *
fix integrate all nve/sphere
run             0
"""
LEDGER = """
include ${inputs}/energy_ledger.in
"""


@frozen
class Contact:
    """Contact models and options of the lines pair_style and fix wall/gran.

    Attributes:
        models: Words after the normal model, such as `tangential history`.
        law: Normal model.
        at_walls: Words after the normal model on fix wall/gran lines, if they differ.
        options: Words at the end of both lines.
        more: Commands after the walls.
    """

    models: str = "tangential history"
    law: str = "thornton"
    at_walls: str = ""
    options: str = ""
    more: str = ""


LIQUID = "tangential history cohesion {}/capillary/viscous"
PRESSING = "fix pressing all multicontact/halfspace geometric_prefactor 1.125"
CONTACTS = {
    "sjkr": Contact("tangential history cohesion sjkr"),
    "sjkr2": Contact("tangential history cohesion sjkr2", options="tangential_reduce on"),
    "sjkr alone": Contact("tangential off cohesion sjkr"),
    "easo": Contact(LIQUID.format("easo"), at_walls="tangential history"),
    "washino": Contact(LIQUID.format("washino")),
    "epsd": Contact("tangential history rolling_friction epsd"),
    "epsd3": Contact("tangential off rolling_friction epsd3", options="torsionTorque on"),
    "sjkr and epsd": Contact("tangential history cohesion sjkr rolling_friction epsd"),
    "multicontact": Contact("tangential history surface multicontact", more=PRESSING),
    "multicontact, sjkr2 and epsd3": Contact(
        "tangential history cohesion sjkr2 rolling_friction epsd3 surface multicontact",
        more=PRESSING,
    ),
}
LUDING = {
    "tangential": Contact("tangential tan_luding"),
    "rolling": Contact("tangential history rolling_friction luding"),
}
#: Tangential models of this project.
SLIPPING = {
    "partial_slip": Contact("tangential partial_slip"),
    "partial_slip and epsd2": Contact("tangential partial_slip rolling_friction epsd2"),
    "8 rings and epsd2": Contact(
        "tangential partial_slip rolling_friction epsd2", options="rings 8"
    ),
    "2 rings": Contact("tangential partial_slip", options="rings 2"),
    # A restart file must keep the order of history values: those of `rings` and of `adhesion`.
    "8 rings and adhesion": Contact(
        "tangential partial_slip",
        options="rings 8 adhesion jkr",
        more="fix surface_energy all property/global surfaceEnergy peratomtypepair 2 1 1 1 1\n",
    ),
    "partial_slip and dashpot": Contact("tangential partial_slip", options="viscous_damping on"),
    "incremental": Contact("tangential incremental"),
    "hertz and partial_slip": Contact("tangential partial_slip", law="hertz", options="rings 5"),
    "hertz and incremental": Contact(
        "tangential incremental cohesion sjkr rolling_friction epsd2", law="hertz"
    ),
}
ALL = CONTACTS | SLIPPING
host_contact = pytest.mark.parametrize("contact", CONTACTS.values(), ids=CONTACTS)
every_contact = pytest.mark.parametrize("contact", ALL.values(), ids=ALL)
STEPS = 800


def deck(
    contact: Contact,
    law: str = "",
    *,
    strength: str = STRENGTH,
    ledger: bool = False,
    **changes: str,
) -> str:
    """Return a deck without its grains and runs."""
    if ledger:
        contact = evolve(contact, options=f"{contact.options} energy_ledger on")
    models, options, more = contact.models, contact.options, contact.more
    law = law or contact.law
    values = {
        "pair": f"pair_style gran model {law} {models} {options}",
        "damping": "0.3 0.2 0.2 0.3",
        "thermo": LEDGER if ledger else "",
    }
    at_walls = contact.at_walls or models
    values |= {"law": law, "at_walls": at_walls, "options": options, "more": more, **changes}
    return PROPERTIES.format(strength=strength) + MODELS.format(**values) + motion()


def start(commands: str, folder: Path, ranks: int = 1, after: str = f"run {STEPS}") -> pd.DataFrame:
    """Run the grains with these commands; return their motion by step and atom ID."""
    return fresh(GRAINS + commands + after, folder, ranks)


@host_contact
def test_an_unyielding_law_is_the_engines_hertz(contact, tmp_path):
    """Without yield, a law and LIGGGHTS' hertz give the same motion if the other models are the
    same. They agree to 1e-9 of the largest value. The round-off, 1e-16 of a position and 1e-13 of
    an overlap, grows during a few impacts.
    """
    ours = start(deck(contact, strength=NO_YIELD), tmp_path / "ours")
    stock = start(deck(contact, "hertz"), tmp_path / "stock")
    assert_alike(ours, stock, 1e-9)
    plain = start(deck(Contact(), strength=NO_YIELD), tmp_path / "plain")
    assert ((plain - ours).abs().max() > 1e-4 * plain.abs().max()).any(), "models have no effect"


@every_contact
def test_two_ranks_are_one(contact, tmp_path):
    """Yielding grains move alike on one rank and on two, with every combination of models.

    The contact of grains 1 and 2 lies on the border between the ranks. The motion agrees to 1e-9 of
    its largest value, because round-off grows during impacts.
    """
    one, two = (start(deck(contact), tmp_path / str(ranks), ranks) for ranks in (1, 2))
    assert_alike(one, two, 1e-9)


@every_contact
def test_a_restart_goes_on(contact, tmp_path):
    """A run that continues from a restart file, with the settings of the file, equals a run
    without a pause. The results are bitwise identical, except for the forces at the pause,
    which a run computes again.
    """
    pause = f"run {STEPS // 2}\nwrite_restart middle.restart\nrun {STEPS // 2}"
    whole = start(deck(contact), tmp_path / "whole", after=pause)
    head = """
atom_style      granular
atom_modify     map array
newton          off
communicate     single vel yes
"""
    read = f"read_restart {tmp_path}/whole/middle.restart"
    rest = execute(f"{head}{read}{deck(contact, pair='')}run {STEPS // 2}", tmp_path / "rest")
    whole = whole.loc[STEPS // 2 + 1 :]
    rest = rest.loc[STEPS // 2 + 1 :]
    assert len(whole) == 6 * STEPS // 2 // 20
    assert (whole == rest).all(axis=None)


@pytest.mark.parametrize(
    ("name", "ranks"),
    [
        ("washino", 1),
        ("multicontact, sjkr2 and epsd3", 1),
        ("epsd", 2),
        ("sjkr and epsd", 2),
        ("partial_slip", 2),
        ("incremental", 2),
        ("hertz and partial_slip", 2),
    ],
)
def test_contacts_remember_when_grains_come(name, ranks, tmp_path):
    """A distant grain that is created between two runs does not change the motion of the others.

    The motion is bitwise identical, so the contacts keep their history. The liquid model and
    multicontact are tested on one rank: on two, LIGGGHTS' own hertz loses liquid, and it crashes
    with multicontact.
    """
    half = f"run {STEPS // 2}\n"
    come = "create_atoms 1 single 0.07 0.03 0.07\nset atom 7 diameter 0.01 density 2500\n"
    tables = [
        start(deck(ALL[name]), tmp_path / str(k), ranks, half + between + half)
        for k, between in enumerate(("", come))
    ]
    alone, joined = (table[table.index.get_level_values("id") <= 6] for table in tables)
    assert len(tables[1]) > len(tables[0]) == len(joined)
    assert (alone == joined).all(axis=None)


@pytest.mark.parametrize("name", ["sjkr", "sjkr2", "sjkr alone", "sjkr and epsd", *SLIPPING])
def test_the_ledger_closes(name, tmp_path):
    """The energy balance closes with cohesion models and with the tangential laws of this project.

    The balance error, from the time integration, is below 3e-4 of the largest kinetic energy. The
    work of cohesion during approach counts as negative elastic energy.
    """
    start(deck(ALL[name], ledger=True), tmp_path)
    table = read_thermo(tmp_path / "log.liggghts")
    assert table["drift"].abs().max() < 3e-4 * table["kinetic"].max()
    loss = "friction" if ALL[name].law == "hertz" else "plastic"
    assert table[loss].iloc[-1] > 0.01 * table["kinetic"].max()


@pytest.mark.parametrize("tangential", ["partial_slip", "incremental"])
def test_hertz_beside_a_tangential_law_is_an_unyielding_law(tangential, tmp_path):
    """LIGGGHTS' hertz and a law without yield give the same motion with a tangential law. The
    tolerance and its reason are the same as in `test_an_unyielding_law_is_the_engines_hertz`.
    """
    contact = Contact(f"tangential {tangential}")
    ours = start(deck(contact, strength=NO_YIELD), tmp_path / "ours")
    hertz = start(deck(contact, "hertz"), tmp_path / "hertz")
    assert_alike(ours, hertz, 1e-9)


def test_the_dashpot_of_hertz_is_counted(tmp_path):
    """The energy balance counts the work of the dashpot of LIGGGHTS' own hertz.

    The balance error is below 3e-4 of the largest kinetic energy, as in `test_the_ledger_closes`.
    """
    elastic, damped = (f"Restitution peratomtypepair 2{4 * e}" for e in (" 1", " 0.5"))
    commands = deck(ALL["hertz and partial_slip"], ledger=True)
    assert elastic in commands
    start(commands.replace(elastic, damped), tmp_path)
    table = read_thermo(tmp_path / "log.liggghts")
    assert table["drift"].abs().max() < 3e-4 * table["kinetic"].max()
    assert table["viscous"].iloc[-1] > 0.01 * table["kinetic"].max()


def test_hertz_beside_a_tangential_law_refuses_what_it_cannot_do(tmp_path):
    contact = Contact("tangential partial_slip", law="hertz")
    for option, problem in {
        "computeElasticPotential on": "computeElasticPotential is not supported with a tangent",
        "adhesion jkr": "adhesion jkr is not available with this model",
    }.items():
        with pytest.raises(EngineError, match=f"model hertz: {problem}"):
            start(deck(evolve(contact, options=option)), tmp_path)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("easo", "the energy of liquid between particles is not counted"),
        ("washino", "the energy of liquid between particles is not counted"),
        ("multicontact", "the energy of multicontact is not counted"),
    ],
)
def test_what_is_not_counted_is_refused(name, said, tmp_path):
    """The energy balance and fix `collision_spectra` refuse models whose work they do not count."""
    with pytest.raises(EngineError, match=f"energy_ledger on: {said}"):
        start(deck(CONTACTS[name], ledger=True), tmp_path / "ledger")
    counting = "fix counting all collision_spectra 10 file spectra.csv\n"
    with pytest.raises(EngineError, match=f"fix counting collision_spectra: {said}"):
        start(deck(CONTACTS[name]) + counting, tmp_path / "spectra")


@pytest.mark.parametrize(
    ("luding", "same"),
    [
        ("tangential", Contact("tangential history")),
        ("rolling", Contact("tangential history rolling_friction epsd2")),
    ],
)
def test_ludings_friction_is_that_of_no_adhesion(luding, same, tmp_path):
    """Without adhesion, Luding's friction models equal LIGGGHTS' `history` and `epsd2`.

    The coefficients that only Luding's models use are one; their rolling damping is zero. The model
    `tan_luding` then equals `history`, and rolling friction `luding` equals `epsd2`. The motions
    agree to 1e-12 of the largest value, because the order of multiplications differs.
    """
    theirs = start(deck(LUDING[luding], damping="0 0 0 0"), tmp_path / "luding")
    other = start(deck(same), tmp_path / "same")
    assert_alike(theirs, other, 1e-12)


def test_a_liquid_that_takes_walls_for_particles_is_refused(tmp_path):
    with pytest.raises(EngineError, match="easo/capillary/viscous does not support walls, because"):
        start(deck(Contact(LIQUID.format("easo"))), tmp_path)


def test_cohesion_beside_a_cylinder_is_refused(tmp_path):
    with pytest.raises(EngineError, match="cohesion sjkr supports only spheres, but lim_stronge"):
        execute(DISC, tmp_path)
