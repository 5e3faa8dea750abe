# SPDX-License-Identifier: GPL-2.0-or-later
"""Katta & Polycarpou 2010: a rigid cylinder on glass, by finite elements and two cylinder laws."""

from __future__ import annotations

from plastigran.papers.base import Paper
from plastigran.report.base import Findings


def compute(progress: bool, coarse: bool) -> Findings:
    """Compute head-on and oblique impacts."""
    # Import late, because these modules are slow to load.
    from plastigran.papers.kp10.computations import compute_finite_elements_and_runs
    from plastigran.papers.kp10.figures import figures
    from plastigran.papers.kp10.tables import tables

    found = compute_finite_elements_and_runs(progress, coarse)
    return Findings(tables=tables(found), figures=figures(found))


PAPER = Paper(
    name="kp10",
    title="A rigid cylinder on an elastic-plastic body",
    citation="R. R. Katta & A. A. Polycarpou, J. Tribol. 132 (2010) 041402",
    tables=("comparison", "head_on", "oblique", "bodies"),
    data=("normal",),
    figures=("restitution", "depth", "mises"),
    compute=compute,
)
