# SPDX-License-Identifier: GPL-2.0-or-later
"""Run a bulk deck, check its invariants, draw its figures, leave a folder that tells the whole.

The folder holds `run.json` (deck, every setting, ranks, versions), `deck/` (the deck as it ran,
with its includes), the logs, numbered checkpoints, and at the end `series.csv`, `checks.csv` and
`figures/`.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import warnings
from collections.abc import Mapping
from dataclasses import asdict
from importlib.metadata import version
from pathlib import Path
from types import ModuleType

import pandas as pd

from plastigran.bulk.decks import Analysis, module_of
from plastigran.engine.checkpoints import PATTERN, newest_checkpoint, step_of
from plastigran.engine.deck import Settings, find_deck, read_deck
from plastigran.engine.dumps import DumpError, TruncatedFileWarning
from plastigran.engine.log import read_thermo
from plastigran.engine.process import EngineError, engine_path, run_deck
from plastigran.plot import style

RECORD = "run.json"
#: The log's lines up to the checkpoint a run went on from.
BEFORE = "before.csv"
SERIES = "series.csv"
#: Frames of the grains, which decks append to.
DUMP = "grains.dump"
#: Settings a run that goes on may change; a deck's module may name more of them, CONTINUABLE.
CONTINUABLE = frozenset({"frames"})
#: Where a run's files are and begin, which is never the same.
PLACES = frozenset({"start", "checkpoint", "inputs", "output", "materials"})
#: What a run leaves, for one that may overwrite it.
LEFT = (
    RECORD,
    f"{RECORD}.new",
    BEFORE,
    "log.liggghts",
    "screen.txt",
    PATTERN,
    "restart_forced_*",
    DUMP,
    SERIES,
    "checks.csv",
)


class CheckError(ValueError):
    """A deck ran to its end but broke one of its invariants; the message says which."""


def run_bulk(
    deck: str | Path,
    values: Mapping[str, str],
    folder: str | Path,
    ranks: int = 1,
    restart: str | Path | None = None,
    force: bool = False,
    show: bool = True,
) -> Analysis | None:
    """Run a deck from its start or from the newest whole checkpoint of an earlier run.

    Args:
        deck: Name of a deck of `inputs/bulk`, or path of an input script.
        values: Settings given another value than the deck's, or with `restart` than the earlier
            run's.
        folder: Where results go.
        ranks: MPI ranks.
        restart: Folder of the earlier run.
        force: Overwrite an earlier run in `folder`.
        show: Show a progress bar.

    Returns:
        What the deck's module made of it, also written to `folder`; None for a deck without one.

    Raises:
        EngineError: No such deck, no whole checkpoint, or the engine stopped with an error.
        ValueError: An unknown setting, or one out of range, or `folder` holds results.
        CheckError: The deck broke an invariant; everything is written before.
    """
    folder, deck = Path(folder).resolve(), find_deck(deck)
    values, before = dict(values), None
    if restart is not None:
        restart = Path(restart).resolve()
        earlier = read_record(restart)
        if earlier["deck"] != deck.stem:
            raise ValueError(f"{restart} is a run of {earlier['deck']}, not of {deck.stem}")
        if restart == folder:
            raise ValueError(f"{folder} is the run to go on from; choose another --output")
        checkpoint = restart_point(restart, earlier)
        values = earlier["values"] | values | {"start": "checkpoint", "checkpoint": str(checkpoint)}
        before = read_series(restart).query(
            "step <= @step", local_dict={"step": step_of(checkpoint)}
        )
    source, module = read_deck(deck, values, folder), module_of(deck.stem)
    if module:
        if before is not None:
            check_continued(source.settings, earlier["settings"], module)
        module.check_settings(source.settings)

    prepare_folder(folder, force)
    # The engine reads a script as it goes: run one that nobody edits meanwhile.
    script = source.copy(folder / "deck")
    record = {
        "deck": deck.stem,
        "values": {name: str(value) for name, value in values.items()},
        "settings": source.settings,
        "ranks": ranks,
        "restart": str(restart) if restart else None,
        "versions": {"plastigran": version("plastigran"), "plugin": _fingerprint()},
    }
    if before is not None:
        before.to_csv(folder / BEFORE, index=False)
        carry_dump(restart, folder, step_of(checkpoint))
    write_record(folder, record)  # last: a folder with a record can be gone on from
    try:
        run_deck(
            script, values | {"inputs": folder / "deck"}, folder, ranks, timeout=None, progress=show
        )
    finally:
        if (log := folder / "log.liggghts").exists():
            record["versions"]["engine"] = log.read_text(errors="replace").partition("\n")[0]
            write_record(folder, record)
    series = read_series(folder)
    series.to_csv(folder / SERIES, index=False)  # whatever comes of its analysis
    return finish(module.analyse(source.settings, series), folder) if module else None


def finish(analysis: Analysis, folder: Path) -> Analysis:
    """Write table, checks and figures.

    Raises:
        CheckError: A check failed.
    """
    analysis.table.to_csv(folder / SERIES, index=False)
    checks = pd.DataFrame([asdict(c) | {"passed": c.passed} for c in analysis.checks])
    checks.to_csv(folder / "checks.csv", index=False)
    for name, figure in analysis.figures.items():
        style.save(figure, folder / "figures" / name)
    if failed := [check for check in analysis.checks if not check.passed]:
        said = "; ".join(f"{c.name} {c.value:.3g}, at most {c.limit:.3g}" for c in failed)
        raise CheckError(f"{said} (in {folder})")
    return analysis


def check_continued(settings: Settings, earlier: Settings, module: ModuleType) -> None:
    """A run that goes on is the same run: grains and course are in the checkpoint.

    Raises:
        ValueError: A setting has changed that may not; the message names it.
    """
    allowed = CONTINUABLE | getattr(module, "CONTINUABLE", frozenset())
    for name in settings.keys() - allowed - PLACES:
        if settings[name] != earlier.get(name, settings[name]):
            raise ValueError(
                f"{name} is {settings[name]} and was {earlier[name]}; a run that goes on may "
                f"change {', '.join(sorted(allowed))} only"
            )


def carry_dump(earlier: Path, folder: Path, last: int) -> None:
    """Copy the frames of an earlier run before a step, for the engine to append to."""
    mark = "ITEM: TIMESTEP\n"
    if not (earlier / DUMP).exists():
        return
    with open(folder / DUMP, "w") as kept:
        for frame in (earlier / DUMP).read_text().split(mark)[1:]:
            if int(frame.partition("\n")[0]) < last:
                kept.write(mark + frame)


def restart_point(folder: Path, record: dict) -> Path:
    """The newest whole checkpoint of a run; of one stopped before its first, where it began.

    Raises:
        EngineError: There is none.
    """
    try:
        return newest_checkpoint(folder)
    except EngineError:
        began = Path(record["values"].get("checkpoint", "none"))
        if not began.is_file():
            raise
        return began


def read_series(folder: str | Path) -> pd.DataFrame:
    """The log of a run from step 0 on, whatever checkpoints it went on from.

    Returns:
        One row a line: `step`, `time` [s] from step 0, then the deck's columns in SI units.

    Raises:
        DumpError: The log shows nothing yet.
    """
    folder = Path(folder)
    parts = [pd.read_csv(folder / BEFORE)] if (folder / BEFORE).exists() else []
    try:
        parts.append(_read_log(folder))
    except (DumpError, FileNotFoundError):
        if not parts:  # else the run was stopped before its first line
            raise
    # The checkpoint's line is the earlier log's: while setting up, meshes know no forces.
    return pd.concat(parts, ignore_index=True).drop_duplicates("step", ignore_index=True)


def _read_log(folder: Path) -> pd.DataFrame:
    with warnings.catch_warnings():
        # The run was stopped: its end is known.
        warnings.simplefilter("ignore", TruncatedFileWarning)
        log = read_thermo(folder / "log.liggghts")
    series = log[log["run"] == log["run"].max()].drop(columns="run").reset_index(drop=True)
    series.insert(1, "time", series["step"] * series.pop("timestep"))
    return series.rename(columns=lambda name: name.removeprefix("v_"))


def read_record(folder: str | Path) -> dict:
    """What `run.json` says, `settings` as Settings. Raises EngineError when there is none."""
    path = Path(folder) / RECORD
    if not path.is_file():
        raise EngineError(f"{folder} holds no {RECORD}; it is not a run of `plastigran bulk`")
    record = json.loads(path.read_text())
    return record | {"settings": Settings(record["settings"])}


def write_record(folder: Path, record: dict) -> None:
    """Write `run.json`, whole or not at all."""
    draft = folder / f"{RECORD}.new"
    draft.write_text(json.dumps(record, indent=2) + "\n")
    draft.replace(folder / RECORD)


def prepare_folder(folder: Path, force: bool) -> None:
    """An empty folder for a run; of one that holds a run only that run's own files are removed.

    Raises:
        ValueError: It holds files and `force` is not given, or they are not those of a run.
    """
    if folder.exists() and any(folder.iterdir()):
        if not force:
            raise ValueError(f"{folder} holds results; choose another --output, or add --force")
        if not (folder / RECORD).is_file():
            raise ValueError(f"{folder} holds files but no {RECORD}; --force overwrites runs only")
        for pattern in LEFT:  # above all checkpoints, which may be newer than ours
            for file in folder.glob(pattern):
                file.unlink()
        for name in ("deck", "figures", "frames"):
            shutil.rmtree(folder / name, ignore_errors=True)
    folder.mkdir(parents=True, exist_ok=True)


def _fingerprint() -> str:
    """File and SHA-256 of the plugin beside the engine."""
    plugin = engine_path().parent / "libplastigran.so"
    if not plugin.exists():
        return f"none beside {engine_path()}"
    return f"{plugin.name} sha256 {hashlib.sha256(plugin.read_bytes()).hexdigest()}"
