# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs that several tests of bulk decks share."""

from __future__ import annotations

from pathlib import Path

import pytest
from own_decks import PLAIN, PROPERTIES

from plastigran.bulk.template import write_deck

#: Settings of a cooling gas with many checkpoints that takes a second.
SHORT_GAS = {"side": 5, "duration": 24, "rows": 24, "checkpoints": 12, "mixing": 1}


@pytest.fixture(scope="module")
def short_gas(bulk_run) -> Path:
    """Folder of a finished run on one rank."""
    return bulk_run("cooling_gas", SHORT_GAS).folder


@pytest.fixture
def plain(tmp_path) -> Path:
    """A deck in a folder with white space in its name, with its include and mesh."""
    folder = tmp_path / "my decks"
    (folder / "meshes").mkdir(parents=True)
    template = write_deck(tmp_path / "template", "thornton", "steel")
    (template.parent / "plate.stl").rename(folder / "meshes" / "plate.stl")
    (folder / "properties.in").write_text(PROPERTIES)
    (folder / "plain.in").write_text(PLAIN, encoding="latin-1")
    return folder / "plain.in"
