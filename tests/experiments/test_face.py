# SPDX-License-Identifier: GPL-2.0-or-later
"""The functions that a notebook calls: `import plastigran as pg`."""

from __future__ import annotations

import pickle
import re
import subprocess
import sys

import numpy as np
import pytest
from attrs import evolve

import plastigran as pg
from plastigran import materials
from plastigran.cli import main
from plastigran.contact import RangeWarning
from plastigran.engine.process import engine_path, inputs_folder
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.cylinder import CylinderImpact

STEEL = pg.material("steel")


def test_import_is_light():
    """`import plastigran` does not load slow modules; they are loaded when they are first used."""
    code = "import sys, plastigran; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert not {"numpy", "pandas", "scipy", "matplotlib", "pyvista"} & set(done.stdout.split())


@pytest.mark.parametrize("law", ["thornton", "viscoelastic_hertz"])
def test_a_contact_agrees_with_an_experiment(law):
    """`pg.Contact` and `CentralImpact` with the same law, radius and mass agree to round-off."""
    ice = pg.material("ice")
    body = evolve(STEEL, dissipative_constant=1e-6) if law == "thornton" else ice
    case = CentralImpact(law, 0.1, body, 0.01, "two_spheres")
    contact = pg.Contact(law, body, body, radius=0.01, radius_other=0.01)
    assert contact.restitution(case.closing_speed) == pytest.approx(
        case.predict().coefficient_of_restitution, rel=1e-12
    )
    assert contact.timestep(case.closing_speed) == pytest.approx(case.timestep, rel=1e-12)


def test_a_contact_of_cylinders_has_their_mass():
    lengths = {"cylinder_length": 1e-4, "body_thickness": 1e-4}
    glass = pg.material("glass_kp10")
    contact = pg.Contact("lim_stronge", glass, pg.RIGID, radius=1e-5, **lengths)
    case = CylinderImpact("lim_stronge", 20.0, glass, 1e-5, mass=contact.mass_eff)
    assert contact.mass_eff == pytest.approx(np.pi * 1e-10 * 1e-4 * glass.density, rel=1e-12)
    found = contact.impact([20.0])
    assert found.overlap_max[0] == pytest.approx(case.predict().overlap_max, rel=1e-12)


def test_yield_of_a_contact_of_spheres():
    """Overlap, force and speed at yield of spheres follow the closed forms of Johnson, sec. 6.1.

    The point of yield lies on the elastic curve of the law.
    """
    contact = pg.Contact("thornton", STEEL, "steel", radius=5e-3, radius_other=0.02)
    pressure, modulus = contact.pair.yield_pressure, contact.pair.youngs_modulus_eff
    radius = 1 / (1 / 5e-3 + 1 / 0.02)
    overlap = radius * (np.pi * pressure / (2 * modulus)) ** 2
    force = np.pi**3 * pressure**3 * radius**2 / (6 * modulus**2)
    speed = np.sqrt(np.pi**5 / 30 * pressure**5 * radius**3 / (modulus**4 * contact.mass_eff))
    assert contact.yield_overlap == pytest.approx(overlap, rel=1e-12)
    assert contact.yield_force == pytest.approx(force, rel=1e-12)
    assert contact.yield_speed == pytest.approx(speed, rel=1e-12)
    elastic = contact.path([contact.yield_overlap * (1 - 1e-9)]).iloc[0]
    assert elastic["plastic_work"] == 0
    assert elastic["force"] == pytest.approx(contact.yield_force, rel=1e-8)
    assert contact.restitution(0.999 * contact.yield_speed) == pytest.approx(1, abs=1e-12)
    assert contact.restitution(1.1 * contact.yield_speed) < 1


