# SPDX-License-Identifier: GPL-2.0-or-later
"""Versions of this package, the host and its plugin, for the record of a run."""

from __future__ import annotations

import hashlib
from importlib.metadata import version
from pathlib import Path

from plastigran.engine.lammps import LAMMPS, lammps_path, plugin_path
from plastigran.engine.process import LIGGGHTS, engine_path

#: Hosts by name, in the order of the documentation.
HOSTS = {"liggghts": LIGGGHTS, "lammps": LAMMPS}


def versions(host: str = "liggghts") -> dict[str, str]:
    """Return the version of this package, the name of the host, and the plugin with its SHA-256.

    Raises:
        EngineError: The host is missing.
    """
    if host == "lammps":
        program, plugin = lammps_path(), plugin_path()
    else:
        program = engine_path()
        plugin = program.parent / "libplastigran.so"
    return {"plastigran": version("plastigran"), "host": host, "plugin": _identity(program, plugin)}


def _identity(program: Path, plugin: Path) -> str:
    if not plugin.exists():
        return f"none next to {program}"
    return f"{plugin.name} sha256 {hashlib.sha256(plugin.read_bytes()).hexdigest()}"
