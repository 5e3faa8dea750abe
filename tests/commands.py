# SPDX-License-Identifier: GPL-2.0-or-later
"""The commands of the command line, found and never listed."""

from __future__ import annotations

import argparse


def all_commands(command: argparse.ArgumentParser) -> list[argparse.ArgumentParser]:
    """Every command that is run, of subcommands their own."""
    for action in command._actions:
        if isinstance(action, argparse._SubParsersAction):
            return [found for below in action.choices.values() for found in all_commands(below)]
    return [command]
