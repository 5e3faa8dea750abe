# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixtures that several test folders share, and parameters that run a test for every law."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from fcntl import LOCK_EX, flock
from functools import cache
from hashlib import sha256
from math import pi
from pathlib import Path

import contact_constants
import pytest
from attrs import evolve
from elastic_contact import NOT_HERTZIAN
from engine_laws import MODELS, one_per_history
from engine_marker import mark
from hypothesis import settings
from references import impacts

from plastigran import laws
from plastigran.bulk.decks import deck_class
from plastigran.bulk.outcome import BulkRun, open_run
from plastigran.bulk.run import run_bulk
from plastigran.engine.process import PROJECT
from plastigran.materials import RIGID, read_material
from plastigran.usable_laws import laws_for

# Laws that begin with an elastic contact and have no adhesion; other laws have their own tests.
ELASTIC_FIRST = {n for n, law in laws.LAWS.items() if law.elastic_first and not law.adhesive}
# The laws of ELASTIC_FIRST that have a model in LIGGGHTS.
ENGINE_LAWS = sorted(ELASTIC_FIRST.intersection(MODELS))


# Random paths: always the same in `./run test`, different in each `./run search`.
settings.register_profile("test", max_examples=60, deadline=None, derandomize=True)
settings.register_profile("search", max_examples=3000, deadline=None)
settings.load_profile("test")


def pytest_configure(config: pytest.Config) -> None:
    # Waiting ranks must leave the core to other tests. The first variable is for Open MPI, the
    # others are for MPICH, which LAMMPS uses. MPICH's collective operations in shared memory wait
    # without calling sched_yield, so the last variable switches these operations off.
    os.environ.setdefault("OMPI_MCA_mpi_yield_when_idle", "1")
    os.environ.setdefault("MPIR_CVAR_POLLS_BEFORE_YIELD", "1")
    os.environ.setdefault("MPIR_CVAR_DEVICE_COLLECTIVES", "none")
    resting_ranks = str(PROJECT / "build" / "tests" / "libresting_ranks.so")
    if "ASAN_OPTIONS" not in os.environ and not set(resting_ranks) & set(" :"):
        os.environ.setdefault("LD_PRELOAD", resting_ranks)
    if config.option.markexpr == "not engine":
        os.environ["PLASTIGRAN_ENGINE"] = "no engine: engine_marker.py missed a test that starts it"


