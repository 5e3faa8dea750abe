# SPDX-License-Identifier: GPL-2.0-or-later
"""Computations side by side."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import warnings

import attrs
import pytest

from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.press import press
from plastigran.report.computing import Computation, compute_all

METAL = ElasticPlastic(youngs_modulus=70e9, poissons_ratio=0.3)
COARSE = Settings(divisions=3, fineness=0.5, unloading_steps=4)


@attrs.frozen
class Stopped:
    stopped: str = "no step from here"


def give_up(settings, progress):
    return Stopped()


@pytest.fixture(autouse=True)
def cache_of_its_own(tmp_path, monkeypatch):
    monkeypatch.setenv("PLASTIGRAN_CACHE", str(tmp_path))


def test_results_come_by_name_in_the_order_asked_for_and_are_kept(tmp_path):
    asked = {
        force: Computation(press, (METAL, 0.1, [force]), COARSE) for force in (20.0, 10.0, 30.0)
    }
    found = compute_all(asked)
    assert {name: result.history["force"].max() for name, result in found.items()} == {
        name: pytest.approx(name) for name in asked
    }
    assert list(found) == list(asked)
    assert len(list(tmp_path.glob("press_*.result"))) == len(asked)


def test_one_that_gives_up_is_named():
    with pytest.raises(ValueError, match="finite elements, the sphere: no step from here"):
        compute_all({"the sphere": Computation(give_up, ())})


def tell(settings, progress):
    warnings.warn("the contact is wide", stacklevel=1)
    return 1.0


def test_a_warning_is_told_in_one_plain_line(capfd):
    compute_all({"the sphere": Computation(tell, ())})
    assert capfd.readouterr().err == "plastigran: the contact is wide\n"


WAITING = """
from time import sleep
from plastigran.report.computing import Computation, compute_all

def wait(settings, progress):
    print("started", flush=True)
    sleep(600)

if __name__ == "__main__":
    compute_all({"the sphere": Computation(wait, ())})
"""


@pytest.mark.parametrize("said", [signal.SIGTERM, signal.SIGINT])
def test_workers_end_with_the_process_that_started_them(said, tmp_path):
    script = tmp_path / "waiting.py"
    script.write_text(WAITING)
    started = subprocess.Popen(
        # A parent in the background ignores Ctrl-C, and so would what it starts.
        ["env", "--default-signal=INT", sys.executable, script],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        process_group=0,
    )
    assert started.stdout.readline() == "started\n"
    if said == signal.SIGINT:  # of a terminal, to all of them
        os.killpg(started.pid, said)
    else:
        started.send_signal(said)
    # The worker's end of the pipe is closed when the worker has ended.
    assert started.communicate(timeout=30) == ("", None)
