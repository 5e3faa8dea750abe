# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the report page for complete, unfinished, failed and damaged results."""

from __future__ import annotations

import base64
import gzip
import json
import re
import resource
import shutil
import signal
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from PIL import Image

from plastigran.bulk.run import run_bulk
from plastigran.bulk.template import write_deck
from plastigran.calibration.expected_errors import errors_table, expected_error
from plastigran.cli import main
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.runs import claim
from plastigran.materials import read_material, write_material
from plastigran.plot.quantities import QUANTITIES
from plastigran.plot.style import save, subplots
from plastigran.report.page.bulk_charts import series_chart
from plastigran.report.page.collect import collect
from plastigran.report.page.movie import GrainMovie
from plastigran.report.page.render import make_section, write_report
from plastigran.report.page.sections import Section
from plastigran.report.page.trust import Trust, trust

UNKNOWN = {"coefficient_of_restitution": None, "force_max": None}


def section(folder: Path) -> Section:
    """Return the section of the page for the only result in a folder."""
    (results,) = collect([folder])
    return make_section(results)


def curve_count(made: Section, chart: int) -> int:
    return sum(len(panel.curves) for (panel,) in made.charts[chart].views.values())


def movie_head(movie: GrainMovie) -> dict:
    return json.loads(gzip.decompress(base64.b64decode(movie.data)).split(b"\n", 1)[0])


def edit_json(file: Path, changes: dict) -> None:
    file.write_text(json.dumps(json.loads(file.read_text()) | changes))


def truncate(file: Path, fraction: float) -> None:
    content = file.read_bytes()
    file.write_bytes(content[: int(fraction * len(content))])


@pytest.fixture
def copied(hopper, tmp_path) -> Path:
    """Copy of the results of the hopper deck, which a test may damage."""
    return Path(shutil.copytree(hopper, tmp_path / "hopper"))


@pytest.fixture
def copied_sweep(sweep_folder, tmp_path) -> Path:
    """Copy of the results of the sweep, which a test may damage."""
    return Path(shutil.copytree(sweep_folder, tmp_path / "speeds"))


def test_results_are_sorted_by_category(sweep_folder, hopper, tmp_path):
    (tmp_path / "deep" / "er").mkdir(parents=True)
    (tmp_path / "deep" / "er" / "one.csv").write_text("a,b\n1,2\n")
    found = collect([hopper, tmp_path, sweep_folder])
    assert [results.category for results in found] == ["sweep", "tables", "bulk"]
    assert [results.title for results in found] == ["speeds", "deep/er", hopper.name]


def test_titles_of_equal_folder_names_differ(hopper, tmp_path):
    for name in ("a", "b"):
        shutil.copytree(hopper, tmp_path / name / "hopper")
    found = collect([tmp_path / "a/hopper", tmp_path / "b/hopper"])
    assert [results.title for results in found] == ["a/hopper", "b/hopper"]


def test_bulk_run_shows_facts_settings_and_checks(hopper):
    made = section(hopper)
    assert made.results.category == "bulk"
    assert made.facts["deck"] == "hopper"
    assert made.facts["radius"] == "0.005 m"
    assert "3.8.0" in made.facts["engine"]
    names = {check["name"] for check in made.checks}
    assert "decrease of plastic work, divided by the energy input" in names
    assert all(check["reason"] for check in made.checks)
    assert [chart.name for chart in made.charts] == ["ledger", "series"]
    assert made.movie.frames >= 3
    assert "layers *" in [name for name, _, _ in made.settings]


def test_unfinished_run_shows_its_last_step(copied):
    (copied / "series.csv").unlink()
    log = copied / "log.liggghts"
    lines = log.read_text().splitlines(keepends=True)
    heads = [k for k, line in enumerate(lines) if line.split()[:1] == ["Step"]]
    log.write_text("".join(lines[: heads[-1] + 5]))
    made = section(copied)
    assert (made.state, made.verdict) == ("unfinished", "not finished")
    assert any("ends at step" in sentence and "--restart" in sentence for sentence in made.missing)
    assert not made.checks
    assert made.charts


