# SPDX-License-Identifier: GPL-2.0-or-later
"""Build upstream LIGGGHTS while other tests run; the tests that need it come last."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
from pathlib import Path

import pytest
from engine_laws import IN_TREE_LAWS

HERE = Path(__file__).parent
#: Command that builds upstream LIGGGHTS with some laws of this project.
BUILD = (HERE / "build_upstream.sh", HERE.parents[1] / "build/in-tree", *IN_TREE_LAWS)


@pytest.fixture(scope="session")
def in_tree():
    """Program: upstream LIGGGHTS, built with some laws of this project in its source tree."""
    if not shutil.which("apt-get"):
        pytest.skip("apt-get is missing; it downloads the source package of LIGGGHTS from Debian")
    build = subprocess.run(BUILD, capture_output=True, text=True)
    assert build.returncode == 0, build.stderr[-10000:]
    return build.stdout.splitlines()[-1]


@pytest.hookimpl(trylast=True)  # after tests are selected
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    waiting = [item for item in items if "in_tree" in getattr(item, "fixturenames", ())]
    if not waiting:
        return
    items[:] = [item for item in items if item not in waiting] + waiting
    first_worker = os.environ.get("PYTEST_XDIST_WORKER", "gw0") == "gw0"
    if first_worker and not config.option.collectonly:
        _begin(config)


def _begin(config: pytest.Config) -> None:
    """Start the build at low priority; stop it at the end of the tests."""
    build = subprocess.Popen(
        ["nice", "-n", "10", *BUILD],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,  # tests repeat and quote a failed build
        process_group=0,
    )

    def end() -> None:
        if build.poll() is None:
            os.killpg(build.pid, signal.SIGTERM)
            build.wait()

    config.add_cleanup(end)
