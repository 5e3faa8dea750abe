# SPDX-License-Identifier: GPL-2.0-or-later
"""The commands of the page "The first hour" work as written."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import follow
import pytest

from plastigran.engine.process import PROJECT

FOLLOW = PROJECT / "tests" / "first_hour" / "follow.py"


@pytest.mark.engine
def test_the_first_hour_briefly():
    """The test runs all commands except the installation, with a small hopper."""
    done = subprocess.run(
        [sys.executable, FOLLOW, "--brief"], capture_output=True, text=True, timeout=900
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    page = (PROJECT / "docs" / "first_hour.md").read_text()
    for line in re.findall(r"^ +steel +\w+ +\S+ +\S+ +(\S+)", page, re.MULTILINE):
        assert line in done.stdout  # LIGGGHTS computes the restitutions of the page


def test_the_page_installs_first_and_shows_every_kind_of_run():
    lines = follow.commands()
    assert lines[:2] == ["./run setup", ". .venv/bin/activate"]
    commands = {words[1] for words in map(str.split, lines) if words[0] == "plastigran"}
    assert {"impact", "calibrate", "bulk", "snapshot", "report"} <= commands


def test_the_page_has_the_patterns_of_a_brief_round():
    text = "\n".join(follow.commands())
    assert all(re.search(pattern, text, re.MULTILINE) for pattern in follow.BRIEF)


def test_a_failing_command_ends_the_script(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("```sh\ntrue\nfalse\n```\n\n```\nnot a command\n```\n")
    lines = follow.commands(page)
    assert lines == ["true", "false"]
    assert subprocess.run(["sh", "-c", follow.script(lines, True)], cwd=Path(tmp_path)).returncode