def test_run_that_has_not_started(copied):
    for name in ("series.csv", "log.liggghts"):
        (copied / name).unlink()
    shutil.rmtree(copied / "frames")
    made = section(copied)
    assert made.state == "unfinished"
    assert any("has not started" in sentence for sentence in made.missing)
    assert made.movie is None


def test_failed_run_shows_the_error_of_liggghts(copied):
    (copied / "series.csv").unlink()
    with open(copied / "log.liggghts", "a") as log:
        log.write("ERROR: Lost atoms: original 400 current 399 (../thermo.cpp:431)\n")
    missing = section(copied).missing
    assert any("Lost atoms: original 400 current 399" in sentence for sentence in missing)


def test_failed_check_fails_the_section(copied):
    log = copied / "log.liggghts"
    *before, last, newline = re.split(r"(^ *\d+ 2e-05 .*\n)", log.read_text(), flags=re.MULTILINE)
    cells = last.split()
    cells[3] = str(int(cells[3]) - 1)  # remove one grain from those in the hopper
    log.write_text("".join([*before, " ".join(cells) + "\n", newline]))
    made = section(copied)
    warned = f", {len(made.warnings)} warnings"
    assert made.verdict == f"1 of {len(made.checks)} checks failed{warned}"
    assert made.state == "failed"
    failed = [check["name"] for check in made.checks if not check["passed"]]
    assert failed == ["grains neither in the hopper nor counted as discharged"]


@pytest.mark.parametrize(("count", "words"), [(1, "1 warning"), (2, "2 warnings")])
def test_verdict_counts_warnings(copied, count, words):
    log = copied / "log.liggghts"
    text = re.sub(r"^WARNING: .*\n", "", log.read_text(), flags=re.MULTILINE)
    log.write_text(text)
    passed = f"{len(section(copied).checks)} checks passed"
    assert section(copied).verdict == passed
    warnings = [f"WARNING: plastigran: model thornton: {letter}\n" for letter in "ab"[:count]]
    log.write_text(text + "".join(warnings))
    made = section(copied)
    assert (made.state, made.verdict) == ("passed", f"{passed}, {words}")
    page = write_report([copied], copied.parent / "page.html").read_text()
    assert page.count(f"{passed}, {words}") == 2  # card and head of the section


def test_user_deck_shows_law_and_time_step_of_the_log(tmp_path):
    """For a user's own deck, the page takes the law and the time step from the log.

    The deck of this test has no setting `law`, and computes its time step from the radius.
    """
    deck = write_deck(tmp_path / "mine", "thornton", "soft_granules")
    text = re.sub(r"^variable law .*\n", "", deck.read_text(), flags=re.MULTILINE)
    deck.write_text(text.replace("${law}", "thornton"))
    settings = {"duration": 0.001, "radius": 0.006, "timestep": 1e-6}
    settings |= {"frames": 1, "rows": 2, "checkpoints": 1}
    run_bulk(deck, settings, tmp_path / "run", show=False)
    made = section(tmp_path / "run")
    assert made.facts["law"] == "Thornton"
    assert made.facts["timestep"] == "2 × 10⁻⁶ s"
    assert made.facts["pair style"] == "gran model thornton tangential history energy_ledger on"
    assert [frame["label"] for frame in movie_head(made.movie)["frames"]] == ["0 s", "1 ms"]
    log = tmp_path / "run" / "log.liggghts"
    log.write_text(re.sub(r"^(pair_style|timestep|units) .*\n", "", log.read_text(), flags=re.M))
    facts = section(tmp_path / "run").facts
    assert not {"timestep", "pair style"} & set(facts)


@pytest.mark.parametrize("text", ["{", "[]", '{"deck": 1}'])
def test_damaged_record_is_named(copied, text):
    (copied / "run.json").write_text(text)
    made = section(copied)
    assert made.verdict == "record damaged"
    assert "run.json" in made.missing[0]


