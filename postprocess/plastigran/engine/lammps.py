# SPDX-License-Identifier: GPL-2.0-or-later
"""Find LAMMPS and its plugin, and run an input script."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from pathlib import Path

from plastigran.engine.log import LOGS
from plastigran.engine.process import PROJECT, EngineError, Host, own_inputs, run_deck

PLUGIN = "plastigranplugin.so"
LOG = LOGS["lammps"]


def lammps_path() -> Path:
    """Return the path of LAMMPS: $PLASTIGRAN_LAMMPS, or `lmp` in the project or environment.

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
        f"LAMMPS is not at {places[0]}. Run `./run setup`, or set PLASTIGRAN_LAMMPS to the path of "
        "`lmp`"
    )


def plugin_path() -> Path:
    """Return the path of the LAMMPS plugin: $PLASTIGRAN_LAMMPS_PLUGIN, or the file in `build`.

    Raises:
        EngineError: The plugin is missing.
    """
    named = os.environ.get("PLASTIGRAN_LAMMPS_PLUGIN")
    path = Path(named) if named else PROJECT / "build" / "lammps" / PLUGIN
    if path.is_file():
        return path.resolve()
    raise EngineError(
        f"the LAMMPS plugin is not at {path}. Run `./run setup` to build it, or set "
        f"PLASTIGRAN_LAMMPS_PLUGIN to the path of {PLUGIN}"
    )


def lammps_environment() -> dict[str, str]:
    """Return environment variables with which LAMMPS finds the plugin and the material files."""
    defaults = {"OMP_NUM_THREADS": "1", "PLASTIGRAN_MATERIALS": str(own_inputs() / "materials")}
    return defaults | os.environ | {"LAMMPS_PLUGIN_PATH": str(plugin_path().parent)}


def lammps_start(ranks: int = 1) -> list[str]:
    """Return the first words of a command line for LAMMPS, with `mpiexec` for several ranks.

    `mpiexec` is taken from the folder of LAMMPS if it exists there, otherwise from PATH.
    """
    program = lammps_path()
    beside = program.parent / "mpiexec"
    launcher = [str(beside) if beside.is_file() else "mpiexec", "-n", str(ranks)]
    return [*(launcher if ranks > 1 else []), str(program)]


LAMMPS = Host(
    "LAMMPS",
    LOG,
    lammps_start,
    lammps_environment,
    additions=("LAMMPS_PLUGIN_PATH", "PLASTIGRAN_MATERIALS"),
)


def run_lammps(
    deck: Path, variables: Mapping[str, object], folder: Path, ranks: int = 1, timeout: float = 600
) -> str:
    """Run an input script in LAMMPS; arguments and errors as for `run_deck`."""
    return run_deck(deck, variables, folder, ranks, timeout, host=LAMMPS)
