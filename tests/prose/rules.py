# SPDX-License-Identifier: GPL-2.0-or-later
"""Rules for sentences: length, patterns at which a reader stumbles, and terms."""

from __future__ import annotations

import re
from collections.abc import Iterator

LONGEST = 30  # words, without short remarks in parentheses
_SHORT_ASIDE = re.compile(r" \((\S+ ){0,7}\S+\)")
_WHOLE = "the|a|an|each|its|all|every|one|this|these|which"
#: Patterns that hide the subject or the verb; the keys are the remedies.
PATTERNS = {
    "start with the subject": (
        r"^([A-Z][a-z]+ed|Said|Shown|Told|Left|Kept|Given|Drawn|Found|Held|Meant) (is|are)\b",
        r"^(Told|Asked|Given|Taken|Seen|Held) (that|of|as|with|by)\b",
    ),
    "name the thing instead of 'what'": (
        r"^What (?!.*\?$)",
        r"\b(of|from|with|by|as|in|on|is|are|than|for|beside|all|over) what\b",
    ),
    "name the thing instead of 'that of'": (
        r"\b(that|those) of\b.*\b(that|those) of\b",
        r"\bnot (that|those) of\b",
    ),
    "programs do not know, ask, say or remember": (
        r"(?<!you )(?<!We )\bknow\b",
        r"\b(knows|remembers?|forgets?|says|asks|tells|told|asked)\b",
    ),
    "name the thing instead of 'the first' or 'the other'": (
        r"^The (first|second|former|latter|others?|ones?) (is|are|has|have|can|does|says|shows)\b",
    ),
    "name the noun": (rf"^of ({_WHOLE})\b", rf"^Of ({_WHOLE})\b[^,]*$"),
    "use because": (
        r", for [a-z]+ (is|are|has|have|can|do|does)\b",
        r", for (it|they|there|this|these|no|nothing) ",
    ),
    "use is not a": (r"(?<!here )\b(is|are) no (?!more |less |longer |closer |better )[a-z]+",),
    "name the ratio or the comparison": (
        r"\b(taken|measured|run|ran|compared|costs?) .*\bbeside\b",
        r"\d over (stock )?(hertz|CODE)",
        r", over (that|those|what|a|its|theirs)\b",
    ),
}
#: Patterns of terms to avoid; the keys are the terms to use.
TERMS = {
    "again": r"\banew\b",
    "continues": r"\bgo(es)? on\b|\bgone on\b|\bwent on\b",
    "is not ... any more, or rewrite": r"\bno longer\b",
    "compared with": r"\bheld (against|to)\b|\bheld metals\b",
    "path-explicit law": r"\btotal laws?\b",
    "first loading": r"\bvirgin\b",
    "unloading": r"\bway back\b",
    "released": r"\blet go\b|\bgiven back\b|\bgives? back\b",
    "residual indentation": r"\bdent(s|ed)?\b",
    "large or small a/R": r"\b(wide|narrow) contacts?\b",
    "quasi-static compression": r"\bpressed\b",
    "dynamic impact": r"\bthrown\b",
    "energy term": r"\bledger entr(y|ies)\b",
    "balance error": r"\bdrift(s|ed)?\b",
    "bitwise identical": r"\b(to|in) (every|any|all) digits?\b",
    "to round-off": r"\b(to|but for) rounding\b",
    "measured on a busy machine": r"\bbeside other work\b",
    "target": r"\b(meets?|met|miss(es|ed)?|above|below|under|within) (the|a|its|their) bars?\b",
    "run-time check": r"\bwatch(es)?\b",
    "renumbered": r"\bnumbered anew\b",
    "rebuilds the neighbor lists": r"\blists neighbou?rs\b",
    "contact history": r"\bmemory of (the |a )?contacts?\b",
    "sustained contact": r"\bheld contacts?\b",
    "fundamental mode": r"\bgravest\b",
    "other codes": r"\bpeers?\b",
    "LIGGGHTS or host": r"\b[Tt]he engine('s)?\b",
    "neighbor": r"\bneighbour",
    "which body's modulus and radius enter the fit": r"\breading (pair|body)\b",
}


def faults(sentence: str) -> Iterator[str]:
    """Yield what is wrong with a sentence, with the remedy."""
    count = len(_SHORT_ASIDE.sub("", sentence).split())
    if count > LONGEST:
        yield f"{count} words, at most {LONGEST}"
    for remedy, patterns in PATTERNS.items():
        for pattern in patterns:
            if match := re.search(pattern, sentence):
                yield f"'{match[0]}': {remedy}"
    for term, pattern in TERMS.items():
        if match := re.search(pattern, sentence):
            yield f"'{match[0]}': use '{term}'"
