# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the style of figures.

No module of the package may load pyplot, because pyplot would select a backend for the user.
"""

from __future__ import annotations

import subprocess
import sys
from pkgutil import walk_packages

import matplotlib

import plastigran
from plastigran.plot.style import STYLE, save, styled, subplots


def test_no_module_loads_pyplot():
    modules = [
        module.name
        for module in walk_packages(plastigran.__path__, "plastigran.")
        if not module.name.endswith("__main__")
    ]
    script = f"import sys, {', '.join(modules)}\nsys.exit('matplotlib.pyplot' in sys.modules)"
    assert len(modules) > 40
    assert subprocess.run([sys.executable, "-c", script]).returncode == 0


def settings() -> list[object]:
    return [matplotlib.rcParams[name] for name in STYLE]


def test_style_keeps_the_settings_of_the_user(tmp_path):
    """Drawing a figure leaves the user's matplotlib settings and backend unchanged.

    Two equal figures give bitwise identical files.
    """
    before, backend = settings(), matplotlib.get_backend(auto_select=False)
    written = []
    for name in ("one", "two"):
        with styled():
            figure, axes = subplots(figsize=(2, 1))
            axes.plot([0, 1], label="a line")
            axes.legend()
        written.append(save(figure, tmp_path / name))
    assert settings() == before
    assert matplotlib.get_backend(auto_select=False) == backend
    assert [path.read_bytes() for path in written[0]] == [path.read_bytes() for path in written[1]]
