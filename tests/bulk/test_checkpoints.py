# SPDX-License-Identifier: GPL-2.0-or-later
"""Checkpoints: selection of the newest usable one, and checksums."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from bulk_settings import SHORT_GAS

from plastigran.bulk.plan import plan_bulk
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series
from plastigran.engine.checkpoints import (
    PATTERN,
    ChecksumWriter,
    checkpoints,
    differs,
    newest_checkpoint,
    step_of,
)
from plastigran.engine.process import EngineError


@pytest.fixture
def copied(short_gas, tmp_path) -> Path:
    """A copy of the run `short_gas` that a test may change."""
    return Path(shutil.copytree(short_gas, tmp_path / "run"))


def test_checkpoint_beyond_the_log_is_not_the_newest(short_gas, cut_log):
    """A checkpoint after the last complete log line is not used.

    LIGGGHTS may still have been writing it when it stopped.
    """
    stopped = cut_log(lines=8)
    steps = read_series(short_gas)["step"]
    # Of the log lines 0 to 24, number 15 is the last complete one. Even lines have a checkpoint.
    assert step_of(newest_checkpoint(stopped)) == steps[14]
    assert (stopped / f"checkpoint.{steps[16]}.restart").exists()


@pytest.mark.parametrize("ranks", [1, 2])
def test_incomplete_checkpoint_is_not_the_newest(short_gas, ranks, tmp_path):
    """An incomplete checkpoint is not used: a full disk truncates it or fills its rest with zeros.

    The test removes the checksums, because a killed run may lack them. A complete file may end with
    zeros: LIGGGHTS writes one zero for each rank without particles.
    """
    folder = tmp_path / "full"
    if ranks == 1:
        shutil.copytree(short_gas, folder)
    else:
        short = SHORT_GAS | {"duration": 2, "rows": 2, "checkpoints": 2}
        run_bulk("cooling_gas", short, folder, ranks, show=False)
    for file in folder.glob(f"{PATTERN}.sha256"):
        file.unlink()
    before, last = checkpoints(folder)[-2:]
    assert newest_checkpoint(folder) == last
    content = last.read_bytes()
    half = len(content) // 2
    cuts = [content[:length] for length in (0, 3, 500, *range(half, len(content), 97))]
    cuts += [content[:-1], content[:half] + bytes(half), content[:half] + bytes(10**6)]
    for cut_short in cuts:
        last.write_bytes(cut_short)
        with pytest.warns(UserWarning, match=f"{last.name} is incomplete or damaged"):
            assert newest_checkpoint(folder) == before
    last.write_bytes(content + bytes(4 * 3))
    assert newest_checkpoint(folder) == last


def test_missing_checkpoint_is_an_error(tmp_path):
    """A run cannot continue from a folder without a log and without a complete checkpoint."""
    (tmp_path / "checkpoint.100.restart").write_bytes(b"half")
    with pytest.raises(EngineError, match="no complete checkpoint"):
        newest_checkpoint(tmp_path)
    (tmp_path / "checkpoint.0.restart").write_bytes(b"half")
    with (
        pytest.warns(UserWarning, match="incomplete or damaged"),
        pytest.raises(EngineError, match="no complete checkpoint"),
    ):
        newest_checkpoint(tmp_path)


def test_other_files_are_ignored(copied):
    """Files whose names contain no step are not checkpoints, and `force` does not remove them."""
    newest = newest_checkpoint(copied)
    for name in ("checkpoint.old.restart", "checkpoint.999999999.old.restart"):
        shutil.copy(newest, copied / name)
    assert newest_checkpoint(copied) == newest
    run_bulk("cooling_gas", SHORT_GAS, copied, force=True, show=False)
    assert (copied / "checkpoint.old.restart").exists()


def test_checkpoint_beyond_a_damaged_log_is_named(copied, short_gas):
    """If the log is cut or missing, the message names the newest complete checkpoint."""
    *earlier, before, last = checkpoints(copied)
    for file in earlier:
        file.unlink()
    last.write_bytes(b"half")
    log, steps = copied / "log.liggghts", read_series(short_gas)["step"]
    text = log.read_text()
    for content, state in (
        (text[: text.rindex(f"\n{steps[3]:8d} ") + 1], f"ends at step {steps[2]}"),
        ("LIGGGHTS\n", "shows no step"),
        (None, "is missing"),
    ):
        log.unlink() if content is None else log.write_text(content)
        with pytest.raises(EngineError, match=rf"{log} {state}.* {before.name}"):
            newest_checkpoint(copied)


@pytest.mark.parametrize("seed", range(12))
def test_flipped_bit_is_noticed(copied, seed, tmp_path):
    """After a flipped bit in the newest checkpoint, an earlier one is used, or none if all are
    damaged."""
    assert not list(copied.glob("*.new"))
    *earlier, newest = checkpoints(copied)
    assert newest_checkpoint(copied) == newest
    random = np.random.default_rng(seed)

    def flip(file: Path) -> None:
        content = bytearray(file.read_bytes())
        content[random.integers(len(content))] ^= 1 << random.integers(8)
        file.write_bytes(content)

    flip(newest)
    with pytest.warns(UserWarning, match=rf"{newest.name} is .*damaged"):
        assert newest_checkpoint(copied) == earlier[-1]
    with pytest.raises(EngineError, match=rf"{newest.name} is damaged: .* Choose another"):
        plan_bulk("cooling_gas", {"start": "checkpoint", "checkpoint": newest}, tmp_path / "rest")
    for file in earlier:
        flip(file)
    with pytest.warns(UserWarning), pytest.raises(EngineError, match="no complete checkpoint"):
        newest_checkpoint(copied)


def test_sha256sum_accepts_the_checksums(short_gas):
    sums = sorted(short_gas.glob(f"{PATTERN}.sha256"))
    assert len(sums) == len(checkpoints(short_gas)) > 1
    done = subprocess.run(["sha256sum", "--check", *(file.name for file in sums)], cwd=short_gas)
    assert done.returncode == 0


def test_rewritten_checkpoint_gets_a_new_checksum(copied):
    """A checkpoint that LIGGGHTS writes again gets a new checksum, as after `reset_timestep`."""
    first, second, *_ = checkpoints(copied)
    written = first.with_name(f"{first.name}.sha256").stat().st_mtime_ns
    shutil.copyfile(second, first)
    os.utime(first, ns=(written + 1, written + 1))
    assert differs(first)
    ChecksumWriter(copied, copied / "log.liggghts").update()
    assert not differs(first)


def test_failure_to_write_a_checksum_gives_one_warning(copied):
    """If checksums cannot be written, there is one warning for all of them."""
    for file in copied.glob("*.sha256"):
        file.unlink()
        (copied / f"{file.name}.new").mkdir()
    writer = ChecksumWriter(copied, copied / "log.liggghts")
    with pytest.warns(UserWarning, match="cannot write a checksum: Is a directory") as warned:
        writer.update()
        writer.update()
    assert len(warned) == 1


def test_damaged_checkpoint_of_a_users_deck_is_refused(copied, tmp_path):
    """Damage is also found if the path of the checkpoint is relative to the folder of the deck."""
    file = checkpoints(copied)[0]
    file.write_bytes(file.read_bytes()[:-1] + b"!")
    deck = tmp_path / "own.in"
    lines = f"variable start index checkpoint\nvariable checkpoint index run/{file.name}\n"
    deck.write_text(lines + "read_restart ${checkpoint}\nrun 1\n")
    with pytest.raises(EngineError, match=f"{file.name} is damaged"):
        plan_bulk(deck, {}, tmp_path / "rest")
