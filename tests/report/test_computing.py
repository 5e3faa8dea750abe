# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of parallel finite-element computations."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import warnings
from functools import partial

import attrs
import pytest

from plastigran.fem.cache import cached
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.press import press
from plastigran.report.computing import compute_all

METAL = ElasticPlastic(youngs_modulus=70e9, poissons_ratio=0.3)
COARSE = Settings(divisions=3, fineness=0.5, unloading_steps=4)


@attrs.frozen
class Stopped:
    stopped: str = "no step from here"


def stop_early():
    return Stopped()


@pytest.fixture(autouse=True)
def empty_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("PLASTIGRAN_CACHE", str(tmp_path))


def test_results_are_in_order_and_cached(tmp_path):
    computations = {
        force: partial(cached, press, METAL, 0.1, [force], settings=COARSE)
        for force in (20.0, 10.0, 30.0)
    }
    results = compute_all(computations)
    assert list(results) == list(computations)
    for force, result in results.items():
        assert result.history["force"].max() == pytest.approx(force)
    assert len(list(tmp_path.glob("press_*.result"))) == len(computations)


def test_computation_that_stops_early_is_named():
    with pytest.raises(ValueError, match="computation of the sphere: no step from here"):
        compute_all({"the sphere": stop_early})


def warn():
    warnings.warn("the contact is wide", stacklevel=1)
    return 1.0


def test_warnings_of_workers_are_plain_lines(capfd):
    compute_all({"the sphere": warn})
    assert capfd.readouterr().err == "plastigran: the contact is wide\n"


WAITING = """
from time import sleep
from plastigran.report.computing import compute_all

def wait():
    print("started", flush=True)
    sleep(600)

if __name__ == "__main__":
    compute_all({"the sphere": wait})
"""


@pytest.mark.parametrize("stop", [signal.SIGTERM, signal.SIGINT])
def test_workers_end_with_their_parent(stop, tmp_path):
    script = tmp_path / "waiting.py"
    script.write_text(WAITING)
    started = subprocess.Popen(
        # Restore the default reaction to Ctrl-C. A background process ignores Ctrl-C, and its child
        # processes inherit this.
        ["env", "--default-signal=INT", sys.executable, script],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        process_group=0,
    )
    assert started.stdout.readline() == "started\n"
    if stop == signal.SIGINT:  # on Ctrl-C, a terminal sends this signal to all processes
        os.killpg(started.pid, stop)
    else:
        started.send_signal(stop)
    # The pipe closes when the worker has ended.
    assert started.communicate(timeout=30) == ("", None)
