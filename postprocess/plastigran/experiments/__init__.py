# SPDX-License-Identifier: GPL-2.0-or-later
"""Experiments: simulations of single impacts in LIGGGHTS, compared with theory.

Each experiment is a module or package in this folder, or in a folder that the environment variable
PLASTIGRAN_EXPERIMENTS lists.
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
    """Return the class of every experiment that has a `plastigran` command, by the command name."""
    experiments = {}
    for module in iter_modules(__path__):
        for value in vars(import_module(f"{__name__}.{module.name}")).values():
            if isinstance(value, type) and vars(value).get("command"):
                experiments[value.command] = value
    return dict(sorted(experiments.items()))
