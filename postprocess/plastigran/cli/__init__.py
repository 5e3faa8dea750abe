# SPDX-License-Identifier: GPL-2.0-or-later
"""The command `plastigran`: thin faces over functions a notebook can call."""

from __future__ import annotations

import argparse
import sys
from importlib import import_module
from pkgutil import iter_modules

from plastigran.cli import commands
from plastigran.engine.dumps import DumpError
from plastigran.engine.process import EngineError
from plastigran.experiments.collision import CollisionError


def parser() -> argparse.ArgumentParser:
    """One subcommand for each module of `commands`, which brings HELP, add_arguments and run."""
    top = argparse.ArgumentParser(
        prog="plastigran", description="Elasto-plastic contact laws for LIGGGHTS: runs and checks."
    )
    subcommands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for found in iter_modules(commands.__path__):
        module = import_module(f"{commands.__name__}.{found.name}")
        subcommand = subcommands.add_parser(found.name.replace("_", "-"), help=module.HELP)
        module.add_arguments(subcommand)
        subcommand.set_defaults(run=module.run)
    return top


def main(argv: list[str] | None = None) -> int:
    """Entry point; 0 when all went well, 1 after an error, whose one line goes to stderr."""
    try:
        arguments = parser().parse_args(argv)
    except (
        EngineError,
        ValueError,
    ) as error:  # the materials it lists
        print(f"plastigran: {error}", file=sys.stderr)
        return 1
    try:
        arguments.run(arguments)
    except BrokenPipeError:  # the reader of our output has had enough
        sys.stderr.close()
    except (EngineError, CollisionError, DumpError, ValueError, OSError) as error:
        print(f"plastigran: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt as stop:  # a command may say itself what is left
        output = getattr(arguments, "output", None)
        left = str(stop) or (output and f"the runs that finished are in {output}")
        print(f"plastigran: stopped{f'; {left}' if left else ''}", file=sys.stderr)
        return 130
    return 0