@pytest.mark.parametrize(
    ("entry", "value"),
    [
        ("versions", None),
        ("versions", {"plugin": 3}),
        ("derived", None),
        ("derived", [1]),
        ("settings", {"law": None}),
        ("restart", 3),
    ],
)
def test_damaged_entry_of_a_record_is_named(copied, entry, value, capsys):
    """If an entry of run.json is damaged, the error message names the entry.

    The report and an attempt to continue the run both show this message.
    """
    edit_json(copied / "run.json", {entry: value})
    made = section(copied)
    assert made.verdict == "record damaged"
    assert f"run.json is damaged: entry {entry}" in made.missing[0]
    line = ["bulk", "hopper", "--restart", str(copied), "--output", str(copied.parent / "more")]
    assert main([*line, "--dry-run"]) == 1
    assert "run.json is damaged" in capsys.readouterr().err


def test_frames_without_a_column_are_named(copied):
    frame = next((copied / "frames").glob("grains_[0-9]*.vtk"))
    frame.write_text(frame.read_text().replace("f_plastic_work", "other").replace("radius", "r"))
    made = section(copied)
    assert made.movie is None
    assert "frames cannot be shown" in made.missing[0] and "radius" in made.missing[0]


def test_empty_frames_are_shown(copied):
    head = "# vtk DataFile Version 5.1\nGenerated by LIGGGHTS\nASCII\nDATASET POLYDATA\n"
    for name in ("grains", "contacts"):
        (copied / "frames" / f"{name}_0.vtk").write_text(f"{head}POINTS 0 float\n\n")
    made = section(copied)
    assert not made.missing
    assert made.movie.frames == len(list((copied / "frames").glob("grains_[0-9]*.vtk")))
    assert list(made.movie.colours) == ["plastic_work", "force", "speed"]
    assert movie_head(made.movie)["frames"][0]["grains"] == 0


@pytest.mark.parametrize("place", [0, 1, -1])
@pytest.mark.parametrize("fraction", [0, 0.5])
def test_truncated_frame_is_left_out_and_named(copied, place, fraction):
    files = sorted(copied.glob("frames/grains_[0-9]*.vtk"), key=lambda file: file.stat().st_mtime)
    truncate(files[place], fraction)
    made = section(copied)
    assert made.missing == [
        f"A frame is left out of the view of grains, because {files[place].name} is incomplete."
    ]
    assert made.movie.frames == len(files) - 1
    assert (made.state, len(made.charts)) == ("passed", 2)


def test_frames_that_are_all_truncated(copied):
    files = list(copied.glob("frames/grains_[0-9]*.vtk"))
    for file in files:
        file.write_text("")
    made = section(copied)
    assert made.movie is None and made.charts
    assert f"{len(files)} frames are left out" in made.missing[0]


def test_sweep_shows_facts_charts_and_trust(sweep_folder):
    made = section(sweep_folder)
    assert made.facts["command"] == "plastigran impact"
    assert made.facts["law"] == "Kogut–Etsion, Thornton, Universal"
    assert made.facts["impact speed"] == "0.001 to 0.1 m/s"
    assert "plugin, sha256" in made.facts
    names = ["measured", "loops", "verification", "validation"]
    assert [chart.name for chart in made.charts] == names
    table = pd.read_csv(sweep_folder / "impacts.csv")
    (panel,) = made.charts[0].views["Coefficient of restitution"]
    for k, (_, rows) in enumerate(table.groupby("law")):
        theory, points = panel.curves[2 * k : 2 * k + 2]
        np.testing.assert_allclose(points.y, rows["coefficient_of_restitution"])
        predicted = np.interp(rows["speed"], theory.x, theory.y)
        expected = rows["coefficient_of_restitution_predicted"]
        np.testing.assert_allclose(predicted, expected, rtol=1e-9)
    assert [row.law for row in made.trust] == ["kogut_etsion", "thornton", "universal"]
    assert all(row.verified["force_max"] < 2e-3 for row in made.trust)
    rms, largest = made.trust[-1].validated["coefficient_of_restitution"]
    assert rms <= largest < 0.02


