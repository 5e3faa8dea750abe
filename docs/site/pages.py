# SPDX-License-Identifier: GPL-2.0-or-later
"""Generate pages of the site from the code: commands, Python modules and headers of the laws."""

from __future__ import annotations

import os
import re
from argparse import ArgumentParser, _SubParsersAction
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules, walk_packages

import plastigran
from plastigran import laws
from plastigran.cli import parser
from plastigran.engine.deck import property_name

PROJECT = Path(__file__).resolve().parents[2]
HEADERS = PROJECT / "contact_models" / "plastigran"


def write_pages(folder: Path, write: Callable[[Path, str], None]) -> list[Path]:
    """Write all pages that are generated from the code, and return their paths.

    Args:
        folder: Folder of all pages. The generated pages go to its subfolder `reference`.
        write: Function `write(path, text)`.
    """
    texts = {"commands.md": commands()}
    for room in rooms():
        texts[f"python/{room}.rst"] = room_page(room)
    for header in sorted(HEADERS.rglob("*.h")):
        texts[f"cpp/{header.relative_to(HEADERS).with_suffix('.md')}"] = header_page(header)
    paths = {folder / "reference" / name: text for name, text in texts.items()}
    for path, text in paths.items():
        write(path, text)
    return list(paths)


def commands() -> str:
    """Return the page with the help of every command."""
    os.environ["COLUMNS"] = "92"  # width at which argparse wraps lines
    lines = ["# Commands", "", "The output of `plastigran COMMAND --help`.", ""]
    return "\n".join([*lines, *_subcommands(parser(), "##")])


def _subcommands(above: ArgumentParser, mark: str) -> Iterator[str]:
    """Yield the lines on the subcommands of a command. `mark` is the prefix of their headings."""
    for action in above._actions:
        if isinstance(action, _SubParsersAction):
            helps = {choice.dest: choice.help for choice in action._choices_actions}
            for name, command in sorted(action.choices.items()):
                title = command.prog.partition(" ")[2]
                yield from (f"{mark} {title}", "", _sentence(helps.get(name) or name), "")
                yield from ("```text", command.format_help().rstrip(), "```", "")
                yield from _subcommands(command, f"{mark}#")


def rooms() -> list[str]:
    """Return the modules and packages directly in `plastigran`, without the command line."""
    found = [module.name for module in iter_modules(plastigran.__path__)]
    return sorted({*found, "laws"} - {"cli"})


def room_page(room: str) -> str:
    """Return the page with the docstrings of a package and its modules."""
    name = f"plastigran.{room}"
    module = import_module(name)
    inside = walk_packages(getattr(module, "__path__", []), f"{name}.")
    lines = [f"``{name}``", "=" * (len(name) + 4), ""]
    for found in [name, *sorted(part.name for part in inside)]:
        if found != name:
            lines += [found, "-" * len(found), ""]
        lines += [f".. automodule:: {found}", "   :members:", ""]
    return "\n".join(lines)


def header_page(header: Path) -> str:
    """Return the page of a law's header: its first comment, constants, options and code."""
    place = header.relative_to(HEADERS)
    text = header.read_text()
    lines = [f"# {place}", "", f'`#include "plastigran/{place}"`', ""]
    head = re.match(r"// SPDX[^\n]*\n//\n((?://[^\n]*\n)+)", text)
    if head:
        comment = "\n".join(line[2:].removeprefix(" ") for line in head[1].splitlines())
        lines += ["```text", comment, "```", ""]
    name = header.stem
    if place.parts[0] == "laws" and name in laws.LAWS:
        lines += [f"[Equations, limits, how good it is](../../../laws/{name}.md)", ""]
        lines += _law_tables(laws.LAWS[name])
    depth = "../" * (len(place.parts) + 2)
    lines += ["## Code", "", f"[{place}]({depth}contact_models/plastigran/{place})", ""]
    lines += ["```cpp", text.rstrip(), "```", ""]
    return "\n".join(lines)


def _law_tables(law: type) -> list[str]:
    lines = []
    if law.parameters():
        lines += [
            "| constant | in decks | unit | default | allowed | |",
            "|---|---|---|---|---|---|",
        ]
        for p in law.parameters():
            default = "must be given" if p["default"] is None else f"{p['default']:g}"
            lines.append(
                f"| `{p['name']}` | `{property_name(p['name'])}` | {p['unit']} | {default} "
                f"| {p['lower']:g} to {p['upper']:g} | {p['meaning']} |"
            )
        lines.append("")
    if law.options():
        lines += ["| option | choices | default | |", "|---|---|---|---|"]
        for o in law.options():
            choices = ", ".join(f"`{choice}`" for choice in o["choices"])
            lines.append(f"| `{o['name']}` | {choices} | `{o['default']}` | {o['meaning']} |")
        lines.append("")
    return lines


def _sentence(text: str) -> str:
    return text[0].upper() + text[1:] + "."
