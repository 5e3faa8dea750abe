# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of a benchmark case with several random beds, and the contact laws of the benchmark."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import pandas as pd

from plastigran.bulk.checks import ENERGIES
from plastigran.bulk.continued import finish_bulk
from plastigran.bulk.outcome import BulkRun
from plastigran.calibration.softening import soften
from plastigran.materials import read_material

#: Settings of the contacts by label. LIGGGHTS' own `hertz` prescribes the restitution of the
#: benchmark; the law `thornton` has a yield strength instead.
CONTACTS = {
    "hertz": {"law": "hertz", "ledger": "off"},
    "thornton": {"law": "thornton"},
}


def softened_grains(factor: float) -> dict[str, float]:
    """Return deck settings for softened grains of material M1.

    The yield strength is scaled so that the restitution of laws with yield stays the same.

    Args:
        factor: Softened / original Young's modulus [-].

    Returns:
        Young's modulus and yield strength [Pa], by name of the setting.
    """
    grains = soften(read_material("grain_m1"), factor)
    return {"youngs_modulus": grains.youngs_modulus, "yield_strength": grains.yield_strength}


def run_beds(
    deck: str,
    settings: Mapping[str, object],
    label: str,
    beds: int,
    path: Path,
    ranks: int,
    progress: bool,
) -> list[BulkRun]:
    """Run a deck with several random beds, or continue its runs.

    Args:
        deck: Name of the deck.
        settings: New values of settings of the deck, except the settings in `CONTACTS`.
        label: Label of `CONTACTS`, or name of a law.
        beds: Number of random beds. Their seeds are 1, 2, ...
        path: Path to which label and seed are appended, for the folder of each run.
        ranks: Number of MPI ranks.
        progress: Whether to show a progress bar.
    """
    settings = {**settings, **CONTACTS.get(label, {"law": label})}
    return [
        finish_bulk(
            deck,
            settings | {"seed": seed},
            path.with_name(f"{path.name}_{label}_{seed}"),
            ranks,
            progress,
        ).raise_if_failed()
        for seed in range(1, beds + 1)
    ]


def energy_table(cases: Iterable[tuple[dict[str, object], Sequence[BulkRun]]]) -> pd.DataFrame:
    """Return the energy at the end of runs [J], and each of its terms in per cent.

    Args:
        cases: For each case, the columns that identify it, and its runs, one per bed. The table
            gives means over the runs. Cases without energy balance have no row.
    """
    rows = []
    for names, runs in cases:
        if runs[0].deck.ledger == "on":
            last = pd.DataFrame([run.series.iloc[-1] for run in runs])[ENERGIES].mean()
            shares = {f"{term}, %": 100 * last[term] / last.sum() for term in ENERGIES}
            rows.append(names | {"energy (J)": last.sum(), **shares})
    return pd.DataFrame(rows)
