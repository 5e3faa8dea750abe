# SPDX-License-Identifier: GPL-2.0-or-later
"""Experiments: single impacts that LIGGGHTS runs, compared with theory.

One module or package per experiment. `find_experiments` finds those here and in the folders of
$PLASTIGRAN_EXPERIMENTS.
"""

from __future__ import annotations

import os
from importlib import import_module
from pkgutil import iter_modules
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plastigran.experiments.base import Experiment

__path__ += filter(None, os.environ.get("PLASTIGRAN_EXPERIMENTS", "").split(os.pathsep))


def find_experiments() -> dict[str, type[Experiment]]:
    """Return every experiment that has a command, by the name of the command."""
    found = {}
    for place in iter_modules(__path__):
        for value in vars(import_module(f"{__name__}.{place.name}")).values():
            if isinstance(value, type) and vars(value).get("command"):
                found[value.command] = value
    return dict(sorted(found.items()))
