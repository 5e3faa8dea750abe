# SPDX-License-Identifier: GPL-2.0-or-later
"""What a paper's module gives: a report with the paper it is held against.

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

import attrs

from plastigran.report.base import Report


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