def test_yield_of_a_contact_of_cylinders():
    """The yield force of cylinders of length L is 36 sigma_Y^2 R* L/(pi E*).

    It lies on the elastic curve of the law.
    """
    lengths = {"cylinder_length": 1e-4, "body_thickness": 1e-4}
    glass = pg.material("glass_kp10")
    contact = pg.Contact("lim_stronge", glass, pg.RIGID, radius=1e-5, **lengths)
    strength, modulus = contact.pair.yield_strength, contact.pair.youngs_modulus_eff
    force = 36 * strength**2 * 1e-5 * 1e-4 / (np.pi * modulus)
    assert contact.yield_force == pytest.approx(force, rel=1e-12)
    elastic = contact.path([contact.yield_overlap * (1 - 1e-9)]).iloc[0]
    assert elastic["plastic_work"] == 0
    assert elastic["force"] == pytest.approx(force, rel=1e-8)
    work = 0.5 * contact.mass_eff * contact.yield_speed**2
    assert elastic["elastic_energy"] == pytest.approx(work, rel=1e-8)


def test_a_law_without_yield_has_an_infinite_yield_speed():
    contact = pg.Contact("hertz", STEEL, pg.RIGID, radius=5e-3)
    found = contact.yield_overlap, contact.yield_force, contact.yield_speed
    assert found == (np.inf, np.inf, np.inf)


def test_speeds_of_any_shape():
    contact = pg.Contact("kogut_etsion", STEEL, pg.RIGID, radius=5e-3)
    speeds = np.array([[0.1, 0.2], [0.3, 0.4]])
    assert contact.restitution(speeds).shape == (2, 2)
    assert contact.restitution(0.2) == contact.restitution(speeds)[0, 1]
    assert contact.impact(speeds).in_range.dtype == bool


def test_a_path_accounts_for_its_work():
    """On a loading path, elastic energy plus plastic work equals the work of the force.

    The relative tolerance 1e-4 is the error of the trapezoidal rule.
    """
    path = pg.Contact("thornton", STEEL, "steel", radius=5e-3).path(np.linspace(0, 2e-5, 2000))
    work = np.trapezoid(path["force"], path["overlap"])
    last = path.iloc[-1]
    assert last["elastic_energy"] + last["plastic_work"] == pytest.approx(work, rel=1e-4)
    assert (path["contact_radius"].diff().iloc[1:] > 0).all()


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"law": "hook"}, "no law 'hook'. Available laws: brake_2012"),
        ({"law": ["thornton"]}, r"no law \['thornton'\]"),
        ({"radius": 0}, "radius is 0; it must lie from 1e-12 to 1e"),
        ({"radius": "thin"}, r"radius is 'thin', not a number \[m\]"),
        ({"mass_eff": [1, 2]}, r"mass_eff is \[1, 2\], not a number \[kg\]"),
        ({"radius_other": -1.0}, "radius_other is -1"),
        ({"mass_eff": 0.0}, "mass_eff is 0"),
        ({"a": 7850.0}, "a is 7850.0; it must be a Material, the name or file of a"),
        ({"b": "cheese"}, "no material 'cheese'. Available materials: alumina"),
        (
            {"law": "viscoelastic_hertz"},
            "needs dissipative_constant, which material steel does not define",
        ),
        ({"meyer_index": 2.0}, "has no constant 'meyer_index'"),
    ],
)
def test_impossible_contacts_are_refused(changes, said):
    given = {"law": "thornton", "a": STEEL, "b": pg.RIGID, "radius": 1e-3} | changes
    with pytest.raises(ValueError, match=said):
        pg.Contact(**given)


def test_bodies_without_mass_are_refused():
    with pytest.raises(ValueError, match="no body has both a density and a radius"):
        pg.Contact("hertz", pg.RIGID, STEEL.body(), radius=1e-3).restitution(1.0)


def test_the_representation_of_a_contact():
    contact = pg.Contact("thornton", STEEL, pg.RIGID, radius=1e-3)
    for one in (contact, pickle.loads(pickle.dumps(contact))):
        assert repr(one) == "Contact('thornton', steel, RIGID, radius=0.001)"


