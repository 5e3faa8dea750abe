# SPDX-License-Identifier: GPL-2.0-or-later
"""Commands of the command line: all of them, and their exit code."""

from __future__ import annotations

import argparse

from plastigran.cli import main


def all_commands(command: argparse.ArgumentParser) -> list[argparse.ArgumentParser]:
    """Return the parsers of all commands; subcommands replace the command that contains them."""
    for action in command._actions:
        if isinstance(action, argparse._SubParsersAction):
            return [found for below in action.choices.values() for found in all_commands(below)]
    return [command]


def exit_code(line: str | list[str]) -> int:
    """Run a command line; return the exit code, also if argparse refuses the line."""
    try:
        return main(line.split() if isinstance(line, str) else line)
    except SystemExit as stop:
        return stop.code
