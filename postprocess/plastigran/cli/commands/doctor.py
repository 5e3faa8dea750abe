# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran doctor`: is all there that runs need, and does it work?"""

from __future__ import annotations

import argparse
import os
import platform
import re
import shutil
import subprocess
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path
from tempfile import TemporaryDirectory
from time import monotonic

import attrs

from plastigran.cli.arguments import add_json, print_json
from plastigran.engine.log import LOG
from plastigran.engine.process import EngineError, engine_path, inputs_folder
from plastigran.experiments.central import CentralImpact

HELP = "look whether all is there that runs need, and let a sphere fall"
EXAMPLE = "plastigran doctor"

#: Restitution of the engine over theory's is this near 1: what the recommended time step is for.
TOLERANCE = 1e-3
#: Packages that some commands need, and which.
OPTIONAL = {"pyvista": "snapshot", "imageio": "snapshot --movie", "av": "snapshot --movie FILE.mp4"}


@attrs.frozen
class Finding:
    """What was looked at.

    Attributes:
        name: Of it.
        state: "ok", "lacks", or "without" for what one can do without.
        said: What was found.
        remedy: What to do, where something lacks.
    """

    name: str
    state: str
    said: str
    remedy: str = ""


class Lacking(Exception):
    """Something is not there or does not work: what, and what to do."""


def add_arguments(command: argparse.ArgumentParser) -> None:
    add_json(command)


def run(arguments: argparse.Namespace) -> None:
    """Print what was found, a line each.

    Raises:
        EngineError: Something lacks that runs in the engine need.
    """
    found = []
    for finding in examine():
        found.append(finding)
        if not arguments.json:
            remedy = f"; {finding.remedy}" if finding.remedy else ""
            print(f"{finding.state:8s}{finding.name:12s}{finding.said}{remedy}", flush=True)
    if arguments.json:
        print_json([attrs.asdict(finding) for finding in found])
    if lacking := [finding.name for finding in found if finding.state == "lacks"]:
        raise EngineError(
            f"{', '.join(lacking)}: not as it should be; laws, timestep, soften, calibrate, fem "
            "and impact --theory work without an engine"
        )


def examine() -> Iterator[Finding]:
    """Look at one thing after the other; of the engine no further than it is sound."""
    said = f"{version('plastigran')}, Python {platform.python_version()}, {os.cpu_count()} cores"
    yield Finding("plastigran", "ok", said)
    yield libraries()
    for name, look in (
        ("inputs", _inputs),
        ("engine", _engine),
        ("plugin", _plugin),
        ("impact", _impact),
        ("MPI", _mpi),
    ):
        try:
            yield Finding(name, "ok", look())
        except Lacking as error:
            yield Finding(name, "lacks", *error.args)
            break
    for name, command in OPTIONAL.items():
        try:
            yield Finding(name, "ok", version(name))
        except PackageNotFoundError:
            remedy = f"plastigran {command} needs it: pip install {name}"
            yield Finding(name, "without", "is not installed", remedy)


def libraries() -> Finding:
    """The Python packages that ours asks for, but for those of an extra."""
    found, missing = [], []
    for line in requires("plastigran") or ():
        name = re.split(r"[^\w.-]", line)[0]
        if "extra ==" in line:
            continue
        try:
            found.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            missing.append(name)
    if missing:
        said = f"{', '.join(missing)} {'are' if missing[1:] else 'is'} not installed"
        return Finding("libraries", "lacks", said, f"pip install {' '.join(missing)}")
    return Finding("libraries", "ok", ", ".join(found))


def _inputs() -> str:
    try:
        return str(inputs_folder())
    except EngineError as error:
        raise Lacking(str(error), "unset PLASTIGRAN_INPUTS for the package's own") from None


def _engine() -> str:
    try:
        return str(engine_path())
    except EngineError as error:
        raise Lacking(
            str(error), "docs/engine.md says how LIGGGHTS and the plugin are had"
        ) from None


def _plugin() -> str:
    """The plugin, as the loader finds it for the launcher."""
    done = subprocess.run(["ldd", engine_path()], capture_output=True, text=True, check=False)
    needed = dict(line.strip().partition(" => ")[::2] for line in done.stdout.splitlines())
    if missing := [name for name, place in needed.items() if place.startswith("not found")]:
        raise Lacking(
            f"{', '.join(missing)} cannot be loaded",
            "install liggghts and openmpi-bin, or build again with ./run setup",
        )
    plugin = next((place for name, place in needed.items() if name == "libplastigran.so"), None)
    if plugin is None:  # an engine with the laws in its source tree
        return "none: the laws are the engine's own"
    return str(Path(plugin.split(" (")[0]).resolve())


def _impact() -> str:
    return _collide(1)


def _mpi() -> str:
    if not shutil.which("mpirun"):
        raise Lacking("mpirun is not on PATH", "install openmpi-bin")
    done = subprocess.run(["mpirun", "--version"], capture_output=True, text=True, check=False)
    return f"{done.stdout.strip().splitlines()[0]}; {_collide(2)}"


def _collide(ranks: int) -> str:
    """An impact of a sphere on a plane, held against theory.

    Raises:
        Lacking: It does not run, or another restitution comes out.
    """
    case = CentralImpact("thornton", 0.1, "steel", 5e-3)
    expected, began = case.predict().coefficient_of_restitution, monotonic()
    with TemporaryDirectory() as folder:
        try:
            found = case.run(folder, ranks=ranks).coefficient_of_restitution
        except (EngineError, ValueError) as error:
            raise Lacking(str(error), "a library of another version? build again") from None
        head = (Path(folder) / LOG).read_text(errors="replace").partition("\n")[0]
    if abs(found / expected - 1) > TOLERANCE:
        raise Lacking(
            f"restitution {found:.5f}, by theory {expected:.5f}",
            "the plugin is not that of this package; build again",
        )
    engine = head.removeprefix("LIGGGHTS (Version ").split(",")[0]
    return (
        f"{engine}: restitution {found:.5f}, by theory {expected:.5f}, "
        f"on {ranks} rank{'s' * (ranks > 1)}, in {monotonic() - began:.1f} s"
    )
