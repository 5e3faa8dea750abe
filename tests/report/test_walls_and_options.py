# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of reports on impacts that differ in wall, options and material."""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import pytest

from plastigran import collide
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.record import read_table
from plastigran.materials import Material, read_material, write_material
from plastigran.report.page.collect import collect
from plastigran.report.page.render import make_section
from plastigran.report.page.sweep_charts import measured_chart
from plastigran.report.page.trust import trust

pytestmark = pytest.mark.engine
WALLS = (None, "steel")
OPTIONS = (None, "yielding flat")


def section(folder: Path):
    (results,) = collect([folder])
    return make_section(results)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """Folder of a sweep: zirconia on a rigid wall, and on a steel wall, which yields."""
    folder = tmp_path_factory.mktemp("walls")
    fields = {"radius": 0.0025, "wall": WALLS, "options": OPTIONS}
    collide("universal", [1, 3], "zirconia", folder=folder, **fields)
    return folder


def test_every_wall_and_option_has_a_curve_and_a_loop(folder):
    measured, loops = section(folder).charts[:2]
    table = pd.read_csv(folder / "impacts.csv")
    assert not table["wall"].isna().any() and not table["options"].isna().any()
    names = [
        f"Universal, {wall}, {options}"
        for wall in ("on a rigid wall", "on Steel")
        for options in ("default", "yielding flat")
    ]
    for quantity, (panel,) in measured.views.items():
        assert [curve.name for curve in panel.curves[::2]] == names, quantity
    forces = table.sort_values(["speed", "wall", "options"])["force_max"]
    peaks = [max(curve.y) for (panel,) in loops.views.values() for curve in panel.curves]
    assert len(loops.views) == len(peaks) == 8
    # A chart keeps 40 or more points of a loop, which may miss the largest force by 3 %.
    assert peaks == pytest.approx(list(forces), rel=0.03)


def test_errors_are_known_only_for_rigid_walls_and_default_options(folder):
    (row,) = section(folder).trust
    assert row.not_validated == [
        "Zirconia, yielding flat",
        "Zirconia on Steel",
        "Zirconia on Steel, yielding flat",
    ]
    assert row.unknown_materials == []
    assert row.validated["force_max"] is not None


def test_error_is_unknown_on_a_metal_wall(tmp_path):
    """On a metal wall, the expected error of a law is unknown.

    The reason is that finite elements exist only for a rigid plane.
    """
    collide("universal", [0.1, 1], "steel", 0.005, folder=tmp_path / "metal", wall="zirconia")
    (row,) = section(tmp_path / "metal").trust
    assert row.not_validated == ["Steel on Zirconia"]
    assert row.validated["force_max"] is None


def test_sweep_records_the_material_of_the_user(tmp_path):
    """A sweep records the user's material, so that its file may be deleted afterwards.

    The page still shows the constants of the material and the errors of the laws.
    """
    steel = read_material("steel").variables()
    material = Material("mine", **steel | {"yield_strength": 7e8})
    write_material(material, tmp_path / "mine.in", "By a tensile test.")
    collide("thornton", [0.5, 5], tmp_path / "mine.in", 0.005, folder=tmp_path / "results")
    (tmp_path / "mine.in").unlink()
    made = section(tmp_path / "results")
    constants = made.tables[0]
    assert constants.title == "Constants of the materials"
    row = dict(zip(constants.head, constants.rows[0], strict=True))
    assert row["material"] == "mine" and row["yield strength, Pa"] == "7 × 10⁸"
    assert made.trust[0].validated["force_max"] is not None
    assert not any("not available" in sentence for sentence in made.missing)
    table = pd.read_csv(tmp_path / "results" / "impacts.csv")
    assert trust(table, {})[0].unknown_materials == ["mine"]


def test_two_materials_with_one_name_are_refused(tmp_path):
    for k, strength in enumerate((3e8, 4e8)):
        (tmp_path / str(k)).mkdir()
        steel = read_material("steel").variables()
        material = Material("mine", **steel | {"yield_strength": strength})
        write_material(material, tmp_path / str(k) / "mine.in", "One of two.")
    files = [tmp_path / str(k) / "mine.in" for k in (0, 1)]
    with pytest.raises(ValueError, match="two different materials have the name mine"):
        collide("thornton", 0.1, files, 0.005, folder=tmp_path / "results")
    with pytest.raises(ValueError, match="two different materials have the name mine"):
        CentralImpact.theory(law=["thornton"], material=files, speed=0.1).write(tmp_path / "theory")
    assert not list((tmp_path / "theory").iterdir())


def test_material_names_may_look_like_numbers_or_missing_values(tmp_path):
    metals = []
    for name, strength in (("304", 3e8), ("null", 9e8)):
        steel = read_material("steel").variables()
        material = Material(name, **steel | {"yield_strength": strength})
        metals.append(tmp_path / f"{name}.in")
        write_material(material, metals[-1], "An unusual name.")
    folder = tmp_path / "results"
    collide("thornton", [0.5, 5], metals, 0.005, folder=folder, wall=metals)
    made = section(folder)
    names = {curve.name for curve in made.charts[0].views["Coefficient of restitution"][0].curves}
    assert names == {
        f"Thornton, {ball}, on {wall}" for ball in ("304", "Null") for wall in ("304", "Null")
    }
    assert made.state == "done", made.missing
    assert len(made.charts[1].views) == 8
    table, left = read_table(folder / "impacts.csv")
    assert not left and set(table["material"]) == set(table["wall"]) == {"304", "null"}


def test_yielding_wall_gives_a_warning(folder):
    (warning,) = section(folder).warnings
    assert warning.startswith("Zirconia on Steel: the wall yields, not the ball")


def test_wall_does_not_split_a_curve_over_geometry():
    """Impacts on a wall and impacts between spheres share one curve, if only geometry varies."""
    geometries = ["sphere_wall", "two_spheres"]
    table = CentralImpact.theory(law=["thornton"], speed=0.1, geometry=geometries).table
    predicted = {f"{name}_predicted": table[name] for name in ("force_max", "overlap_max")}
    chart = measured_chart(table.assign(**predicted), {})
    names = {curve.name for (panel,) in chart.views.values() for curve in panel.curves}
    assert names == {"Thornton"} and "Lines" not in chart.caption
