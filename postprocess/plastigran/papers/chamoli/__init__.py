# SPDX-License-Identifier: GPL-2.0-or-later
"""The vibrating elastic sphere of Chamoli's thesis: fast impacts, and the viscoelastic sphere."""

from __future__ import annotations

from plastigran.papers.base import Paper
from plastigran.report.base import Findings


def compute(progress: bool, coarse: bool) -> Findings:
    """Compute every table and figure."""
    # Import late, because these modules are slow to load.
    from plastigran.papers.chamoli.computations import compute_impacts
    from plastigran.papers.chamoli.figures import figures
    from plastigran.papers.chamoli.tables import tables

    computed = compute_impacts(progress, coarse)
    return Findings(tables=tables(computed), figures=figures(computed))


PAPER = Paper(
    name="chamoli",
    title="The vibrating elastic sphere",
    citation="Chamoli, master thesis: fast impacts of an elastic sphere by finite elements",
    tables=("deviations", "energies", "restitution", "oscillations", "modes", "viscoelastic"),
    data=("impacts",),
    figures=("impact", "energies", "restitution", "spectrum"),
    compute=compute,
)
