# SPDX-License-Identifier: GPL-2.0-or-later
"""The Python blocks of every page run in order, in a folder with the results that pages mention.

Bulk runs have the settings of the short runs that their decks declare.
"""

from __future__ import annotations

import re
import shutil
import warnings
from pathlib import Path
from textwrap import dedent

import attrs
import matplotlib
import pandas as pd
import pytest

import plastigran as pg
from plastigran.bulk.decks import deck_class
from plastigran.bulk.folder import read_record
from plastigran.contact import RangeWarning
from plastigran.engine.process import PROJECT

PAGES = [PROJECT / "README.md", *sorted((PROJECT / "docs").rglob("*.md"))]
BLOCK = re.compile(r"^ *```python\n(.*?)^ *```", re.MULTILINE | re.DOTALL)


def blocks(page: Path) -> list[str]:
    return [dedent(block) for block in BLOCK.findall(page.read_text())]


def test_pages_have_python():
    assert sum(len(blocks(page)) for page in PAGES) > 15


@pytest.fixture(scope="module")
def results(tmp_path_factory, brief_run, bulk_run) -> Path:
    """A folder with a hopper's run, a sweep, a trajectory and collision spectra."""
    place = tmp_path_factory.mktemp("pages")
    shutil.copytree(brief_run("hopper").folder, place / "results" / "hopper")
    pg.collide("thornton", 0.1, "steel", radius=5e-3, folder=place / "results" / "steel")
    (trajectory,) = (place / "results" / "steel").rglob("trajectory.dump")
    shutil.copy(trajectory, place)
    drum = bulk_run("drum", deck_class("drum").briefs[""].settings | {"spectra": "on"})
    spectra = pd.read_csv(drum.folder / "collision_spectra.csv")
    spectra["step"] *= 1000  # the page skips the first 100 000 steps
    spectra.to_csv(place / "collision_spectra.csv", index=False)
    return place


@attrs.frozen
class Discharge:
    """Replacement for a run of the hopper. Its rate depends on the orifice as in Beverloo's law."""

    run: object
    orifice: float

    @property
    def deck(self):
        settings = read_record(self.run.folder)["settings"]
        changes = {"orifice": str(self.orifice), "output": self.run.folder}
        return type(self.run.deck).read(settings | changes)

    @property
    def series(self):
        factor = ((self.orifice - 1.4) / (float(self.run.deck.orifice) - 1.4)) ** 2.5
        return self.run.series.assign(time=self.run.series["time"] / factor)


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page)], ids=lambda p: p.stem)
def test_python_of_a_page_runs(page, results, tmp_path, monkeypatch):
    place = tmp_path / "page"
    shutil.copytree(results, place)
    monkeypatch.chdir(place)
    matplotlib.use("Agg")
    recorded = pg.open(PROJECT / "docs" / "notebooks" / "hopper_run")

    def bulk(deck, *, orifice=None, **settings):
        assert deck == "hopper"
        names = {field.name for field in attrs.fields(deck_class("hopper"))}
        assert settings.keys() <= names | {"folder", "ranks", "show"}
        if orifice is not None:
            return Discharge(recorded, orifice)
        return pg.open("results/hopper")

    monkeypatch.setattr(pg, "bulk", bulk, raising=False)
    monkeypatch.syspath_prepend(str(place))
    names = {"__name__": "page"}
    for block in blocks(page):
        if "class ElasticImpact(Experiment)" in block:  # the page names this file
            (place / "touch.py").write_text(block)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RangeWarning)
            exec(compile(block, str(page), "exec"), names)


def test_yield_strength_of_the_rate_factor():
    """The code of docs/rate_factor.md gives the rate factors and the strength of the page."""
    names: dict = {}
    exec(blocks(PROJECT / "docs" / "rate_factor.md")[0], names)
    laws, pair, law = names["laws"], names["pair"], names["law"]
    factors = laws.rate_factor(pair, 1e-3, [0.01, 1.0, 100.0])
    assert list(factors) == pytest.approx([1.0128, 1.0773, 1.1418], abs=5e-5)
    assert law.at_impact(1e-3, 1.0).pair.yield_strength == pytest.approx(6.4638e8, rel=1e-4)