def test_loops_belong_to_their_law_and_speed(sweep_folder):
    loops, table = section(sweep_folder).charts[1], pd.read_csv(sweep_folder / "impacts.csv")
    assert list(loops.views) == ["0.001 m/s", "0.01 m/s", "0.1 m/s"]
    fastest = table[table["speed"] == 0.1].sort_values("law")
    (panel,) = loops.views["0.1 m/s"]
    for curve, force in zip(panel.curves, fastest["force_max"], strict=True):
        # A chart keeps at least 40 points of a loop, which may miss the largest force by 2 %.
        assert max(curve.y) == pytest.approx(force, rel=0.02)


def test_unfinished_sweep_names_missing_impacts(copied_sweep):
    table = pd.read_csv(copied_sweep / "impacts.csv")
    table.iloc[:4].to_csv(copied_sweep / "impacts.csv", index=False)
    with open(next(copied_sweep.glob("runs/0007*")) / "log.liggghts", "a") as log:
        log.write("ERROR: Could not find fix (../x.cpp:1)\n")
    made = section(copied_sweep)
    assert (made.state, made.verdict) == ("unfinished", "4 of 9 impacts")
    assert "impacts.csv has 4 of 9 impacts." in made.missing[0]
    assert curve_count(made, 1) == 4
    assert "runs/0007" in made.missing[1] and "Could not find fix" in made.missing[1]
    (copied_sweep / "impacts.csv").unlink()
    (copied_sweep / "study.json").write_text("{")
    sentences = " ".join(section(copied_sweep).missing)
    assert "impacts.csv is missing" in sentences and "study.json is damaged" in sentences


@pytest.mark.parametrize("end", ["row", "number"])
def test_truncated_last_line_is_left_out_and_named(copied_sweep, end):
    file = copied_sweep / "impacts.csv"
    lines = file.read_text().splitlines(keepends=True)
    length = len(lines[4]) // 3 if end == "row" else len(lines[4]) - 4
    file.write_text("".join(lines[:4]) + lines[4][:length])
    made = section(copied_sweep)
    assert made.verdict == "3 of 9 impacts"
    assert made.missing[0] == "The last line of impacts.csv is truncated and omitted."


@pytest.mark.parametrize(
    ("column", "cell"),
    [("law", ""), ("options", ""), ("speed", "abc"), ("force_max", "nan"), ("radius", '1","2')],
)
def test_damaged_line_is_left_out_and_named(copied_sweep, column, cell):
    file = copied_sweep / "impacts.csv"
    head, *lines = file.read_text().splitlines()
    cells = lines[3].split(",")
    cells[head.split(",").index(column)] = cell
    lines[3] = ",".join(cells)
    file.write_text("\n".join([head, *lines]) + "\n")
    made = section(copied_sweep)
    assert made.verdict == "8 of 9 impacts"
    assert made.missing[0] == "Line 5 of impacts.csv is damaged and omitted."
    assert len(made.charts) == 4


@pytest.mark.parametrize("damage", ["a column is missing", "no text"])
def test_damaged_table_is_left_out_and_named(copied_sweep, damage):
    file = copied_sweep / "impacts.csv"
    if damage == "no text":
        file.write_bytes(file.read_bytes()[:600] + b"\xff\xfe")
    else:
        pd.read_csv(file).drop(columns="speed").to_csv(file, index=False)
    made = section(copied_sweep)
    assert "impacts.csv is damaged and not shown" in made.missing[0]
    assert (made.state, made.facts["command"]) == ("unfinished", "plastigran impact")


@pytest.mark.parametrize(
    ("entry", "value"), [("versions", None), ("words", 3), ("versions", {"plugin": 3})]
)
def test_damaged_entry_of_a_study_is_left_out_and_named(copied_sweep, entry, value):
    edit_json(copied_sweep / "study.json", {entry: value})
    made = section(copied_sweep)
    assert made.missing == [f"study.json is damaged: the entry {entry} is omitted."]
    assert made.tables[0].title == "Constants of the materials"
    assert len(made.charts) == 4


