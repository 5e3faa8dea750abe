# SPDX-License-Identifier: GPL-2.0-or-later
"""Impacts of an elastic, vibrating sphere (Chamoli's thesis), and of a viscoelastic sphere."""

from __future__ import annotations

from plastigran.papers.base import declare
from plastigran.papers.chamoli import figures, tables
from plastigran.papers.chamoli.computations import compute

PAPER = declare(
    name="chamoli",
    title="The vibrating elastic sphere",
    citation="Chamoli, master thesis: fast impacts of an elastic sphere by finite elements",
    compute=compute,
    tables=(
        tables.deviations,
        tables.energies,
        tables.restitution,
        tables.oscillations,
        tables.modes,
        tables.viscoelastic,
    ),
    data=(tables.impacts,),
    figures=(
        figures.impact_figure,
        figures.energies_figure,
        figures.restitution_figure,
        figures.spectrum_figure,
    ),
)
