# SPDX-License-Identifier: GPL-2.0-or-later
"""Versions of what a run is made with, for its record."""

from __future__ import annotations

import hashlib
from importlib.metadata import version

from plastigran.engine.process import engine_path


def versions() -> dict[str, str]:
    """Of this package, and file and SHA-256 of the plugin beside the engine.

    Raises:
        EngineError: There is no engine.
    """
    plugin = engine_path().parent / "libplastigran.so"
    if not plugin.exists():
        said = f"none beside {engine_path()}"
    else:
        said = f"{plugin.name} sha256 {hashlib.sha256(plugin.read_bytes()).hexdigest()}"
    return {"plastigran": version("plastigran"), "plugin": said}