def test_damaged_trajectories_are_named(copied_sweep):
    next(copied_sweep.glob("runs/0003*/trajectory.dump")).write_text("nonsense\n")
    truncate(next(copied_sweep.glob("runs/0004*/trajectory.dump")), 0.99)
    made = section(copied_sweep)
    assert curve_count(made, 1) == 7
    assert "Loops of 2 impacts" in made.missing[0] and "runs/0003" in made.missing[0]


def test_loops_belong_to_their_radius(copied_sweep):
    """Force-overlap loops are assigned to the impacts with the radius of the trajectory.

    The results table has three radii; only the middle one has trajectories.
    """
    table = pd.read_csv(copied_sweep / "impacts.csv")
    others = [table.assign(radius=table["radius"] * factor) for factor in (0.5, 2)]
    pd.concat([others[0], table, others[1]]).to_csv(copied_sweep / "impacts.csv", index=False)
    loops = section(copied_sweep).charts[1]
    assert [name.partition(", ")[2] for name in loops.views] == 3 * ["radius 100 mm"]


def test_theory_alone_is_named_and_keeps_its_figures(tmp_path):
    with claim(tmp_path, force=False):
        CentralImpact.theory(law=["thornton"], speed=[0.01, 0.1]).write(tmp_path)
    made = section(tmp_path)
    assert (made.state, made.verdict) == ("done", "2 impacts by theory")
    assert made.facts["command"] == "plastigran impact"
    assert "without LIGGGHTS" in made.facts["made by"]
    assert [picture.name for picture in made.pictures] == ["loops", "restitution"]
    assert [chart.name for chart in made.charts] == ["validation"]


def test_theory_replaces_an_earlier_sweep(copied_sweep):
    with pytest.raises(ValueError, match="contains results"), claim(copied_sweep, force=False):
        pass
    (copied_sweep / "runs" / "mine").mkdir()
    with claim(copied_sweep, force=True):
        CentralImpact.theory(law=["thornton"], speed=[0.1]).write(copied_sweep)
    assert [path.name for path in (copied_sweep / "runs").iterdir()] == ["mine"]
    study = json.loads((copied_sweep / "study.json").read_text())
    assert study["by_theory"] and study["settings"]["law"] == ["thornton"]


def test_errors_of_a_law_are_for_the_speeds_of_the_sweep():
    """The expected error of a law holds for the range of speeds in the sweep.

    The error is unknown below yield, at speeds beyond the finite elements, and for unknown
    materials.
    """

    def theory(**settings) -> Trust:
        (row,) = trust(CentralImpact.theory(law=["thornton"], **settings).table, {})
        return row

    yields = CentralImpact("thornton", 0.1, "aluminium_zv02", 0.1).yield_speed()
    within = theory(speed=[2 * yields, 200 * yields])
    expected = expected_error("thornton", (2, 200), False, 0.01)
    errors = expected.restitution, expected.restitution_largest
    assert within.validated["coefficient_of_restitution"] == errors
    assert within.validated["force_max"] == (expected.force, expected.force_largest)
    assert theory(speed=[2 * yields, 2000 * yields]).validated == UNKNOWN
    assert theory(speed=[0.5 * yields]).validated == UNKNOWN
    table = CentralImpact.theory(law=["thornton"], speed=[2 * yields]).table
    for material in ("mine", "steel"):  # the table was computed for another metal
        (row,) = trust(table.assign(material=material), {})
        assert (row.validated, row.unknown_materials) == (UNKNOWN, [material])


def test_unknown_material_is_named(copied_sweep):
    table = pd.read_csv(copied_sweep / "impacts.csv").assign(material="mine")
    table.to_csv(copied_sweep / "impacts.csv", index=False)
    missing = section(copied_sweep).missing
    assert any("constants of mine are not available" in sentence for sentence in missing)


def test_validation_chart_shows_the_table_of_its_folder(tmp_path):
    errors_table().assign(rms=1.5).to_csv(tmp_path / "errors.csv", index=False)
    (chart,) = section(tmp_path).charts
    for (panel,) in chart.views.values():
        assert all((curve.y == 1.5).all() for curve in panel.curves)


