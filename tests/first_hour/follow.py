#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Run the commands of docs/first_hour.md in their order.

    tests/first_hour/follow.py             in this project folder, unchanged
    tests/first_hour/follow.py --brief     with a smaller hopper, without installation: 30 s
    tests/first_hour/follow.py --chroot    in the base system of a new Debian 12, as root

The script ends with exit code 1 if a command fails. It needs only Python 3.11, and `mmdebstrap` for
--chroot. The new system downloads the packages of Debian and of Python as on the page.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from shlex import quote

PROJECT = Path(__file__).resolve().parents[2]
PAGE = PROJECT / "docs" / "first_hour.md"
#: Changes of the commands with --brief: patterns and their replacements.
BRIEF = {
    r"^\./run setup$": "true",
    r"--ranks 2": "--ranks 1",
    r"layers=9 frames=8": "layers=5 frames=2 orifice=8 duration=0.2 rows=48 filling=0.1",
}
#: Files of this machine with network settings that the new system needs, too.
NETWORK = ("etc/resolv.conf", "etc/hosts", "etc/pip.conf", "etc/ssl/certs/ca-certificates.crt")
#: Files that the commands must write.
RESULTS = (
    "results/two_laws/impacts.csv",
    "results/two_laws/loops.png",
    "results/spring.in",
    "results/spring/impacts.csv",
    "results/hopper/checks.csv",
    "results/hopper/figures/ledger.png",
    "results/report.html",
)


def commands(page: Path = PAGE) -> list[str]:
    """Return the lines of the page's `sh` blocks; a backslash at the end joins two lines."""
    blocks = re.findall(r"^```sh\n(.*?)^```", page.read_text(encoding="utf-8"), re.M | re.S)
    folded = "".join(blocks).replace("\\\n", "")
    return [" ".join(line.split()) for line in folded.splitlines() if line.strip()]


def script(lines: list[str], brief: bool) -> str:
    """Return a shell script that prints and runs each line and stops at the first error."""
    if brief:
        for pattern, replacement in BRIEF.items():
            lines = [re.sub(pattern, replacement, line) for line in lines]
    typed = "\n".join(f"printf '\\n$ %s\\n' {quote(line)}; {line}" for line in lines)
    checks = "\n".join(f"test -s {quote(name)}" for name in RESULTS)
    return f"set -e\n{typed}\n{checks}\n"


def follow_here(brief: bool) -> int:
    """Run the commands with this project's environment and build, in a temporary folder."""
    with tempfile.TemporaryDirectory(prefix="first_hour_") as folder:
        for name in ("run", ".venv", "build"):
            (Path(folder) / name).symlink_to(PROJECT / name)
        return subprocess.run(["sh", "-c", script(commands(), brief)], cwd=folder).returncode


def follow_in_chroot(folder: Path) -> int:
    """Run the commands in a new Debian 12, on a copy of the files that git tracks.

    Raises:
        SystemExit: mmdebstrap is missing.
    """
    if not shutil.which("mmdebstrap"):
        raise SystemExit("mmdebstrap is missing. Install it with `apt-get install mmdebstrap`")
    root = folder / "debian"
    subprocess.run(
        ["mmdebstrap", "--variant=minbase", "--include=ca-certificates", "bookworm", root],
        check=True,
    )
    home = root / "root" / "plastigran"
    home.mkdir()
    files = subprocess.run(
        ["git", "-C", PROJECT, "archive", "HEAD"], check=True, capture_output=True
    ).stdout
    subprocess.run(["tar", "-x", "-C", home], input=files, check=True)
    for name in NETWORK:
        if (Path("/") / name).exists():
            (root / name).unlink(missing_ok=True)
            shutil.copy(Path("/") / name, root / name)
    inside = "mount -t proc proc /proc; cd /root/plastigran\n" + script(commands(), brief=False)
    within = ["unshare", "--mount", "--pid", "--fork", "chroot", root, "sh", "-c", inside]
    return subprocess.run(within, env=clean_environment()).returncode


def clean_environment() -> dict[str, str]:
    """Return the variables of a new login, and those of the network."""
    path = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
    names = ("http_proxy", "https_proxy", "no_proxy", "PIP_CERT", "PIP_INDEX_URL", "SSL_CERT_FILE")
    passed = {name: os.environ[name] for name in names if name in os.environ}
    return {"PATH": path, "HOME": "/root", "LANG": "C.UTF-8", **passed}


def main() -> int:
    """Return 0 if every command of the page succeeded and wrote its files."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--brief", action="store_true", help="use a smaller hopper, and skip the installation"
    )
    parser.add_argument("--chroot", action="store_true", help="use a new Debian 12; needs root")
    parser.add_argument(
        "--folder", type=Path, help="new folder for the Debian system, which is not deleted"
    )
    arguments = parser.parse_args()
    if not arguments.chroot:
        return follow_here(arguments.brief)
    if arguments.folder:
        arguments.folder.mkdir(parents=True)
        return follow_in_chroot(arguments.folder)
    with tempfile.TemporaryDirectory(prefix="first_hour_") as folder:
        return follow_in_chroot(Path(folder))


if __name__ == "__main__":
    sys.exit(main())
