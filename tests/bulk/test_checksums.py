# SPDX-License-Identifier: GPL-2.0-or-later
"""Checksums of checkpoints."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from plastigran.bulk.plan import plan_bulk
from plastigran.engine.checkpoints import (
    PATTERN,
    ChecksumWriter,
    checkpoints,
    differs,
    newest_checkpoint,
)
from plastigran.engine.process import EngineError


@pytest.fixture
def copied(short_gas, tmp_path) -> Path:
    """A copy of it, to be changed."""
    return Path(shutil.copytree(short_gas, tmp_path / "run"))


@pytest.mark.parametrize("seed", range(12))
def test_a_flipped_bit_of_a_checkpoint_is_noticed(short_gas, seed, tmp_path):
    """Anywhere in the file: an earlier one is taken, and where all are damaged, none."""
    run = Path(shutil.copytree(short_gas, tmp_path / "run"))
    assert not list(run.glob("*.new"))
    *earlier, newest = checkpoints(run)
    assert newest_checkpoint(run) == newest
    place = np.random.default_rng(seed)

    def flip(file: Path) -> None:
        content = bytearray(file.read_bytes())
        content[place.integers(len(content))] ^= 1 << place.integers(8)
        file.write_bytes(content)

    flip(newest)
    with pytest.warns(UserWarning, match=rf"{newest.name} is damaged: it differs from"):
        assert newest_checkpoint(run) == earlier[-1]
    with pytest.raises(EngineError, match=rf"{newest.name} is damaged: .* Choose another"):
        plan_bulk("cooling_gas", {"start": "checkpoint", "checkpoint": newest}, tmp_path / "rest")
    for file in earlier:
        flip(file)
    with pytest.warns(UserWarning), pytest.raises(EngineError, match="no whole checkpoint"):
        newest_checkpoint(run)


def test_a_checkpoint_has_its_checksum(short_gas):
    """As `sha256sum --check` reads them."""
    sums = sorted(short_gas.glob(f"{PATTERN}.sha256"))
    assert len(sums) == len(checkpoints(short_gas)) > 1
    done = subprocess.run(["sha256sum", "--check", *(file.name for file in sums)], cwd=short_gas)
    assert done.returncode == 0


def test_a_checkpoint_written_again_has_a_new_checksum(copied):
    """A deck may count its steps anew and write files of the same names."""
    first, second, *_ = checkpoints(copied)
    written = first.with_name(f"{first.name}.sha256").stat().st_mtime_ns
    shutil.copyfile(second, first)
    os.utime(first, ns=(written + 1, written + 1))
    assert differs(first)
    ChecksumWriter(copied).update()
    assert not differs(first)


def test_a_checksum_that_cannot_be_written_stops_no_run(copied):
    """Said once: the engine runs meanwhile."""
    for file in copied.glob("*.sha256"):
        file.unlink()
        (copied / f"{file.name}.new").mkdir()
    writer = ChecksumWriter(copied)
    with pytest.warns(UserWarning, match="no checksum is written: Is a directory") as message:
        writer.update()
        writer.update()
    assert len(message) == 1


def test_a_damaged_checkpoint_named_from_the_decks_folder_is_refused(copied, tmp_path):
    file = checkpoints(copied)[0]
    file.write_bytes(file.read_bytes()[:-1] + b"!")
    deck = tmp_path / "own.in"
    lines = f"variable start index checkpoint\nvariable checkpoint index run/{file.name}\n"
    deck.write_text(lines + "read_restart ${checkpoint}\nrun 1\n")
    with pytest.raises(EngineError, match=f"{file.name} is damaged"):
        plan_bulk(deck, {}, tmp_path / "rest")
