# SPDX-License-Identifier: GPL-2.0-or-later
"""The scripts of docs and benchmarks run to their end on small cases."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType, SimpleNamespace

import attrs
import numpy as np
import pandas as pd
import pytest
from numpy.testing import assert_allclose

from plastigran.engine.dumps import read_dump
from plastigran.engine.process import PROJECT, run_deck
from plastigran.fem.material.elastic_plastic import State
from plastigran.fem.material.kinematics import FiniteStrain
from plastigran.fem.settings import Settings
from plastigran.usable_laws import laws_for


def load(path: str) -> ModuleType:
    spec = spec_from_file_location(Path(path).stem, PROJECT / path)
    module = sys.modules[spec.name] = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_convergence_of_finite_elements():
    """`docs/convergence.py` computes how finite-element results change with their settings.

    A third of the contact penalty changes results of a coarse compression and a coarse impact by
    less than 2 %. The contact radius changes most, by 1.2 %, because it is resolved to a fraction
    of an element.
    """
    script = load("docs/convergence.py")
    coarse = Settings(divisions=4, fineness=0.5, growth=1.15, unloading_steps=10)
    softer = {"penalty": (15.0,)}
    for table in script.tables(softer, softer, attrs.evolve(coarse, steps_of_contact=80)).values():
        changes = table.filter(like="_change").to_numpy()
        assert (changes[0] == 0).all() and 0 < abs(changes[1]).max() < 2
    # A coarse mesh agrees with Hertz within 1 %, and a fine mesh within 0.2 %.
    assert abs(script.elastic_table([174.0], coarse)["off Hertz (%)"][0]) < 1


def test_pair_time(tmp_path, monkeypatch, capsys):
    """`benchmarks/pair_time.py` works: here, it times two steps of 216 spheres and of 36 discs."""
    monkeypatch.syspath_prepend(PROJECT / "benchmarks")
    script = load("benchmarks/pair_time.py")
    monkeypatch.setattr(script, "WORK", tmp_path)
    monkeypatch.setattr(script, "RESULTS", tmp_path / "pair_time.csv")
    little = {"across": 6, "high": 6, "steps": 200}
    for deck, folder in (("bed", "1000"), ("bed_of_discs", "1000_discs")):
        run_deck(script.HERE / f"{deck}.in", little, tmp_path / folder)
    words = ["--law", "thornton", "lim_stronge", "--grains", "1000", "--repeats", "1"]
    monkeypatch.setattr(sys, "argv", ["pair_time.py", *words, "--steps", "2"])
    script.main()
    table = pd.read_csv(tmp_path / "pair_time.csv")
    assert set(zip(table["shape"], table["law"], strict=True)) == {
        ("sphere", "thornton"),
        ("sphere", "hertz again"),
        ("cylinder", "lim_stronge"),
        ("cylinder", "hertz again"),
    }
    assert (table["ratio"] > 0).all() and (table["contacts"] > 20).all()
    assert (tmp_path / "pair_time.svg").stat().st_size > 10_000
    assert "median (quartiles) of 1 rounds" in capsys.readouterr().out
    words = ["--law", "thornton", "--tangential", "partial_slip", *words[3:]]
    monkeypatch.setattr(sys, "argv", ["pair_time.py", *words, "--steps", "2"])
    script.main()
    table = pd.read_csv(tmp_path / "pair_time.csv")
    assert set(table["law"]) == {"thornton, partial_slip", "thornton again"}
    assert (table["ratio"] > 0).all() and (table["plastic_share"] > 0).any()


@pytest.mark.engine
def test_peers(tmp_path, monkeypatch, capsys):
    """`benchmarks/peers.py` works: here, it times two steps of 72 spheres, in LIGGGHTS only."""
    monkeypatch.syspath_prepend(PROJECT / "benchmarks")
    script = load("benchmarks/peers.py")
    monkeypatch.setattr(script, "WORK", tmp_path)
    monkeypatch.setattr(script, "RESULTS", tmp_path)
    run_deck(script.HERE / "bed.in", {"across": 6, "high": 6, "steps": 200}, tmp_path)
    monkeypatch.setattr(script, "make_bed", lambda _: tmp_path / "bed.data")
    laws = ["thornton", "hooke/hysteresis", "thornton_ning"]
    words = ["peers.py", "--part", "cost", "--law", *laws, "--repeats", "1", "--steps", "2"]
    monkeypatch.setattr(sys, "argv", words)
    script.main()
    rounds = pd.read_csv(tmp_path / "peers.csv")
    assert set(rounds["law"]) == {"hertz", "hertz again", *laws}
    assert (rounds[["loop", "pair", "clock"]] > 0).all(axis=None)
    assert "| `hooke/hysteresis` |" in capsys.readouterr().out


@pytest.mark.engine
def test_restitution_of_peers(tmp_path, monkeypatch):
    """`benchmarks/peers_restitution.py` compares restitution with other codes' laws.

    `hooke/hysteresis` agrees with the finite elements at the speed of its fit, within 1 % due to
    interpolation between speeds. The law of this project agrees with Python within the error of a
    time step of 1/4000 of an impact.
    """
    monkeypatch.syspath_prepend(PROJECT / "benchmarks")
    script = load("benchmarks/peers_restitution.py")
    found = script.restitution(tmp_path, ["hooke/hysteresis", "thornton"])
    curve = {law: rows["restitution"].to_numpy() for law, rows in found.groupby("law")}
    elements = found[found["law"] == "finite elements"]
    at = np.interp(script.AGREES, elements["speed_ratio"], elements["restitution"])
    reached = np.interp(script.AGREES, script.SPEED_RATIOS, curve["hooke/hysteresis"])
    assert_allclose(reached, at, rtol=0.01)
    spheres = script.Spheres()
    law = script.laws.LAWS["thornton"](spheres.pair)
    impact = law.central_impact(spheres.radius / 2, spheres.mass / 2, 2 * spheres.speeds)
    assert_allclose(curve["thornton"], impact.coefficient_of_restitution, rtol=1e-3)
    script.draw(found, tmp_path / "peers.svg")
    assert (tmp_path / "peers.svg").exists()


@pytest.mark.engine
def test_size(tmp_path, monkeypatch, capsys):
    """`benchmarks/size.py` makes large beds from adjacent copies of a small bed.

    Copies of a bed of 100 grains have the same forces to round-off. A restarted run and a run on
    four ranks agree to round-off with a run on one rank.
    """
    monkeypatch.syspath_prepend(PROJECT / "benchmarks")
    script = load("benchmarks/size.py")
    for place in ("size_beds.WORK", "size_beds.RESULTS", "size_parallel.WORK"):
        monkeypatch.setattr(place, tmp_path)
    monkeypatch.setattr(script, "WORK", tmp_path)
    settled = script.base(across=5, high=4, steps=200)
    for place in (script, sys.modules["size_parallel"]):
        monkeypatch.setattr(place, "base", lambda: settled)
    forces = []
    for along in ((1, 1), (2, 3)):
        case = {"steps": 2, "warm": 2, "rest": 2}
        script.run(script.widen(settled, *along), case, tmp_path / "run")
        end = read_dump(tmp_path / "run" / "end.dump").query("step == 6").sort_values("id")
        forces.append(end[["fx", "fy", "fz"]].to_numpy().reshape(-1, 100, 3))
    assert (len(forces[0]), len(forces[1])) == (1, 6)
    assert_allclose(forces[1], forces[0].repeat(6, axis=0), atol=1e-9 * np.abs(forces[0]).max())
    script.print_restart(script.widen(settled, 1, 1), steps=20)
    assert "bitwise identical" in capsys.readouterr().out
    words = ["size.py", "--part", "cost", "calls", "--grains", "12500", "--repeats", "1"]
    monkeypatch.setattr(sys, "argv", [*words, "--steps", "5"])
    script.main()
    costs = load("benchmarks/size_model.py").fit(pd.read_csv(tmp_path / "size_cost_12500.csv"))
    assert costs.grain > 0 and costs.copy > 0 and costs.bytes > 0
    said = capsys.readouterr().out
    assert "thornton, ledger 1" in said and "allreduce: 1 per step" in said
    script.many(SimpleNamespace(steps=5), count=4)
    apart = re.findall(r"largest difference (\S+)", capsys.readouterr().out)
    assert len(apart) == 3 and max(map(float, apart)) < 1e-9  # round-off grows for ten steps


def test_the_model_of_clusters():
    """`benchmarks/size_model.py` predicts the time of a step on a cluster.

    The model gives the number of ghost copies that was counted on four ranks of 3125 grains, 20
    layers deep, within 10 %. This tolerance is the error of the mean distance of grains. More ranks
    are less efficient, and one rank needs only the time of its grains.
    """
    model = load("benchmarks/size_model.py")
    reach = 2 * model.REACH
    assert_allclose((12.5 + reach) ** 2 * 20 - 3125, 1295, rtol=0.1)
    assert model.contacts_factor(1e9) < model.contacts_factor(1e3)
    costs = model.Costs(grain=5e-7, copy=5e-8, bytes=1500)
    alone = model.Cluster(imbalance=1)
    parts = model.step_time(1e6, 1, costs, alone)
    assert sum(parts.values()) == pytest.approx(0.5 * model.contacts_factor(1e6))
    efficiency = model.predict(costs, alone)["efficiency"].str.rstrip("%").astype(int)
    assert (efficiency.groupby(np.arange(12) // 3).diff().dropna() < 0).all()


def test_random_calls(monkeypatch, capsys):
    """`benchmarks/random_calls.py` fails if it does not call every law.

    20000 calls are one random pair of materials with one law; all other laws have no calls.
    """
    script = load("benchmarks/random_calls.py")
    monkeypatch.setattr(sys, "argv", ["random_calls.py", "--calls", "20000"])
    with pytest.raises(SystemExit) as stop:
        script.main()
    said = capsys.readouterr().out
    counts = {name: int(count) for name, count in re.findall(r"^(\w+): (\d+) calls", said, re.M)}
    assert counts.keys() == {*laws_for("sphere"), *laws_for("cylinder")}
    assert sorted(counts.values())[:-1] == [0] * (len(counts) - 1)
    assert f"{sum(counts.values())} calls of {len(counts)} laws: 0 violations" in said
    assert stop.value.code == 1


def test_the_slurm_script_continues_from_the_older_checkpoint(tmp_path):
    """The Slurm example continues from the older of two checkpoints; the newer may be truncated.

    Without checkpoints, or with only one, the run starts at its beginning. In this test, `srun`
    prints its arguments.
    """
    script = PROJECT / "examples" / "slurm" / "large_bed.sh"
    srun = tmp_path / "srun"
    srun.write_text('#!/bin/sh\necho "$@"\n')
    srun.chmod(0o755)
    slurm = {"SLURM_JOB_ID": "7", "SLURM_NNODES": "1", "SLURM_NTASKS": "2"}
    environment = os.environ | slurm | {"PATH": f"{tmp_path}:{os.environ['PATH']}"}
    subprocess.run(["bash", "-n", script], check=True)
    started = []
    for file, age in (("", 0), ("bed.0.restart", 100), ("bed.1.restart", 50)):
        if file:
            (tmp_path / file).touch()
            os.utime(tmp_path / file, (1e9 - age, 1e9 - age))
        done = subprocess.run(
            ["bash", script, "bed.in"],
            cwd=tmp_path, env=environment, check=True, capture_output=True, text=True,
        )  # fmt: skip
        started.append(done.stdout.split()[-1])
    assert started == ["none", "none", "bed.0.restart"]


@pytest.mark.parametrize("part", ["kills", "restarts"])
def test_reliability(part, tmp_path, monkeypatch):
    """`benchmarks/reliability.py` runs two kills or restarts, and replaces only their table."""
    monkeypatch.syspath_prepend(PROJECT / "benchmarks")
    script = load("benchmarks/reliability.py")
    page = PROJECT / "docs" / "reliability.md"
    monkeypatch.setattr(script, "WORK", tmp_path / "work")
    monkeypatch.setattr(script, "PAGE", tmp_path / "page.md")
    killing = sys.modules["reliability_kills"]
    few = {"duration": "6", "rows": "48", "checkpoints": "24", "mixing": "0.2"}
    monkeypatch.setattr(killing, "SMALL", killing.SMALL | few)
    # The script kills a run about a dozen times, each after at most 15 % of its steps. Here, it
    # kills the run once, after 60 % of its steps.
    monkeypatch.setattr(killing, "random", SimpleNamespace(uniform=lambda low, high: 4 * high))
    script.PAGE.write_text(page.read_text())
    monkeypatch.setattr(sys, "argv", ["reliability.py", part, "--count", "2"])
    script.main()
    before, table, after = script.PAGE.read_text().partition(f"<!-- {part} -->\n")
    assert page.read_text().startswith(before + table)
    written, _, rest = after.partition("<!-- end -->\n")
    assert page.read_text().endswith(rest)
    assert [line for line in written.splitlines() if re.match(r"\|.*\d", line)], "no row"


def test_the_metal_of_the_independent_finite_elements():
    """The independent finite elements compute the same stresses as those of this package.

    The independent ones split the deformation gradient into an elastic and a plastic factor, F =
    F_e F_p; the package adds logarithmic strains. Both are equivalent if the principal stretches
    keep their directions.
    """
    script = load("benchmarks/independent_finite_elements.py")
    material = script.HARD
    stretches = np.random.default_rng(7).normal(scale=0.05, size=(50, 3))
    gradients = np.hstack([stretches, np.zeros((50, 2))])
    finite = FiniteStrain()
    response = material.respond(finite.strain(gradients), State.undeformed(50))
    assert response.flowing.size > 20
    deformation = np.zeros((3, 3, 1, 50))
    deformation[[0, 1, 2], [0, 1, 2], 0] = 1 + stretches.T
    metal = script.FiniteMetal(material)
    stress, _ = metal.stress([deformation, np.zeros((9, 1, 50))])
    expected = finite.conjugate(gradients, response.stress)[:, :3]
    found = stress[[0, 1, 2], [0, 1, 2], 0].T
    assert_allclose(found, expected, atol=1e-9 * material.youngs_modulus)  # round-off


@pytest.mark.engine
def test_softened_decks_are_compared(tmp_path, monkeypatch):
    """`docs/softening.py` compares softened decks; the shares of the dissipation add up to one."""
    script = load("docs/softening.py")
    moment = {**script.DRUM, "duration": 0.06, "settling": 0.01, "rows": 24}
    monkeypatch.setattr(script, "DECKS", {"drum": moment})
    found = script.compared(tmp_path, decks=["drum"], factors=[1e-4], seeds=[1])
    shares = found.xs("mean", axis="columns", level=1)[list(script.SHARES)]
    assert_allclose(shares.sum(axis="columns"), 1)
    assert (shares[["plastic", "friction"]] > 0).all(axis=None)