def test_columns_with_one_title_have_separate_views():
    series = pd.DataFrame({"time": [0, 1], "Temp": [1, 2], "temp": [3, 5], "kinetic": [1, 2]})
    views = series_chart(series.assign(kinetic_energy=[5, 6])).views
    assert {*views} == {"Temp", "Temp (temp)", "Kinetic energy", "Translational kinetic energy"}
    assert len(QUANTITIES) == len({name for name, _ in QUANTITIES.values()})


def test_tables_and_materials_are_shown(tmp_path):
    pd.DataFrame({"law": ["universal"], "rms": [0.5]}).to_csv(tmp_path / "table.csv", index=False)
    (tmp_path / "empty.csv").write_text("")
    write_material(read_material("steel"), tmp_path / "mine.in", "From a hardness of 200 HV.")
    made = section(tmp_path)
    material, table = made.tables
    assert material.title == "Material mine: From a hardness of 200 HV."
    assert ["Young's modulus", "2.1 × 10¹¹", "Pa"] in material.rows
    assert (table.head, table.rows) == (["law", "rms"], [["universal", "0.5"]])
    assert table.laws == ["universal"]
    assert "empty.csv cannot be read" in made.missing[0]


@pytest.mark.parametrize("suffix", [".png", ".svg", ".gif"])
@pytest.mark.parametrize("fraction", [0, 0.5])
def test_damaged_picture_is_left_out_and_named(tmp_path, suffix, fraction):
    figure, axes = subplots(figsize=(2, 2))
    axes.plot([0, 1])
    for name in ("broken", "whole"):
        (file,) = save(figure, tmp_path / name, (".svg",) if suffix == ".svg" else (".png",))
        if suffix == ".gif":
            Image.open(file).save(file.with_suffix(".gif"))
            file.unlink()
    broken = tmp_path / f"broken{suffix}"
    truncate(broken, fraction)
    made = section(tmp_path)
    assert [picture.name for picture in made.pictures] == ["whole"]
    assert made.missing == [f"Figure broken is left out, because {broken} is cut short or damaged."]
    assert write_report([tmp_path], tmp_path / "report.html").exists()


def test_command_writes_a_page_and_keeps_other_files(tmp_path, capsys):
    folder = tmp_path / "<b>results"
    folder.mkdir()
    assert main(["report", str(folder)]) == 0
    page = folder / "report.html"
    assert f"written: {page}" in capsys.readouterr().out
    text = page.read_text()
    assert "<b>" not in text and "&lt;b&gt;results" in text
    assert "has no results of a plastigran command" in text
    assert main(["report", str(folder)]) == 0  # a report is replaced
    page.write_text("something else")
    assert main(["report", str(folder)]) == 1
    assert "is not a report. Choose another name, or add --force" in capsys.readouterr().err
    assert main(["report", str(tmp_path / "none")]) == 1
    assert "is not a folder" in capsys.readouterr().err
    with pytest.raises(ValueError, match=r"must end in \.html"):
        write_report([folder], tmp_path / "page.txt")


def test_full_disk_keeps_the_earlier_page(tmp_path):
    """If the disk is full, the earlier page stays unchanged, and no temporary file remains.

    If the page is a symbolic link, a new report replaces its target, not the link.
    """
    (tmp_path / "results").mkdir()
    page = write_report([tmp_path / "results"], tmp_path / "report.html")
    before = page.read_text()
    signal_before = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, limits[1]))
    try:
        with pytest.raises(OSError, match="File too large"):
            write_report([tmp_path / "results"], page, "Another")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, signal_before)
    assert page.read_text() == before
    assert sorted(path.name for path in tmp_path.iterdir()) == ["report.html", "results"]
    (tmp_path / "link.html").symlink_to(page)
    write_report([tmp_path / "results"], tmp_path / "link.html", "Another")
    assert (tmp_path / "link.html").is_symlink() and "Another" in page.read_text()