def pytest_xdist_auto_num_workers() -> int:
    """Return one worker more than cores, because many tests wait for other processes."""
    return len(os.sched_getaffinity(0)) + 1


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    mark(items)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run a test for several laws.

    law_name: Every law that begins with an elastic contact and has no adhesion.
    other_law: Every law that is not a `law_name`.
    engine_law: Every `law_name` with a model in LIGGGHTS.
    history_law: Every `engine_law`, and `thornton` with a rate-dependent strength.
    stored_law: One `history_law` for each form of the contact history. Ranks exchange stored
        values whatever their meaning.
    sphere_law: Every `engine_law` for spheres.
    hertzian_law: Every `sphere_law` whose elastic contact is Hertz'.
    yielding_law: Every `sphere_law` that yields.
    rod_law: Every sphere law that the oblique rod supports.
    """
    if "law_name" in metafunc.fixturenames:
        metafunc.parametrize("law_name", sorted(ELASTIC_FIRST))
    if "other_law" in metafunc.fixturenames:
        metafunc.parametrize("other_law", sorted(laws.LAWS.keys() - ELASTIC_FIRST))
    if "rod_law" in metafunc.fixturenames:  # the rod supports no rate-dependent law
        names = [name for name in laws_for("sphere") if not laws.LAWS[name].rate_dependent]
        metafunc.parametrize("rod_law", names)
    if "sphere_law" in metafunc.fixturenames:
        spheres = [name for name in ENGINE_LAWS if laws.LAWS[name].shape == "sphere"]
        metafunc.parametrize("sphere_law", spheres)
    if "hertzian_law" in metafunc.fixturenames:
        spheres = [name for name in ENGINE_LAWS if laws.LAWS[name].shape == "sphere"]
        metafunc.parametrize("hertzian_law", [n for n in spheres if n not in NOT_HERTZIAN])
    if "yielding_law" in metafunc.fixturenames:
        spheres = [name for name in ENGINE_LAWS if laws.LAWS[name].shape == "sphere"]
        metafunc.parametrize("yielding_law", [n for n in spheres if laws.LAWS[n].yields])
    if "engine_law" in metafunc.fixturenames:
        metafunc.parametrize("engine_law", ENGINE_LAWS)
    if "history_law" in metafunc.fixturenames:
        metafunc.parametrize("history_law", [*ENGINE_LAWS, "thornton at a rate"])
    if "stored_law" in metafunc.fixturenames:
        metafunc.parametrize("stored_law", [*one_per_history(ENGINE_LAWS), "thornton at a rate"])


@pytest.fixture
def start_plastigran():
    """`start_plastigran(*words)` starts the command `plastigran` as at a terminal.

    Ctrl-C reaches the command even if these tests run in the background of a shell. The fixture
    kills its processes when the test ends.
    """
    started = []

    def start(*words: object) -> subprocess.Popen:
        line = ["setpriv", "--pdeathsig", "KILL", sys.executable, "-m", "plastigran"]
        started.append(
            subprocess.Popen(
                [*line, *map(str, words)],
                stderr=subprocess.PIPE,
                text=True,
                start_new_session=True,
                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
            )
        )
        return started[-1]

    yield start
    for run in started:
        run.kill()
        run.communicate()


@pytest.fixture(scope="session")
def law_between(aluminium):
    """`law_between(name, pair, length, **options)` makes a law between two bodies.

    `length` [m] is the length of cylinders and the thickness of bodies, for laws that need them.
    """

    @cache
    def make(name: str, pair: laws.MaterialPair, length: float = 0.1, **options: str):
        brought = [p["name"] for p in laws.LAWS[name].parameters() if p["per_body"]]
        constants = {key: contact_constants.VALUES[key] for key in aluminium.missing(name)}
        return aluminium.law(name, pair, **dict.fromkeys(brought, length), **constants, **options)

    return make


@pytest.fixture(scope="session")
def aluminium():
    """The aluminum of Zhang & Vu-Quoc (2002). The dissipative constant is added for laws that need
    it; it gives the paper's sphere a restitution near 0.8."""
    return evolve(read_material("aluminium_zv02"), dissipative_constant=3e-5)


@pytest.fixture(scope="session")
def paper_pair(aluminium):
    """The aluminum of the paper on a rigid plane."""
    return laws.combine(aluminium.body(), RIGID)


@pytest.fixture(scope="session")
def paper_mass(aluminium) -> float:
    """Mass of the paper's sphere of 0.1 m radius [kg]."""
    return 4 / 3 * pi * 0.1**3 * aluminium.density


@pytest.fixture(scope="session")
def declared_jumps() -> dict[str, list[tuple[float, float]]]:
    """Jumps of the force during first loading, by law, for the paper's aluminum.

    They follow from the equations of the source. Each jump is a pair: overlap / overlap at yield,
    and relative change of the force.
    """
    return {law: impacts.jumps(law) for law in ELASTIC_FIRST}


@pytest.fixture(scope="session")
def workers_folder(tmp_path_factory) -> Path:
    """A folder that pytest's workers share."""
    base = tmp_path_factory.getbasetemp()
    return base.parent if "PYTEST_XDIST_WORKER" in os.environ else base


@pytest.fixture(scope="session")
def bulk_run(workers_folder):
    """`bulk_run(deck, settings)` runs a bulk deck, once for all tests and pytest's workers.

    Tests must not change the folder or the returned object.
    """
    shared = workers_folder / "bulk_runs"
    shared.mkdir(exist_ok=True)

    @cache
    def run(deck: str, settings: str) -> BulkRun:
        folder = shared / sha256(f"{deck} {settings}".encode()).hexdigest()[:16]
        with open(folder.with_suffix(".lock"), "w") as lock:
            flock(lock, LOCK_EX)
            if (folder / "checks.csv").exists():
                return open_run(folder)
            return run_bulk(deck, json.loads(settings), folder, force=True, show=False)

    return lambda deck, settings: run(deck, json.dumps(settings, sort_keys=True))


@pytest.fixture(scope="session")
def brief_run(bulk_run):
    """`brief_run(deck, label)` returns the short run that a bulk deck declares, with two frames."""

    def run(deck: str, label: str = "") -> BulkRun:
        return bulk_run(deck, {**deck_class(deck).briefs[label].settings, "frames": 2})

    return run
