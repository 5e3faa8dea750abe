# SPDX-License-Identifier: GPL-2.0-or-later
"""A bed that settled with LIGGGHTS' `hertz` continues with a law, and the reverse. The decks of
docs/settle_then_yield.md run on planes and meshes, on one rank and on two.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from plastigran.engine.log import read_thermo
from plastigran.engine.process import PROJECT, run_deck

PAGE = (PROJECT / "docs" / "settle_then_yield.md").read_text()
SETTLE, CONTINUE = re.findall(r"```\n(.*?)```", PAGE, re.DOTALL)[:2]
TRIANGLES = """solid floor
 facet normal 0 0 1
  outer loop
   vertex 0.0001 0.0001 0
   vertex 0.0407 0.0001 0
   vertex 0.0407 0.0407 0
  endloop
 endfacet
 facet normal 0 0 1
  outer loop
   vertex 0.0001 0.0001 0
   vertex 0.0407 0.0407 0
   vertex 0.0001 0.0407 0
  endloop
 endfacet
endsolid floor
"""
MESH = "fix mesh all mesh/surface file floor.stl type 1\nfix floor"
INCLUDE = "include inputs/energy_ledger.in   # from the project folder\n"
LEDGER = f"include {PROJECT}/inputs/energy_ledger.in\nthermo 100\n"


def run(folder: Path, deck: str, name: str, ranks: int, wall: str) -> str:
    """Run a deck of the page in a folder and return its log."""
    if wall == "mesh":
        deck = re.sub("^fix floor", MESH, deck, flags=re.MULTILINE).replace(
            "primitive type 1 zplane 0.0", "mesh n_meshes 1 meshes mesh"
        )
        (folder / "floor.stl").write_text(TRIANGLES)
    (folder / f"{name}.in").write_text("variable output index .\nvariable inputs index .\n" + deck)
    run_deck(folder / f"{name}.in", {}, folder / name, ranks=ranks, working_folder=folder)
    return (folder / name / "log.liggghts").read_text(errors="replace")


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("wall", ["plane", "mesh"])
def test_a_bed_settled_with_hertz_continues_with_a_law(wall, ranks, tmp_path):
    """A bed that settled with `hertz` continues with a law, and the energy balance closes.

    The law loads existing contacts to their overlap, so they yield at the start. The balance error
    is below 1e-5 of the initial energy, the error of the integration in 2000 steps. The plastic
    work at the start alone is 1e-2 of this energy.
    """
    run(tmp_path, SETTLE, "settle", ranks, wall)
    deck = CONTINUE.replace(INCLUDE, LEDGER)
    log = run(tmp_path, deck, "continue", ranks, wall)
    for owner in ("pair_style", "fix floor"):
        message = f"{owner}: the restart file has contacts of one of LIGGGHTS' own models, not of"
        assert message in log
    assert "WARNING" not in log
    table = read_thermo(tmp_path / "continue" / "log.liggghts")
    assert table["atoms"].iloc[-1] == 48
    energy = table[["kinetic", "gravity", "elastic", "plastic"]].iloc[0].sum()
    assert table["plastic"].iloc[0] > 0 and (np.diff(table["plastic"]) >= 0).all()
    assert table["drift"].abs().max() < 1e-5 * energy


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("wall", ["plane", "mesh"])
def test_a_bed_settled_with_a_law_continues_with_hertz(wall, ranks, tmp_path):
    strength = "fix m5 all property/global yieldStrength peratomtype 5.0e5\npair_style"
    settle = SETTLE.replace("model hertz", "model universal").replace("pair_style", strength)
    run(tmp_path, settle.replace("20000", "2000"), "settle", ranks, wall)
    deck = CONTINUE.replace("model universal", "model hertz").replace(" energy_ledger on", "")
    restitution = "fix m4 all property/global coefficientRestitution peratomtypepair 1 0.4\n"
    deck = deck.replace("fix m1", f"{restitution}fix m1").replace(INCLUDE, "")
    log = run(tmp_path, deck.replace("fix m5", "#"), "continue", ranks, wall)
    for owner in ("pair_style", "fix floor"):
        message = rf"{owner}: the restart file has contacts of `model universal.*`, which"
        assert re.search(f"WARNING: plastigran: {message}", log)
    table = read_thermo(tmp_path / "continue" / "log.liggghts")
    assert table["atoms"].iloc[-1] == 48
    # The bound is the energy of 48 grains of 1.3 g at 0.14 m/s.
    assert 0 < table["kinetic_energy"].iloc[-1] < 48 * 1.3e-3 * 0.1**2


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("wall", ["plane", "mesh"])
def test_the_models_may_change_within_a_deck(wall, ranks, tmp_path):
    """A deck may change its models between two runs, without a restart file.

    The test deletes the wall of the first deck and adds the lines of the second deck.
    """
    second = re.findall(r"^(?:fix m5|pair_style|pair_coeff|fix floor|timestep).*\n", CONTINUE, re.M)
    lines = "".join(second).replace("fix floor", LEDGER + "fix floor", 1)
    if wall == "mesh":
        lines = lines.replace("primitive type 1 zplane 0.0", "mesh n_meshes 1 meshes mesh")
        lines = lines.replace("fix floor", "fix  floor")  # the mesh already exists
    deck = SETTLE.replace("write_restart", "unfix floor\n" + lines + "run 2000\n#")
    run(tmp_path, deck, "both", ranks, wall)
    table = read_thermo(tmp_path / "both" / "log.liggghts")
    table = table[table["run"] == 1]
    energy = table[["kinetic", "gravity", "elastic", "plastic"]].iloc[0].sum()
    assert table["plastic"].iloc[0] > 0
    assert table["drift"].abs().max() < 1e-5 * energy
