# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran completion`: script for command-line completion in a shell."""

from __future__ import annotations

import argparse
from pathlib import Path

import shtab

HELP = "print a script that completes commands, flags, choices and files in a shell"
EXAMPLE = """
plastigran completion bash >~/.local/share/bash-completion/completions/plastigran
plastigran completion zsh >~/.zfunc/_plastigran
"""


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument("shell", choices=shtab.SUPPORTED_SHELLS, help="name of the shell")


def run(arguments: argparse.Namespace) -> None:
    # Import here, because plastigran.cli imports this module.
    from plastigran.cli import parser

    top = parser()
    _complete_files(top)
    print(shtab.complete(top, arguments.shell))


def _complete_files(command: argparse.ArgumentParser) -> None:
    """Make the shell complete path arguments of a command and its subcommands as file names."""
    for action in command._actions:
        if isinstance(action, argparse._SubParsersAction):
            for below in action.choices.values():
                _complete_files(below)
        elif action.type is Path:
            action.complete = shtab.FILE
