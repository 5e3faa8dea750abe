# SPDX-License-Identifier: GPL-2.0-or-later
"""Rules for sentences: their length, patterns that a reader stumbles over, and terms."""

from __future__ import annotations

import re
from collections.abc import Iterator

LONGEST = 30  # words
#: Patterns that hide the subject or the verb, by what to write instead.
PATTERNS = {
    "start with the subject": (
        r"^(Refused|Said|Shown|Told|Left|Kept|Given|Drawn|Printed) (is|are)\b",
        r"^What [a-z]+ .*\b(is|are)\b",
    ),
    "name the thing instead of 'that of'": (
        r"\b(that|those) of\b.*\b(that|those) of\b",
        r"\bnot (that|those) of\b",
    ),
    "programs do not know, ask, say or remember": (
        r"\b(knows|remembers|forgets)\b",
        r"\b(is|are|was|were) told\b",
        r"^(It|The \w+) (says|asks) ",
    ),
    "name the noun": (r"^of (the|a|an|each|its) ",),
    "use because": (r", for [a-z]+ (is|are|has|have|can|do|does)\b",),
    "use is not a": (r"(?<!here )\b(is|are) no (?!more |less |longer |closer |better )[a-z]+",),
}
#: Terms to avoid, by the term to use.
TERMS = {
    "again": r"\banew\b",
    "continues": r"\bgo(es)? on\b|\bgone on\b",
    "is not ... any more, or rewrite": r"\bno longer\b",
    "compared with": r"\bheld (against|to)\b|\bheld metals\b",
    "path-explicit law": r"\btotal laws?\b",
    "first loading": r"\bvirgin\b",
    "unloading": r"\bway back\b",
    "released": r"\blet go\b|\bgiven back\b|\bgives? back\b",
    "residual indentation": r"\bdent(s|ed)?\b",
    "large or small a/R": r"\b(wide|narrow) contacts?\b",
    "balance error": r"\bdrift of the (energy )?ledger\b",
    "bitwise identical": r"\bto every digit\b|\bin every digit\b",
    "to round-off": r"\bto rounding\b|\bbut for rounding\b",
    "measured on a busy machine": r"\bbeside other work\b",
    "run-time check": r"\bwatch(es)?\b",
    "renumbered": r"\bnumbered anew\b",
    "rebuilds the neighbor lists": r"\blists neighbou?rs\b",
    "contact history": r"\bmemory of (the |a )?contacts?\b",
    "sustained contact": r"\bheld contacts?\b",
    "fundamental mode": r"\bgravest\b",
    "other codes": r"\bpeers\b",
    "LIGGGHTS or host": r"\b[Tt]he engine('s)?\b",
    "neighbor": r"\bneighbour",
}


def faults(sentence: str) -> Iterator[str]:
    """Yield what is wrong with a sentence, with the remedy."""
    count = len(sentence.split())
    if count > LONGEST:
        yield f"{count} words, at most {LONGEST}"
    for remedy, patterns in PATTERNS.items():
        for pattern in patterns:
            if found := re.search(pattern, sentence):
                yield f"'{found[0]}': {remedy}"
    for term, pattern in TERMS.items():
        if found := re.search(pattern, sentence):
            yield f"'{found[0]}': use '{term}'"
