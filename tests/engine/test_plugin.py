# SPDX-License-Identifier: GPL-2.0-or-later
"""The plugin is a shared library that adds models and changes nothing else."""

from __future__ import annotations

import os
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from plastigran import laws
from plastigran.engine.process import PROJECT, command, environment, inputs_folder, run_deck
from plastigran.experiments.collision import measure

PLUGIN = PROJECT / "build" / "libplastigran.so"
VISCOSITY = {"dissipative_constant": 3e-5}  # some laws need it; others ignore it


def wall_deck(law: str) -> str:
    """Return the deck of a body and a wall for a law or a model of LIGGGHTS."""
    shape = laws.LAWS[law].shape if law in laws.LAWS else "sphere"
    return f"collision/{shape}_wall.in"


def stock(folder: Path, preload: Path | None, **variables) -> subprocess.CompletedProcess:
    """Run the wall deck for a law in the stock `liggghts`."""
    deck = inputs_folder() / wall_deck(variables["law"])
    line = ["liggghts", *command(deck, VISCOSITY | variables, folder)[1:]]
    extra = {}
    if preload:
        link = folder / "preloaded.so"  # the loader splits LD_PRELOAD at spaces
        link.symlink_to(preload)
        extra["LD_PRELOAD"] = str(link)
    return subprocess.run(
        line,
        cwd=folder,
        env=environment() | extra,
        capture_output=True,
        text=True,
        errors="replace",
    )


def test_stock_liggghts_loads_the_plugin_by_preload(engine_law, tmp_path):
    done = stock(tmp_path, PLUGIN, law=engine_law)
    assert done.returncode == 0, done.stdout + done.stderr
    assert not done.stderr, "the plugin gives warnings when it is loaded"
    run_deck(wall_deck(engine_law), VISCOSITY | {"law": engine_law}, tmp_path / "launcher")
    preloaded = measure(tmp_path / "trajectory.dump")
    launched = measure(tmp_path / "launcher" / "trajectory.dump")
    assert preloaded.coefficient_of_restitution == launched.coefficient_of_restitution


def test_stock_liggghts_has_no_models_of_the_plugin(engine_law, tmp_path):
    done = stock(tmp_path, None, law=engine_law)
    assert done.returncode != 0
    assert "Invalid model specified" in done.stdout + done.stderr


def test_plugin_exports_nothing():
    """The shared library of the plugin exports no symbols.

    Under LD_PRELOAD, an exported template instance would replace that of LIGGGHTS.
    """
    listed = subprocess.run(
        ["nm", "-D", "--defined-only", PLUGIN], capture_output=True, text=True, check=True
    )
    assert listed.stdout.strip() == ""


def test_plugin_leaves_stock_models_alone(tmp_path):
    """Results of stock hertz with and without the plugin are bitwise identical."""
    for name, preload in (("with", PLUGIN), ("without", None)):
        (tmp_path / name).mkdir()
        assert stock(tmp_path / name, preload, law="hertz").returncode == 0
    loaded, alone = (tmp_path / name / "trajectory.dump" for name in ("with", "without"))
    assert loaded.read_bytes() == alone.read_bytes()


def test_liggghts_of_another_layout_is_refused(tmp_path):
    """A LIGGGHTS with superquadric particles is refused, because its structures are larger.

    The plugin recognizes it by a symbol. In this test, a library exports only this symbol.
    """
    source = tmp_path / "superquadric.c"
    source.write_text("const char _ZTVN9LAMMPS_NS18AtomVecSuperquadricE[1] = {0};\n")
    library = tmp_path / "libsuperquadric.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source], check=True)
    done = subprocess.run(
        [PROJECT / "build" / "liggghts-plastigran", "-h"],
        env=os.environ | {"LD_PRELOAD": str(library)},
        capture_output=True,
        text=True,
        cwd=tmp_path,
    )
    assert done.returncode == 1
    assert re.search(
        r"compiled for a LIGGGHTS without superquadric .* this LIGGGHTS was built with them",
        done.stderr,
    )


def test_liggghts_of_another_version_is_refused(tmp_path):
    """The plugin compares the version of LIGGGHTS with the version for which it was compiled."""
    binary = PLUGIN.read_bytes()
    version = re.search(rb"LIGGGHTS-PUBLIC [0-9.]+", binary)[0]
    other = tmp_path / "libplastigran.so"
    other.write_bytes(binary.replace(version, version[:-1] + b"7"))
    done = stock(tmp_path, other, law="thornton")
    assert done.returncode != 0
    assert "Plastigran was compiled for LIGGGHTS-PUBLIC 3.8.7, but this is" in done.stdout
    assert not (tmp_path / "trajectory.dump").exists()


def test_single_processes_start_at_the_same_time(tmp_path):
    """Several LIGGGHTS processes without mpirun can start at the same time.

    A process must not use the MPI session files of another process.
    """
    (tmp_path / "empty.in").write_text("")
    line = [PROJECT / "build" / "liggghts-plastigran", "-in", "empty.in", "-log", "none"]

    def start(_) -> int:
        return subprocess.run(line, cwd=tmp_path, capture_output=True, check=False).returncode

    with ThreadPoolExecutor(6) as pool:
        assert set(pool.map(start, range(60))) == {0}
