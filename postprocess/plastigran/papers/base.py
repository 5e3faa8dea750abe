# SPDX-License-Identifier: GPL-2.0-or-later
"""What a paper's module gives: a report with the paper it is held against; and its impacts.

    PAPER = Paper(
        name="zv02",
        title="An elastic-plastic sphere on a rigid plane",
        citation="X. Zhang & L. Vu-Quoc, Int. J. Impact Eng. 27 (2002) 317",
        tables=("impacts",),
        figures=("restitution",),
        compute=compute,
    )

It is found as `PAPER` of a module or package of `plastigran.papers`.
"""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import attrs

from plastigran.contact import RangeWarning
from plastigran.experiments.collide import collide
from plastigran.report.base import Report

if TYPE_CHECKING:
    from plastigran.experiments.runs import Runs


@attrs.frozen(kw_only=True)
class Paper(Report):
    """A paper that can be reproduced; its page is docs/papers/NAME.md.

    The tables have one row a quantity: `quantity` and `unit`, or what else tells it; then columns
    of numbers, as far as there are some: `paper`, `finite elements`, a law's name, `LIGGGHTS`.

    Attributes:
        citation: Authors, journal, volume, year, page.
    """

    citation: str
    pictures: str = attrs.Factory(lambda self: f"../figures/papers/{self.name}", takes_self=True)


def thrown(*arguments: Any, **fields: Any) -> Runs:
    """Impacts in the engine, as `collide` has them, and without a word of those beyond the range of
    their law: a paper's speeds are what they are, and its page says how far off a law is."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RangeWarning)
        return collide(*arguments, **fields)
