# SPDX-License-Identifier: GPL-2.0-or-later
"""Find LAMMPS and its plugin, and run an input script."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from shlex import join

from plastigran.engine.process import PROJECT, EngineError, own_inputs

PLUGIN = "plastigranplugin.so"
LOG = "log.lammps"
#: Environment variables of the plugin.
ADDITIONS = ("LAMMPS_PLUGIN_PATH", "PLASTIGRAN_MATERIALS")


def lammps_path() -> Path:
    """Return the path of LAMMPS: $PLASTIGRAN_LAMMPS, or `lmp` of the project or environment.

    Raises:
        EngineError: LAMMPS is missing.
    """
    named = os.environ.get("PLASTIGRAN_LAMMPS")
    usual = [PROJECT / ".venv" / "lammps" / "bin" / "lmp", Path(sys.prefix) / "bin" / "lmp"]
    places = [Path(named)] if named else usual
    for place in places:
        if os.access(place, os.X_OK):
            return place
    raise EngineError(
        f"LAMMPS is not at {places[0]}. Run `./run setup`, or set PLASTIGRAN_LAMMPS to the program"
    )


def plugin_path() -> Path:
    """Return the path of the plugin: $PLASTIGRAN_LAMMPS_PLUGIN, or the file in `build`.

    Raises:
        EngineError: The plugin is missing.
    """
    named = os.environ.get("PLASTIGRAN_LAMMPS_PLUGIN")
    path = Path(named) if named else PROJECT / "build" / "lammps" / PLUGIN
    if path.is_file():
        return path.resolve()
    raise EngineError(
        f"the LAMMPS plugin is not at {path}. Run `./run setup` to build it, or set "
        f"PLASTIGRAN_LAMMPS_PLUGIN to {PLUGIN}"
    )


def lammps_environment() -> dict[str, str]:
    """Return environment variables with which LAMMPS finds the plugin and the material files."""
    defaults = {"OMP_NUM_THREADS": "1", "PLASTIGRAN_MATERIALS": str(own_inputs() / "materials")}
    return defaults | os.environ | {"LAMMPS_PLUGIN_PATH": str(plugin_path().parent)}


def lammps_command(words: Sequence[str], ranks: int = 1) -> list[str]:
    """Return the command line of LAMMPS with `words`, with the mpirun in the folder of LAMMPS."""
    program = lammps_path()
    launcher = [str(program.parent / "mpiexec"), "-n", str(ranks)] if ranks > 1 else []
    return [*launcher, str(program), *words]


def deck_words(deck: Path, variables: Mapping[str, object]) -> list[str]:
    """Return the words for an input script and its variables; omit variables with value None."""
    words = ["-in", str(deck.resolve()), "-log", LOG]
    for name, value in variables.items():
        if value is not None:
            words += ["-var", name, str(value)]
    return words


def typed_lammps_command(deck: Path, variables: Mapping[str, object], folder: Path) -> str:
    """Return shell commands equivalent to `run_lammps` on one rank; create nothing."""
    settings = {name: lammps_environment()[name] for name in ADDITIONS}
    steps = [["mkdir", "-p", str(folder)], ["cd", str(folder)]]
    line = [f"{name}={value}" for name, value in settings.items()]
    line += lammps_command(deck_words(deck, variables))
    return f"{' && '.join(map(join, steps))}\n{join(['env', *line])}"


def run_lammps(
    deck: Path, variables: Mapping[str, object], folder: Path, ranks: int = 1, timeout: float = 600
) -> str:
    """Run an input script to its end in `folder`, which is created if missing.

    Args:
        deck: Path of the input script.
        variables: Values for the variables of the script.
        folder: Folder of the results, where LAMMPS runs.
        ranks: Number of MPI ranks.
        timeout: Seconds before the run is stopped.

    Returns:
        The log.

    Raises:
        EngineError: LAMMPS is missing, took too long, or ended with an error, which is quoted.
    """
    folder.mkdir(parents=True, exist_ok=True)
    words = [*deck_words(deck, variables), "-screen", "none"]
    line = ["setpriv", "--pdeathsig", "KILL", *lammps_command(words, ranks)]
    try:
        done = subprocess.run(
            line,
            cwd=folder,
            env=lammps_environment(),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=timeout,
        )
    except subprocess.TimeoutExpired:
        raise EngineError(f"{deck.name}: stopped after {timeout:g} s") from None
    log = folder / LOG
    text = log.read_text(errors="replace") if log.exists() else ""
    if done.returncode:
        output = (text + done.stdout + done.stderr).splitlines()
        errors = [line for line in output if line.startswith("ERROR")]
        raise EngineError(f"{deck.name}: {(errors or output or ['no output'])[0]}")
    return text
