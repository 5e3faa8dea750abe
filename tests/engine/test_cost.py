# SPDX-License-Identifier: GPL-2.0-or-later
"""Watching contacts costs nothing: beyond the range of a law a step is as cheap as within it."""

from __future__ import annotations

import re
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage

from plastigran import laws
from plastigran.engine.process import run_deck

#: 512 pairs of spheres so heavy that no contact changes their motion: one of each pair is driven
#: into the other up to 0.08 R* and out again.
DECK = """
variable output index .
variable inputs index inputs
units           si
atom_style      granular
boundary        f f f
newton          off
communicate     single vel yes
region          box block -0.02 0.32 -0.02 0.32 -0.02 0.32 units box
create_box      2 box
neighbor        0.001 bin
neigh_modify    delay 0
fix youngs   all property/global youngsModulus peratomtype 5e6 5e6
fix poisson  all property/global poissonsRatio peratomtype 0.3 0.3
fix strength all property/global yieldStrength peratomtype {strength} {strength}
fix viscous  all property/global dissipativeConstant peratomtypepair 2 1e-9 1e-9 1e-9 1e-9
lattice         custom 0.04 a1 1 0 0 a2 0 1 0 a3 0 0 1 basis 0 0 0 basis 0 0 0.25
region          all block -0.001 0.299 -0.001 0.299 -0.001 0.299 units box
create_atoms    1 region all basis 2 2
set group all diameter 0.0100000001 density 1e20
group           driven type 2
pair_style      gran model {law} tangential off
pair_coeff      * *
fix integrate   driven nve/sphere
timestep        1e-7
thermo          100000
velocity        driven set 0 0 -1 units box
run             2000
velocity        driven set 0 0 1 units box
run             2000
"""


def cpu_time(law: str, strength: float, folder: Path) -> tuple[float, int]:
    """Processor time of a run [s], which is less at the mercy of other processes than its length,
    and the number of contacts that left the law's range."""
    folder.mkdir(exist_ok=True)
    (folder / "deck.in").write_text(DECK.format(law=law, strength=strength))
    before = getrusage(RUSAGE_CHILDREN)
    log = run_deck(folder / "deck.in", {}, folder)
    after = getrusage(RUSAGE_CHILDREN)
    assert "Loop time of" in log and " 2000 steps with 1024 atoms" in log
    counted = re.findall(r"contacts beyond the law's range .* so far: (\d+)", log)
    return after.ru_utime - before.ru_utime, int(counted[-1]) if counted else 0


def test_a_contact_beyond_the_range_costs_as_much_as_one_within(yielding_law, tmp_path):
    """At most 1.3 times; it was 20 to 100 for laws whose energy is a quadrature.

    The same motion, all of it beyond yield, with a hundredth of the strength. A law that only asks
    for small overlaps has no other range to leave: its time is compared all the same. The shortest
    of up to four runs, because others use the machine.
    """
    within = beyond = float("inf")
    for _ in range(4):
        seconds, counted = cpu_time(yielding_law, 1e5, tmp_path / "within")
        assert counted == 0
        within = min(within, seconds)
        seconds, counted = cpu_time(yielding_law, 1e3, tmp_path / "beyond")
        assert counted == (512 if narrow(yielding_law) else 0)
        beyond = min(beyond, seconds)
        if beyond <= 1.3 * within:
            break
    assert beyond <= 1.3 * within


def narrow(law: str) -> bool:
    """Whether a hundredth of the strength leads beyond the law's range."""
    body = laws.Body(youngs_modulus=5e6, poissons_ratio=0.3, yield_strength=1e3)
    return laws.LAWS[law](laws.combine(body, body)).overlap_range < 0.08
