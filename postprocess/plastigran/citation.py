# SPDX-License-Identifier: GPL-2.0-or-later
"""BibTeX citations of this software and of the publications that introduced its contact laws."""

from __future__ import annotations

import re
from collections.abc import Iterable
from importlib.resources import files

ENTRY = re.compile(r"^@(?!comment)(\w+)\{(\w+),\n(.*?)^\}\n", re.MULTILINE | re.DOTALL)
FIELD = re.compile(r"^  (\w+) = \{(.*)\},$", re.MULTILINE)
KEYWORDS = re.compile(r"^  keywords = .*\n", re.MULTILINE)
SOFTWARE = "plastigran"


def entries() -> dict[str, str]:
    """Return the BibTeX entries in `plastigran/data/sources.bib`, by citation key."""
    text = (files("plastigran") / "data" / "sources.bib").read_text(encoding="utf-8")
    return {match[2]: match[0] for match in ENTRY.finditer(text)}


def fields(entry: str) -> dict[str, str]:
    """Return the fields of a BibTeX entry, such as `author`, `year` and `keywords`."""
    return dict(FIELD.findall(entry))


def subjects() -> dict[str, list[str]]:
    """Return the citation keys for each law, and for `rate_factor`, the strain-rate dependence."""
    keys: dict[str, list[str]] = {}
    for key, entry in entries().items():
        for subject in fields(entry)["keywords"].split(", "):
            keys.setdefault(subject, []).append(key)
    return dict(sorted(keys.items()))


def cite(names: Iterable[str] | str = ()) -> str:
    """Return BibTeX of the software and of the publications of some contact laws.

    Args:
        names: Names of laws, or `rate_factor` for the strain-rate dependence of the yield strength.
            Without names, only the software is cited.

    Returns:
        The BibTeX entry of the software and the entries of the publications, each once. Comment
        lines before the entries name the laws that have no other publication than this software.

    Raises:
        ValueError: A name is unknown; the message lists the available names.
    """
    names = [names] if isinstance(names, str) else list(names)
    sources, bibtex = subjects(), entries()
    if unknown := [name for name in names if name not in sources]:
        raise ValueError(f"no citation for {unknown[0]!r}. Available names: {', '.join(sources)}")
    keys = dict.fromkeys([SOFTWARE, *(key for name in names for key in sources[name])])
    notes = [
        f"% {name} is a law of this software; cite the entry of {SOFTWARE}.\n"
        for name in names
        if sources[name] == [SOFTWARE]
    ]
    return "\n".join([*notes, *(KEYWORDS.sub("", bibtex[key]) for key in keys)])