def test_a_call_beyond_the_range_of_a_law_warns_once():
    """A call beyond the validity range of a law gives one warning.

    `kogut_etsion` is valid up to 110 times the overlap at yield.
    """
    contact = pg.Contact("kogut_etsion", STEEL, pg.RIGID, radius=5e-3)
    speeds = np.geomspace(1e-3, 1, 40)
    outcome = contact.impact(speeds)
    inside = outcome.overlap_max <= contact.overlap_range
    assert (inside == outcome.in_range).all() and 0 < inside.sum() < 40
    first = speeds[~inside].min()
    with pytest.warns(RangeWarning, match=f"^speed {first:.3g} m/s exceeds .* law kogut") as said:
        contact.restitution(speeds)
    assert len(said) == 1
    contact.path([contact.overlap_range])
    with pytest.warns(RangeWarning, match=r"^overlap 1e-05 m exceeds .*110 times that at yield"):
        contact.path([1e-6, 1e-5])


def test_without_input_scripts(monkeypatch, tmp_path, capsys):
    """Laws, materials, contacts and help work without input scripts."""
    monkeypatch.setenv("PLASTIGRAN_INPUTS", str(tmp_path / "none"))
    assert materials.table().loc["steel", "youngs_modulus"] == 2.1e11
    assert pg.Contact("thornton", "steel", pg.RIGID, radius=1e-3).restitution(1.0) < 1
    assert main(["laws", "thornton"]) == 0
    with pytest.raises(SystemExit) as stop:
        main(["impact", "--help"])
    assert stop.value.code == 0
    assert "aluminium_zv02" in capsys.readouterr().out


def test_rubber_is_a_material(tmp_path):
    """An incompressible material, Poisson's ratio 0.5, is allowed."""
    text = (materials.folder() / "steel.in").read_text().replace("0.3 ", "0.5 ")
    (tmp_path / "rubber.in").write_text(text)
    contact = pg.Contact("hertz", pg.material(tmp_path / "rubber.in"), pg.RIGID, radius=1e-3)
    assert contact.pair.youngs_modulus_eff == pytest.approx(2.1e11 / 0.75)


@pytest.mark.engine
def test_relative_paths_start_at_the_current_folder(monkeypatch, tmp_path):
    """LIGGGHTS runs in other folders, so paths in the environment must become absolute."""
    engine = engine_path()
    monkeypatch.chdir(engine.parents[1])
    monkeypatch.setenv("PLASTIGRAN_ENGINE", str(engine.relative_to(engine.parents[1])))
    assert engine_path() == engine
    folder = inputs_folder()
    monkeypatch.chdir(folder.parent)
    monkeypatch.setenv("PLASTIGRAN_INPUTS", folder.name)
    assert inputs_folder() == folder


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("7850.0", "-1"), "density is -1; it must be positive and finite"),
        (("0.3 ", "0.51 "), "poissons_ratio is 0.51; it must be above -1 and at most 0.5"),
        (("2.1e11", "stiff"), "youngs_modulus is 'stiff', not a number"),
        (("yield_strength ", "strength "), "yield_strength is not defined"),
        (("factor  index 0 ", "factor  index 0.3 "), "yield_pressure_factor is 0.3"),
        (
            ("variable density", "variable tangent_modulus index 3e11\nvariable density"),
            "tangent_modulus is 3e+11; it must be 0 or more and less than youngs_modulus, 2.1e+11",
        ),
        (
            ("pressure_factor", "presure_factor"),
            "yield_presure_factor is not a constant of a material",
        ),
        (
            ("variable density", "variable yield_strength index 1e9\nvariable density"),
            "yield_strength is defined twice",
        ),
        (("2.1e11", "2_1e10"), "youngs_modulus is '2_1e10', not a number"),
        (("index 2.1e11", "equal 2.1e11"), "only lines `variable NAME index VALUE`"),
        (("2.1e11", "2.1e11 7e10"), "only lines `variable NAME index VALUE`"),
        (("variable density", "\ufeffvariable density"), "begins with a byte order mark"),
    ],
)
def test_wrong_material_files_are_refused(change, said, tmp_path):
    text = (materials.folder() / "steel.in").read_text()
    assert change[0] in text
    own = tmp_path / "steel.in"
    own.write_text(text.replace(*change))
    with pytest.raises(ValueError, match=re.escape(str(own)) + ".*" + re.escape(said)):
        pg.material(own)
