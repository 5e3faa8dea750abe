# SPDX-License-Identifier: GPL-2.0-or-later
"""A user's experiment in a folder of $PLASTIGRAN_EXPERIMENTS adds a command to `plastigran`.

See docs/add_an_experiment.md.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pandas as pd
import pytest
from commands import exit_code

from plastigran import experiments

OWN = Path(__file__).parent / "own"


def test_one_file_is_an_experiment(tmp_path):
    """A file with an experiment class adds a command; its results agree with Hertz' theory.

    The relative tolerance is 2e-3. The error is of second order in the time step, which is 1/200 of
    the contact time.
    """
    line = ["touch", "--speed", "0.05", "0.2", "--output", str(tmp_path)]
    done = subprocess.run(
        [sys.executable, "-m", "plastigran", *line],
        env={**os.environ, "PLASTIGRAN_EXPERIMENTS": str(OWN)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    table = pd.read_csv(tmp_path / "impacts.csv")
    assert table["speed"].tolist() == [0.05, 0.2]
    assert (table["radius"] == 0.01).all() and (table["material"] == "steel").all()
    for name in ("contact_time", "force_max"):
        assert table[name].tolist() == pytest.approx(table[f"{name}_predicted"].tolist(), rel=2e-3)
        assert name in done.stdout
    assert "<svg" in (tmp_path / "contact_time.svg").read_text()[:1000]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (["--help"], "elastic impacts of a sphere, against Hertz"),
        (["touch", "--help"], "radius of the sphere, m, default 0.01"),
        (["touch"], "required: --speed"),
        (["touch", "--speed", "-1"], "speed is -1; it must be positive and finite [m/s]"),
        (["touch", "--speed", "fast"], "'fast' is not a number"),
        (["touch", "--speed", "1", "--material", "cheese"], "no material 'cheese'"),
    ],
)
def test_the_command_follows_from_the_fields(line, said, monkeypatch, capsys):
    monkeypatch.setattr(experiments, "__path__", [*experiments.__path__, str(OWN)])
    exit_code(line)
    assert said in " ".join("".join(capsys.readouterr()).split())


def test_the_page_shows_this_experiment():
    """docs/add_an_experiment.md shows the code of own/touch.py without its figure."""
    page = (OWN.parents[2] / "docs" / "add_an_experiment.md").read_text()
    code = (OWN / "touch.py").read_text()
    shown = code[code.index("@attrs.frozen") : code.index("    @classmethod")].strip()
    assert shown in page
