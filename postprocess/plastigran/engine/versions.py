# SPDX-License-Identifier: GPL-2.0-or-later
"""Versions of the software of a run, for its record."""

from __future__ import annotations

import hashlib
from importlib.metadata import version

from plastigran.engine.process import engine_path


def versions() -> dict[str, str]:
    """Return the version of this package, and file and SHA-256 of the plugin.

    Raises:
        EngineError: LIGGGHTS is missing.
    """
    plugin = engine_path().parent / "libplastigran.so"
    if not plugin.exists():
        identity = f"none beside {engine_path()}"
    else:
        identity = f"{plugin.name} sha256 {hashlib.sha256(plugin.read_bytes()).hexdigest()}"
    return {"plastigran": version("plastigran"), "plugin": identity}
