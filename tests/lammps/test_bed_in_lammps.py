# SPDX-License-Identifier: GPL-2.0-or-later
"""A bed of grains of two materials in LAMMPS, on several ranks and after restarts."""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import pytest
from lammps_scenes import thermo
from numpy.testing import assert_allclose

from plastigran.engine.lammps import run_lammps

BED = Path(__file__).parent / "bed.in"
#: Kinetic energy, plastic work and number of contacts.
COMPARED = ["KinEng", "c_energy[4]", "c_energy[13]"]


def bed(folder: Path, ranks: int = 1, **variables: object) -> pd.DataFrame:
    return thermo(run_lammps(BED, variables, folder, ranks))


@pytest.fixture(scope="module")
def reference(tmp_path_factory) -> tuple[pd.Series, Path]:
    """The last output of the bed on one rank, and the folder with its restart files."""
    folder = tmp_path_factory.mktemp("bed")
    last = bed(folder).iloc[-1]
    assert last["c_energy[13]"] > 300  # contacts, most of them beyond yield
    assert last["c_energy[4]"] > 0.2 * last["KinEng"]
    return last, folder


@pytest.mark.parametrize(
    ("ranks", "variables"),
    [
        (2, {}),
        (1, {"newton": "off"}),
        (2, {"newton": "off"}),
        (1, {"sort": 20}),
        (2, {"balance": "yes"}),
    ],
)
def test_ranks_and_order_of_grains_do_not_matter(ranks, variables, reference, tmp_path):
    """The relative differences after 1000 steps are below 1e-8.

    Collisions have amplified round-off to 1e-11.
    """
    last, _ = reference
    assert_allclose(bed(tmp_path, ranks, **variables).iloc[-1][COMPARED], last[COMPARED], rtol=1e-8)


@pytest.mark.parametrize("law", ["partial_slip", "incremental"])
def test_tangential_laws_do_not_depend_on_the_side_of_a_pair(law, tmp_path):
    """With `newton off`, LAMMPS stores the history of some pairs with the other particle, and
    changes its signs. The energy of the tangential springs depends on these signs. The relative
    tolerance is 1e-8, because collisions amplify round-off.
    """
    friction = {"models": f"tangential {law} 0.5", "floor": f"tangential {law} 0.5"}
    on, off = (
        bed(tmp_path / newton, **friction, newton=newton).iloc[-1] for newton in ("on", "off")
    )
    assert on["c_energy[10]"] > 0  # energy of tangential springs
    assert_allclose(off[[*COMPARED, "c_energy[10]"]], on[[*COMPARED, "c_energy[10]"]], rtol=1e-8)


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_restart_continues_the_contacts(ranks, reference):
    """A run that continues from step 900, with 251 contacts, ends like the run without restart.

    The restart file contains the laws and the contact histories.
    """
    last, folder = reference
    continued = bed(folder, ranks, **{"from": 900})
    assert_allclose(continued.iloc[-1][COMPARED], last[COMPARED], rtol=1e-8)
