# SPDX-License-Identifier: GPL-2.0-or-later
"""The command `plastigran`: thin faces over functions a notebook can call."""

from __future__ import annotations

import argparse
import sys
import warnings
from importlib import import_module
from pkgutil import iter_modules

from plastigran.cli import commands
from plastigran.cli.experiments import add_command
from plastigran.engine.dumps import DumpError
from plastigran.engine.process import EngineError
from plastigran.experiments import find_experiments


def parser(wanted: str = "") -> argparse.ArgumentParser:
    """A subcommand for each experiment, made from what it says of itself, and for each module of
    `commands`, which brings HELP, add_arguments and run; `wanted` alone where that is one of them,
    for many are slow to load."""
    top = argparse.ArgumentParser(
        prog="plastigran", description="Elasto-plastic contact laws for LIGGGHTS: runs and checks."
    )
    subcommands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    modules = {
        found.name.replace("_", "-"): found.name for found in iter_modules(commands.__path__)
    }
    experiments = {} if wanted in modules else find_experiments()
    names = {*modules, *experiments}
    for name in {wanted} & names or sorted(names):
        if name in experiments:
            add_command(subcommands, experiments[name])
            continue
        module = import_module(f"{commands.__name__}.{modules[name]}")
        subcommand = subcommands.add_parser(name, help=module.HELP)
        module.add_arguments(subcommand)
        subcommand.set_defaults(run=module.run)
    return top


def main(argv: list[str] | None = None) -> int:
    """Entry point; 0 when all went well, 1 after an error, whose one line goes to stderr."""
    words = sys.argv[1:] if argv is None else argv
    arguments = parser(*words[:1]).parse_args(words)
    try:
        with warnings.catch_warnings():
            warnings.showwarning = lambda said, *_, **__: print(
                f"plastigran: {said}", file=sys.stderr
            )
            arguments.run(arguments)
    except BrokenPipeError:  # the reader of our output has had enough
        sys.stderr.close()
    except (EngineError, DumpError, ValueError, OSError) as error:
        print(f"plastigran: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt as stop:  # a command may say itself what is left
        output = getattr(arguments, "output", None)
        left = str(stop) or (output and f"the runs that finished are in {output}")
        print(f"plastigran: stopped{f'; {left}' if left else ''}", file=sys.stderr)
        return 130
    return 0
