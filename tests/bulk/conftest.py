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
    """`steady_flow(deck)` runs a deck with its settings in `STEADY_FLOWS`."""

    def run(deck: str) -> BulkRun:
        return bulk_run(deck, STEADY_FLOWS[deck])

    return run


@pytest.fixture(scope="module")
def short_gas(bulk_run) -> Path:
    """Folder of a finished run of the deck `cooling_gas` on one MPI rank."""
    return bulk_run("cooling_gas", SHORT_GAS).folder


@pytest.fixture
def cut_log(short_gas, tmp_path):
    """`cut_log(lines)` copies the run `short_gas` and removes the last lines of its log.

    The last remaining line is incomplete, as if LIGGGHTS had been killed.
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
    """A user's deck with its include file and mesh, in a folder whose name has a space."""
    folder = tmp_path / "my decks"
    (folder / "meshes").mkdir(parents=True)
    template = write_deck(tmp_path / "template", "thornton", "steel")
    (template.parent / "plate.stl").rename(folder / "meshes" / "plate.stl")
    (folder / "properties.in").write_text(PROPERTIES)
    (folder / "plain.in").write_text(PLAIN, encoding="latin-1")
    return folder / "plain.in"
