#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Follow docs/first_hour.md: its commands in its order, as a newcomer types them.

    tests/first_hour/follow.py             in this tree, as the page has them
    tests/first_hour/follow.py --brief     the hopper smaller, nothing installed: half a minute
    tests/first_hour/follow.py --chroot    in a new Debian 12, its base system alone, as root

A command that fails ends it with 1. Of the system this needs Python 3.11 alone, and `mmdebstrap`
for --chroot; the clean system fetches Debian's packages and Python's as the page says.
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

PROJECT = Path(__file__).resolve().parents[2]
PAGE = PROJECT / "docs" / "first_hour.md"
#: What a brief round changes in a command: a pattern, and what stands there instead.
BRIEF = {
    r"^\./run setup$": "true",
    r"--ranks 2": "--ranks 1",
    r"layers=9 frames=8": "layers=5 frames=2 orifice=8 duration=0.2 rows=48 filling=0.1",
}
#: How this machine reaches the network, which the new system needs too.
NETWORK = ("etc/resolv.conf", "etc/hosts", "etc/pip.conf", "etc/ssl/certs/ca-certificates.crt")
#: What the page promises, as files left behind.
LEFT = (
    "results/two_laws/impacts.csv",
    "results/two_laws/loops.png",
    "results/spring.in",
    "results/spring/impacts.csv",
    "results/hopper/checks.csv",
    "results/hopper/figures/ledger.png",
    "results/report.html",
)


def commands(page: Path = PAGE) -> list[str]:
    """The lines of the page's `sh` blocks, in order; one that ends with a backslash goes on."""
    blocks = re.findall(r"^```sh\n(.*?)^```", page.read_text(encoding="utf-8"), re.M | re.S)
    folded = "".join(blocks).replace("\\\n", "")
    return [" ".join(line.split()) for line in folded.splitlines() if line.strip()]


def script(lines: list[str], brief: bool) -> str:
    """One shell for all lines, as at a terminal, which shows each and stops at the first error."""
    if brief:
        for pattern, instead in BRIEF.items():
            lines = [re.sub(pattern, instead, line) for line in lines]
    typed = "\n".join(f"printf '\\n$ %s\\n' {quoted(line)}; {line}" for line in lines)
    left = "\n".join(f"test -s {quoted(name)}" for name in LEFT)
    return f"set -e\n{typed}\n{left}\n"


def quoted(text: str) -> str:
    """A word of the shell."""
    return "'" + text.replace("'", "'\\''") + "'"


def follow_here(brief: bool) -> int:
    """In this tree's environment, results in a folder that is gone afterwards."""
    with tempfile.TemporaryDirectory(prefix="first_hour_") as folder:
        for name in ("run", ".venv", "build"):
            (Path(folder) / name).symlink_to(PROJECT / name)
        return subprocess.run(["sh", "-c", script(commands(), brief)], cwd=folder).returncode


def follow_in_chroot(folder: Path) -> int:
    """In a new Debian 12, from a copy of the tree's tracked files.

    Raises:
        SystemExit: mmdebstrap is missing.
    """
    if not shutil.which("mmdebstrap"):
        raise SystemExit("mmdebstrap is missing: apt-get install mmdebstrap")
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
    """What a fresh login has, and how to reach the network where that is said by variables."""
    path = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
    names = ("http_proxy", "https_proxy", "no_proxy", "PIP_CERT", "PIP_INDEX_URL", "SSL_CERT_FILE")
    passed = {name: os.environ[name] for name in names if name in os.environ}
    return {"PATH": path, "HOME": "/root", "LANG": "C.UTF-8", **passed}


def main() -> int:
    """0 when every command of the page succeeded and left what it promises."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--brief", action="store_true", help="the hopper smaller, nothing installed"
    )
    parser.add_argument("--chroot", action="store_true", help="in a new Debian 12, as root")
    parser.add_argument("--folder", type=Path, help="where the new Debian is made, and stays")
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
