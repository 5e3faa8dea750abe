# SPDX-License-Identifier: GPL-2.0-or-later
"""`./run figures` draws every figure of the docs in parts, and continues where it stopped."""

from __future__ import annotations

import re
from pathlib import Path

import bulk_figures
import make_figures
import pytest

from plastigran.bulk.outcome import BulkRun
from plastigran.engine.process import PROJECT
from plastigran.papers import find_paper, paper_names
from plastigran.validation.report import EVIDENCE

#: Settings of the hopper for a steady discharge; the tests of the hopper use the same run.
HOPPER = {"orifice": 8, "layers": 10, "timestep": 3e-5, "duration": 0.7, "rows": 150}
HOPPER |= {"filling": 0.2, "checkpoints": 1}


def test_a_figure_of_each_kind_of_law(tmp_path):
    names = ["brake_2015", "katta_polycarpou", "viscoelastic_hertz"]
    make_figures.main(names, tmp_path)
    assert sorted(path.stem for path in tmp_path.iterdir()) == names


def test_figures_of_the_bulk_decks(brief_run, bulk_run, tmp_path, monkeypatch):
    def run(deck: str, values: dict, _: Path) -> BulkRun:
        if deck == "hopper":
            return bulk_run(deck, HOPPER)
        return brief_run(deck, values.get("target", ""))

    monkeypatch.setattr(bulk_figures, "run_bulk", run)
    # The runs are too short to pass all checks.
    monkeypatch.setattr(BulkRun, "raise_if_failed", lambda self: self)
    parts = ["drum", "chute", "cooling_gas", "compaction", "uniaxial_test", "bed_impact"]
    make_figures.main(parts, tmp_path)
    drawn = sorted(path.name for path in tmp_path.iterdir())
    assert drawn == sorted(
        f"{name}.png" for name in (*parts[:-1], "bed_impact_bed", "bed_impact_plate")
    )
    # All four orifices have the same run here.
    with pytest.raises(ValueError, match="three or more orifice diameters"):
        bulk_figures.hoppers()


def test_every_figure_of_the_docs_has_a_part():
    """`./run figures` draws all figures of the docs except a screenshot and two of benchmarks."""
    drawn = {f"{name}.svg" for name in make_figures.laws.LAWS}
    drawn |= {file for _, files in make_figures.EXPERIMENTS.values() for file in files.values()}
    drawn |= {f"{name}.png" for name in make_figures.BULK} - {"bed_impact.png"}
    drawn |= {"bed_impact_bed.png", "bed_impact_plate.png"}
    drawn |= {"calibrate_drops.png", "calibrate_finite_elements.png"}
    drawn |= {"overview.png", "adhesion.png", "universal_fit.svg", "universal_errors.svg"}
    figures = PROJECT / "docs" / "figures"
    there = {path.name for path in figures.iterdir() if path.is_file()} - {
        "report.png",
        "peers.svg",
        "cost.svg",
    }
    assert there == drawn
    papers = {name: set(find_paper(name).figures) for name in paper_names()}
    for name, named in (papers | {"validation": set(EVIDENCE.figures)}).items():
        folder = figures / "validation" if name == "validation" else figures / "papers" / name
        drawn = {path.stem for path in folder.iterdir() if path.suffix != ".gif"}  # except movies
        assert drawn == named


def test_each_part_starts(tmp_path, monkeypatch):
    """Each part of `./run figures` starts: it reaches the first call of its computation."""
    begun = []

    def begin(name):
        def start(*words, **keys):
            begun.append((name, *map(str, words[:1])))
            raise InterruptedError

        return start

    monkeypatch.setattr("law_figures.save", begin("law"))
    for name in ("adhesion_figure", "calibrate", "overview_figure", "plastigran"):
        monkeypatch.setattr(make_figures, name, begin(name))
    monkeypatch.setattr(bulk_figures, "run_bulk", begin("bulk"))
    monkeypatch.setattr("flow_function.run_bulk", begin("bulk"))
    monkeypatch.setattr("plastigran.experiments.base.sweep", begin("sweep"))
    monkeypatch.setattr("plastigran.validation.spheres.fit.fit", begin("fit"))
    parts = make_figures.parts()
    for draw in parts.values():
        with pytest.raises(InterruptedError):
            draw(tmp_path)
    assert len(begun) == len(parts)


def test_a_round_continues_where_it_stopped(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(make_figures, "DONE", tmp_path / "done.txt")
    drawn, broken = [], [True]

    def second(folder: Path) -> None:
        if broken.pop():
            raise KeyboardInterrupt
        drawn.append("second")

    found = {"first": lambda folder: drawn.append("first"), "second": second}
    with pytest.raises(KeyboardInterrupt):
        make_figures.draw_all(found, tmp_path, again=False)
    broken.append(False)
    make_figures.draw_all(found, tmp_path, again=False)
    assert drawn == ["first", "second"]
    broken.append(False)
    make_figures.draw_all(found, tmp_path, again=False)  # the next round
    assert drawn == ["first", "second"] * 2
    assert not make_figures.DONE.exists()


def test_parts_are_listed_and_unknown_ones_refused(capsys):
    make_figures.main(["--list"])
    listed = capsys.readouterr().out.split()
    assert {"universal", "rod", "hopper", "validation", "zv02"} <= set(listed)
    with pytest.raises(SystemExit):
        make_figures.main(["nix"])
    assert re.search("invalid choice: 'nix'", capsys.readouterr().err)
