# SPDX-License-Identifier: GPL-2.0-or-later
"""Energy terms of a run with adhesion: the deck of docs/adhesion.md with the energy balance."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from plastigran.bulk.run import run_bulk
from plastigran.report.page.bulk_charts import ledger_chart

PROJECT = Path(__file__).parents[2]


def test_shares_of_adhesion_complete_the_energy_input(tmp_path):
    page = (PROJECT / "docs" / "adhesion.md").read_text()
    text = re.search(r"^```\n(units +si\n.*?)```", page, re.DOTALL | re.MULTILINE)[1]
    text = re.sub(r"^(pair_style .*|fix +floor .*)$", r"\1 energy_ledger on", text, flags=re.M)
    text = re.sub(r"^dump .*\n", "", text, flags=re.M)
    text = text.replace("timestep        1e-11", "timestep        2e-11")
    written = (
        "include energy_ledger.in\nthermo 300\n"
        "thermo_style custom step atoms ${ledger_columns} v_surfaces v_adhesion\n"
        "thermo_modify norm no lost error format float %.12g\nrun 90000"
    )
    deck = tmp_path / "deck.in"
    deck.write_text(re.sub(r"run +200000", lambda _: written, text))
    shutil.copy(PROJECT / "inputs" / "energy_ledger.in", tmp_path)
    run = run_bulk(deck, {}, tmp_path / "run", show=False)
    assert run.passed and len(run.checks) == 2

    # One grain sticks, so its contact keeps a negative surface energy.
    series, mass = run.series, 4 / 3 * 3.141592653589793 * 2.5e-6**3 * 1350
    kinetic = 0.5 * mass * (0.4**2 + 0.8**2 + 1.6**2)
    assert series["surfaces"].iloc[-1] < -0.01 * kinetic
    assert series["adhesion"].iloc[-1] > 0.01 * kinetic
    chart = ledger_chart(series, run.checks)
    shares = {curve.name: curve.y for curve in chart.views[""][0].curves}
    names = {"kinetic energy", "elastic energy in contacts", "surface energy of contacts"}
    assert set(shares) == names | {"loss by adhesion"}
    # The balance error is below 0.2 % of the energy input.
    assert sum(shares.values()) == pytest.approx(1, abs=2e-3)
    assert min(shares["surface energy of contacts"]) < 0
    assert "the surface energy of contacts is negative" in chart.caption
    legend = run.figures["ledger"].axes[0].get_legend().get_texts()
    assert names | {"loss by adhesion"} == {entry.get_text() for entry in legend}
