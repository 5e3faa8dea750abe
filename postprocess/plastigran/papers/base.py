# SPDX-License-Identifier: GPL-2.0-or-later
"""A reproduced paper: a report with a citation.

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
    """Paper that can be reproduced; its page is docs/papers/NAME.md.

    A row of the tables is one quantity: columns `quantity` and `unit`, or other columns that
    identify
    it, and then columns of numbers such as `paper`, `finite elements`, the name of a law,
    `LIGGGHTS`.

    Attributes:
        citation: Authors, journal, volume, year, page.
    """

    citation: str
    pictures: str = attrs.Factory(lambda self: f"../figures/papers/{self.name}", takes_self=True)


def thrown(*arguments: Any, **fields: Any) -> Runs:
    """Run impacts in LIGGGHTS as `collide` does, without warnings of the range of a law.

    The speeds are those of the paper, and its page states the error of each law.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RangeWarning)
        return collide(*arguments, **fields)
