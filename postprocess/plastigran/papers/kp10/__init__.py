# SPDX-License-Identifier: GPL-2.0-or-later
"""Impacts of a rigid cylinder on glass (Katta & Polycarpou 2010): finite elements and two laws."""

from __future__ import annotations

from plastigran.papers.base import declare
from plastigran.papers.kp10 import figures, tables
from plastigran.papers.kp10.computations import compute

PAPER = declare(
    name="kp10",
    title="A rigid cylinder on an elastic-plastic body",
    citation="R. R. Katta & A. A. Polycarpou, J. Tribol. 132 (2010) 041402",
    compute=compute,
    tables=(tables.comparison, tables.head_on, tables.oblique, tables.bodies),
    data=(tables.normal,),
    figures=(figures.restitution_figure, figures.depth_figure, figures.mises_figure),
)
