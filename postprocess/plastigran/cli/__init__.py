# SPDX-License-Identifier: GPL-2.0-or-later
"""Command-line interface `plastigran`; every command calls functions of the Python package."""

from __future__ import annotations

import argparse
import sys
import traceback
import warnings
from collections.abc import Callable
from errno import EDQUOT, EFBIG, ENOSPC
from importlib import import_module
from importlib.metadata import version
from pathlib import Path
from pkgutil import iter_modules

from plastigran.cli import commands
from plastigran.cli.arguments import add_subcommand, add_verbose
from plastigran.cli.experiments import add_command
from plastigran.engine.dumps import DumpError
from plastigran.engine.process import EngineError
from plastigran.experiments import find_experiments

#: Exit codes of the command.
EXIT_CODES = {
    0: "success",
    1: "error in a value, a file or LIGGGHTS, or a failed check; see stderr",
    2: "invalid command line",
    70: "internal error of plastigran; --verbose prints the Python traceback",
    130: "stopped by Ctrl-C or SIGTERM; finished results are kept",
}


def parser(wanted: str = "") -> argparse.ArgumentParser:
    """Return the command-line parser.

    The parser has one subcommand for each experiment and for each module of `commands`. Each such
    module provides HELP, EXAMPLE, add_arguments and run. If `wanted` is the name of a subcommand,
    the parser has only this subcommand, because many modules are slow to load.
    """
    listed = "\n".join(f"  {code:<4d}{meaning}" for code, meaning in EXIT_CODES.items())
    top = argparse.ArgumentParser(
        prog="plastigran",
        description="Run, check and calibrate elasto-plastic contact laws for LIGGGHTS.",
        epilog=f"exit codes:\n{listed}\n\nplastigran COMMAND --help shows an example.",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    top.add_argument("--version", action="version", version=f"plastigran {version('plastigran')}")
    add_verbose(top, False)
    subparsers = top.add_subparsers(
        dest="command", required=True, metavar="COMMAND", title="commands"
    )
    modules = {
        module.name.replace("_", "-"): module.name for module in iter_modules(commands.__path__)
    }
    experiments = {} if wanted in modules else find_experiments()
    names = {*modules, *experiments}
    for name in {wanted} & names or sorted(names):
        if name in experiments:
            add_command(subparsers, experiments[name])
            continue
        module = import_module(f"{commands.__name__}.{modules[name]}")
        command = add_subcommand(subparsers, name, module.HELP, module.EXAMPLE)
        module.add_arguments(command)
        command.set_defaults(run=module.run)
    return top


def main(argv: list[str] | None = None) -> int:
    """Run the command; return one of `EXIT_CODES`. Errors are printed as one line on stderr."""
    words = sys.argv[1:] if argv is None else argv
    arguments = parser(*words[:1]).parse_args(words)
    try:
        with warnings.catch_warnings():
            warnings.showwarning = _print_once()
            arguments.run(arguments)
    except BrokenPipeError:  # the program that reads the output, such as `head`, has ended
        sys.stderr.close()
    except KeyboardInterrupt as stop:  # the text of the exception, if any, names the kept results
        output = getattr(arguments, "output", None)
        results = str(stop) or (output and f"finished runs are in {output}")
        print(f"plastigran: stopped{f'; {results}' if results else ''}", file=sys.stderr)
        return 130
    except Exception as error:
        return _report(error, arguments)
    return 0


def _print_once() -> Callable[..., None]:
    """Return a function that prints a warning unless it has printed the same text before.

    The filters of Python do not suffice: they show a warning again after a library has changed
    them.
    """
    shown = set()

    def show(warning: Warning, *_: object, **__: object) -> None:
        if (text := str(warning)) not in shown:
            shown.add(text)
            print(f"plastigran: {text}", file=sys.stderr)

    return show


def _report(error: Exception, arguments: argparse.Namespace) -> int:
    """Print an error in one line, after the traceback if --verbose is set; return the exit code."""
    if arguments.verbose:
        traceback.print_exception(error)
    if isinstance(error, EngineError | DumpError | ValueError | OSError):
        print(f"plastigran: {_message(error, arguments)}", file=sys.stderr)
        return 1
    advice = "Please" if arguments.verbose else "Repeat the command with --verbose and"
    print(
        f"plastigran: internal error, {type(error).__name__}: {error}. {advice} report the output",
        file=sys.stderr,
    )
    return 70


def _message(error: Exception, arguments: argparse.Namespace) -> str:
    """Return the message of an error. For an OSError, the message names the file or folder."""
    if isinstance(error, FileNotFoundError) and error.filename:
        return f"the file {error.filename} does not exist"
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {error.strerror}"
    if isinstance(error, OSError) and error.errno in (EFBIG, ENOSPC, EDQUOT):
        place = getattr(arguments, "output", None) or Path.cwd()
        return (
            f"cannot write a file in {place}: {error.strerror}. Free space there, or raise the "
            "limit of file sizes (`ulimit -f`)"
        )
    return str(error)
