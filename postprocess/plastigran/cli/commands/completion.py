# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran completion`: what a shell completes after `plastigran`."""

from __future__ import annotations

import argparse
from pathlib import Path

import shtab

HELP = "print what makes a shell complete commands, flags, their choices and files"
EXAMPLE = """
plastigran completion bash >~/.local/share/bash-completion/completions/plastigran
plastigran completion zsh >~/.zfunc/_plastigran
"""


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument("shell", choices=shtab.SUPPORTED_SHELLS, help="the shell it is for")


def run(arguments: argparse.Namespace) -> None:
    from plastigran.cli import parser  # it holds this command

    top = parser()
    _complete_files(top)
    print(shtab.complete(top, arguments.shell))


def _complete_files(command: argparse.ArgumentParser) -> None:
    """Let arguments that are paths be completed as such, in a command and those below it."""
    for action in command._actions:
        if isinstance(action, argparse._SubParsersAction):
            for below in action.choices.values():
                _complete_files(below)
        elif action.type is Path:
            action.complete = shtab.FILE
