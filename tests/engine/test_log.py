# SPDX-License-Identifier: GPL-2.0-or-later
"""Damaged logs of LIGGGHTS are refused."""

from __future__ import annotations

import pytest

from plastigran.engine.dumps import DumpError
from plastigran.engine.log import read_thermo


@pytest.mark.parametrize("step", ["1e999", "1e300", "1.5"])
def test_an_impossible_step_is_refused(step, tmp_path):
    log = tmp_path / "log.liggghts"
    log.write_text(f"Step Atoms\n0 1\n{step} 1\nLoop time of 1\n")
    with pytest.raises(DumpError, match=r"log.liggghts is damaged: a line has step [\d.e+inf]+,"):
        read_thermo(log)
