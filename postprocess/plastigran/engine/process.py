# SPDX-License-Identifier: GPL-2.0-or-later
"""Find and run the engine: `liggghts-plastigran` on one rank or under mpirun."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import TextIO

PROJECT = Path(__file__).resolve().parents[3]

_INDEX_VARIABLE = re.compile(r'^\s*variable\s+(\w+)\s+index\s+(?:"([^"]*)"|(\S+))', re.MULTILINE)


class EngineError(RuntimeError):
    """The engine is missing or stopped with an error; the message holds what it said."""


class EngineStopped(EngineError):
    """The engine began and ended with an error, or was ended."""


def own_inputs() -> Path:
    """Folder of the project's input scripts, or of the copy an installed package carries."""
    folder = PROJECT / "inputs"
    return folder if folder.is_dir() else Path(__file__).resolve().parents[1] / "inputs"


def inputs_folder() -> Path:
    """Folder of the input scripts: $PLASTIGRAN_INPUTS, or `own_inputs()`."""
    folder = Path(os.environ.get("PLASTIGRAN_INPUTS", own_inputs()))
    if not (folder / "collision").is_dir():
        raise EngineError(f"no input scripts in {folder}; set PLASTIGRAN_INPUTS to their folder")
    return folder


def index_variables(deck: str | Path) -> dict[str, str]:
    """What a deck's `variable NAME index VALUE` lines say, as text.

    Args:
        deck: Path of the input script.
    """
    values: dict[str, str] = {}
    for name, quoted, plain in _INDEX_VARIABLE.findall(Path(deck).read_text()):
        values.setdefault(name, quoted or plain)  # the engine keeps the first too
    return values


def engine_path() -> Path:
    """The launcher: $PLASTIGRAN_ENGINE, the project's build, or the first on PATH."""
    if named := os.environ.get("PLASTIGRAN_ENGINE"):
        candidates = [Path(named)]
    else:
        candidates = [PROJECT / "build" / "liggghts-plastigran"]
        if found := shutil.which("liggghts-plastigran"):
            candidates.append(Path(found))
    for path in candidates:
        if os.access(path, os.X_OK):
            return path
    raise EngineError(
        f"no engine at {candidates[0]}; build it (./run setup) or set PLASTIGRAN_ENGINE"
    )


def command(
    deck: str | Path, variables: Mapping[str, object], folder: Path, ranks: int = 1
) -> list[str]:
    """Command line that runs a deck with its results in `folder`.

    Never add `-screen none`: the engine's mesh reader then writes to a null file and crashes.
    """
    line = [str(engine_path()), "-in", str(deck), "-log", str(folder / "log.liggghts")]
    settings = {"inputs": inputs_folder(), "output": folder, **variables}
    for name, value in settings.items():
        line += ["-var", name, repr(float(value)) if isinstance(value, float) else str(value)]
    if ranks > 1:
        line = ["mpirun", "--oversubscribe", "-np", str(ranks), *line]
    return line


def environment() -> dict[str, str]:
    """The environment for mpirun: Open MPI refuses root without being told twice."""
    extra = {}
    if os.geteuid() == 0:
        extra = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    return {**os.environ, **extra}


def surroundings(folder: Path, screen: TextIO) -> dict[str, object]:
    """Keywords of `subprocess` for any engine: where it runs and where its screen goes."""
    return {
        "cwd": folder,
        "env": environment(),
        "stdin": subprocess.DEVNULL,
        "stdout": screen,
        "stderr": subprocess.STDOUT,
    }


def run_deck(
    deck: str | Path,
    variables: Mapping[str, object],
    folder: str | Path,
    ranks: int = 1,
    timeout: float = 600,
) -> str:
    """Run a deck to its end.

    Args:
        deck: Path of the input script, absolute or relative to `inputs_folder()`.
        variables: Values for the deck's `variable ... index` settings.
        folder: Where results go; made when missing.
        ranks: MPI ranks.
        timeout: Seconds before the run is stopped.

    Returns:
        The log.

    Raises:
        EngineError: The engine stopped with an error (its message is quoted) or took too long.
    """
    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    deck = inputs_folder() / deck
    if not deck.is_file():
        raise EngineError(f"no deck {deck}")
    # The screen goes to a file: on a pipe, a helper process of MPI that outlives an interrupted
    # engine would keep us waiting. A session of its own lets an engine finish after Ctrl-C; mpirun
    # stays in ours and stops its ranks.
    screen = folder / "screen.txt"
    try:
        with open(screen, "w") as output:
            done = subprocess.run(
                command(deck, variables, folder, ranks),
                **surroundings(folder, output),
                timeout=timeout,
                start_new_session=ranks == 1,
            )
    except subprocess.TimeoutExpired:
        raise EngineError(f"{deck.name}: stopped after {timeout:g} s") from None
    return check_finished(deck.name, done.returncode, folder)


def check_finished(name: str, returncode: int, folder: Path) -> str:
    """The log of a run that has ended.

    Args:
        name: The deck's.
        returncode: The engine's or mpirun's.
        folder: Where it wrote `log.liggghts` and `screen.txt`.

    Raises:
        EngineStopped: It ended with an error, which is quoted.
    """
    log = folder / "log.liggghts"
    text = log.read_text(errors="replace") if log.exists() else ""
    said = text + (folder / "screen.txt").read_text(errors="replace")
    if returncode != 0 or "ERROR" in said:
        errors = [line for line in said.splitlines() if "ERROR" in line]
        killer = -returncode if returncode < 0 else returncode - 128  # as mpirun reports a rank's
        if errors:
            reason = errors[0]
        elif killer in set(signal.Signals):
            reason = f"the engine was ended by {signal.Signals(killer).name}"
        else:
            reason = (said.strip().splitlines() or ["no output"])[-1]
        raise EngineStopped(f"{name}: {reason} (log: {log})")
    return text
