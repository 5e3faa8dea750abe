# SPDX-License-Identifier: GPL-2.0-or-later
"""Names of the laws that are contact models in LIGGGHTS."""

from __future__ import annotations

from collections.abc import Iterable

from plastigran import laws
from plastigran.engine.process import PROJECT
from plastigran.materials import has_constants

LAWS_FILE = PROJECT / "contact_models/liggghts/plugin/laws.txt"
#: Names of the laws, in the order of the plugin.
MODELS = [
    line.split()[0]
    for line in LAWS_FILE.read_text().splitlines()
    if line and not line.startswith("#")
]


def one_per_history(names: Iterable[str]) -> list[str]:
    """Return the first of the given laws for each form of the contact history."""
    first = {}
    for name in names:
        law = laws.LAWS[name]
        first.setdefault((law.state_names, law.rate_dependent), name)
    return list(first.values())


#: Laws that tests build into LIGGGHTS' sources: one for each form of the contact history, and a law
#: for cylinders. The decks of these tests define no constants of contacts.
IN_TREE_LAWS = [*one_per_history(filter(has_constants, MODELS)), "lim_stronge"]
