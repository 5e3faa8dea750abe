# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs that several tests of bulk decks share."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from bulk_settings import SHORT_GAS, STEADY_FLOWS
from own_decks import PLAIN, PROPERTIES

from plastigran.bulk.outcome import BulkRun
from plastigran.bulk.template import write_deck


@pytest.fixture(scope="session")
def steady_flow(bulk_run):
    """`steady_flow(deck)` runs the steady flow of a deck."""

    def run(deck: str) -> BulkRun:
        return bulk_run(deck, STEADY_FLOWS[deck])

    return run


@pytest.fixture(scope="module")
def short_gas(bulk_run) -> Path:
    """Folder of a finished run of a gas on one rank."""
    return bulk_run("cooling_gas", SHORT_GAS).folder


@pytest.fixture
def cut_log(short_gas, tmp_path):
    """`cut_log(lines)` copies the run and removes lines at the end of its log, as after a kill.

    The last remaining line is incomplete.
    """

    def cut(lines: int) -> Path:
        folder = Path(shutil.copytree(short_gas, tmp_path / "stopped"))
        mixing, mark, rest = (folder / "log.liggghts").read_text().partition("Loop time")
        cooling = rest.partition("Loop time")[0].rstrip("\n").splitlines(keepends=True)
        (folder / "log.liggghts").write_text(mixing + mark + "".join(cooling[:-lines])[:-5])
        return folder

    return cut


@pytest.fixture
def plain(tmp_path) -> Path:
    """User's deck in a folder with white space in its name, with its include and mesh."""
    folder = tmp_path / "my decks"
    (folder / "meshes").mkdir(parents=True)
    template = write_deck(tmp_path / "template", "thornton", "steel")
    (template.parent / "plate.stl").rename(folder / "meshes" / "plate.stl")
    (folder / "properties.in").write_text(PROPERTIES)
    (folder / "plain.in").write_text(PLAIN, encoding="latin-1")
    return folder / "plain.in"
