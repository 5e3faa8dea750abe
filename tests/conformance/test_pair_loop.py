# SPDX-License-Identifier: GPL-2.0-or-later
"""The plugin's loop over contacts and LIGGGHTS' own loop give bitwise identical results, with any
models in addition to a law. LIGGGHTS' loop runs in each step in which a deck computes stresses.
"""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import pytest
from soft_grains import COMPANIONS, PROPERTIES, STRENGTH, fresh, motion

from plastigran.engine.log import read_thermo

#: Grains of two sizes fall on fixed grains and hit each other.
GRAINS = """
group stones type 2
group moving type 1
region low  block -0.02 0.02 -0.02 0.02 0.004 0.012 units box
region high block -0.025 0.025 -0.02 0.02 0.012 0.04 units box
fix stone all particletemplate/sphere 15485863 atom_type 2 &
    density constant 2500 radius constant 0.004
fix small all particletemplate/sphere 15485867 atom_type 1 &
    density constant 2500 radius constant 0.003
fix large all particletemplate/sphere 32452843 atom_type 1 &
    density constant 2500 radius constant 0.004
fix stones all particledistribution/discrete 32452867 1 stone 1.0
fix sizes  all particledistribution/discrete 49979687 2 small 0.5 large 0.5
fix bed  stones insert/pack seed 67867967 distributiontemplate stones insert_every once &
    overlapcheck yes vel constant 0 0 0 region low particles_in_region 6 ntry_mc 10000
fix rain moving insert/pack seed 86028121 distributiontemplate sizes insert_every once &
    overlapcheck yes vel constant 0.3 0.1 -1 omega constant 0 30 0 &
    region high particles_in_region 30 ntry_mc 10000
"""
RATES = """
fix rate     all property/global rateCoefficient peratomtype 0.05 0.05
fix test     all property/global referenceRate peratomtype 1 1
"""
#: Properties of Luding's models.
LUDING = """
fix dynamic all property/global FluidViscosity peratomtypepair 2 1 1 1 1
fix creep   all property/global FrictionViscosity peratomtypepair 2 1 1 1 1
fix sliding all property/global coeffFrictionStiffness peratomtypepair 2 1 1 1 1
fix viscous all property/global coefficientRollingViscousDamping peratomtypepair 2 0.1 0.1 0.1 0.1
fix stiff   all property/global coeffRollingStiffness peratomtypepair 2 0.2 0.2 0.2 0.2
"""
#: Models in addition to the law, and options at the end of the pair_style and wall lines.
COMBINATIONS = (
    ("tangential history", ""),
    ("tangential history rolling_friction epsd2", ""),
    ("tangential history", "energy_ledger on"),
    ("tangential no_history", ""),
    ("tangential off", ""),
    ("tangential history rolling_friction cdt", ""),
    ("tangential history cohesion sjkr", "energy_ledger on"),
    ("tangential history cohesion washino/capillary/viscous", ""),
    ("tangential history", "viscous_damping on energy_ledger on"),
)
ENTRIES = "".join(f"variable e{k} equal f_energy_ledger[{k}]\n" for k in range(1, 11))


def follow(
    models: str, options: str, folder: Path, seen: str, ranks: int, more: str = "", every: int = 1
) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Return the motion of the grains and the log, for a deck that prints the quantities `seen`."""
    line = f"model universal {models}"
    text = (
        GRAINS
        + PROPERTIES.format(strength=STRENGTH)
        + COMPANIONS
        + more
        + f"pair_style gran {line} {options}\npair_coeff * *\n"
        + f"fix floor all wall/gran {line} primitive type 2 zplane 0.0 {options}\n"
        + "fix integrate moving nve/sphere\nfix hold stones freeze\n"
        + motion()
        + "compute stress all stress/atom pair\ncompute sum all reduce sum c_stress[3]\n"
        + ENTRIES
        + f"thermo {every}\nthermo_style custom step {seen}\nthermo_modify format float %.17g\n"
        + "run 3000\n"
    )
    grains = fresh(text, folder, ranks)
    return grains, read_thermo(folder / "log.liggghts")


@pytest.mark.parametrize(("models", "options"), COMBINATIONS)
@pytest.mark.parametrize("ranks", [1, 2])
def test_all_digits_are_the_engines(models, options, ranks, tmp_path):
    entries = "".join(f"v_e{k} " for k in range(1, 11)) if "energy_ledger" in options else ""
    ours, log = follow(models, options, tmp_path / "ours", f"ke {entries}", ranks)
    engines, their_log = follow(models, options, tmp_path / "engines", f"ke {entries} c_sum", ranks)
    assert len(set(ours.index.get_level_values("id"))) == 36
    pd.testing.assert_frame_equal(ours, engines, check_exact=True)
    assert (their_log["sum"] != 0).any()
    pd.testing.assert_frame_equal(log, their_log[log.columns], check_exact=True)


def test_all_digits_where_rates_matter(tmp_path):
    ours, _ = follow("tangential history", "", tmp_path / "ours", "ke", 1, RATES)
    engines, _ = follow("tangential history", "", tmp_path / "engines", "ke c_sum", 1, RATES)
    plain, _ = follow("tangential history", "", tmp_path / "plain", "ke", 1)
    assert not ours.equals(plain)
    pd.testing.assert_frame_equal(ours, engines, check_exact=True)


@pytest.mark.parametrize(
    "models",
    [
        "tangential history rolling_friction luding",
        "tangential history rolling_friction epsd2",
        "tangential tan_luding",
    ],
)
def test_asking_for_energies_moves_nothing(models, tmp_path):
    """Printing energy terms at each step does not change the motion.

    Luding's models change their history each time forces are computed, so the energy terms must not
    cause another computation of forces.
    """
    line = models, "energy_ledger on"
    often, _ = follow(*line, tmp_path / "often", "v_e3", 1, LUDING)
    seldom, _ = follow(*line, tmp_path / "seldom", "v_e3", 1, LUDING, every=3000)
    pd.testing.assert_frame_equal(often, seldom, check_exact=True)
