# SPDX-License-Identifier: GPL-2.0-or-later
"""A deck as it will run: the files it includes and the values of its settings."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from plastigran.engine.process import EngineError, inputs_folder

#: Files a deck includes at most: more are taken for one that includes itself.
MOST_FILES = 200
#: Endings of files that decks read beside scripts.
MESHES = (".stl", ".vtk")

_SETTING = re.compile(r'variable\s+(\w+)\s+index\s+(?:"([^"]*)"|(\S+))')
_VARIABLE = re.compile(r"variable\s+(\w+)")
_INCLUDE = re.compile(r"include\s+(\S+)")
_MESH = re.compile(rf"\bfile\s+(\S+(?:{'|'.join(map(re.escape, MESHES))}))(?!\S)", re.IGNORECASE)
_REFERENCE = re.compile(r"\$\{(\w+)\}")


def property_name(field: str) -> str:
    """What decks call a constant of the laws: yieldStrength for yield_strength."""
    first, *others = field.split("_")
    return first + "".join(word.capitalize() for word in others)


def commands(script: Path) -> Iterator[str]:
    """A script's commands, without empty lines and comments, which may be in any encoding."""
    for line in script.read_text(encoding="utf-8", errors="replace").splitlines():
        if command := line.split("#")[0].strip():
            yield command


def index_variable(command: str) -> tuple[str, str] | None:
    """Name and value of a `variable NAME index VALUE` command, None for another command."""
    if found := _SETTING.match(command):
        name, quoted, plain = found.groups()
        return name, quoted or plain or ""
    return None


def index_variables(deck: str | Path) -> dict[str, str]:
    """What a script's own `variable NAME index VALUE` lines say, as text.

    Args:
        deck: Path of the input script.
    """
    values: dict[str, str] = {}
    for name, value in index_lines(deck):
        values.setdefault(name, value)  # the engine keeps the first too
    return values


def index_lines(deck: str | Path) -> list[tuple[str, str]]:
    """Names and values of a script's own `variable NAME index VALUE` lines, one after the other."""
    return list(filter(None, map(index_variable, commands(Path(deck)))))


@dataclass(frozen=True)
class DeckSource:
    """A deck with what it includes.

    Attributes:
        path: The input script.
        files: The script, its includes, the meshes, and what else they read from the inputs.
        settings: Every setting of them with the value it will have.
        references: Names of the variables they read as ${name} and do not define.
    """

    path: Path
    files: list[Path]
    settings: dict[str, str]
    references: frozenset[str]

    @property
    def name(self) -> str:
        """Of the deck, `deck_name` of its script."""
        return deck_name(self.path)

    def resolve(self, text: str) -> str:
        """Words of a command with the settings' values in them."""
        return _with_values(text, self.settings)

    def copy(self, folder: Path) -> Path:
        """Copy the files into a folder: as they lie in the inputs, or below the script's folder;
        others by their names, with a number where another file has that name.

        Returns:
            The copied script; run it with `folder` for its inputs.
        """
        copied: dict[Path, Path] = {}
        for file in self.files:
            target = place = self._place(file)
            number = 1
            while copied.setdefault(target, file.resolve()) != file.resolve():
                number += 1
                target = place.with_stem(f"{place.stem}_{number}")
        for target, file in copied.items():
            (folder / target).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, folder / target)
        return folder / self._place(self.path)

    def _place(self, file: Path) -> Path:
        """Where a file lies in a copy, unless another has taken its place."""
        inputs = inputs_folder().resolve()
        if file.resolve().is_relative_to(inputs):
            return file.resolve().relative_to(inputs)
        if (plain := Path(os.path.normpath(file))).is_relative_to(self.path.parent):
            return plain.relative_to(self.path.parent)
        return Path(file.name)


def _with_values(text: str, settings: Mapping[str, str]) -> str:
    return _REFERENCE.sub(lambda m: settings.get(m[1], m[0]), text)


def _choice(include: str, settings: Mapping[str, str], deck: Path) -> str:
    """What the setting that names an include may be, in words; nothing where it names none."""
    names = [name for name in _REFERENCE.findall(include) if name not in ("inputs", "materials")]
    if len(names) != 1 or names[0] not in settings:
        return ""
    others = {key: value for key, value in settings.items() if key != names[0]}
    before, after = _with_values(include, others).split(f"${{{names[0]}}}", 1)
    start = deck.parent / before  # a folder, or the first letters of a name
    begins = "" if before.endswith("/") else start.name
    folder = start if before.endswith("/") else start.parent
    known = (file.name for file in folder.glob(f"{begins}*{after}"))
    words = sorted(name[len(begins) : len(name) - len(after)] for name in known)
    return f"; {names[0]} is {settings[names[0]]!r}, there are {', '.join(words)}" if words else ""


def deck_names() -> list[str]:
    """Names of the decks of `inputs/bulk`; none where there are no inputs."""
    try:
        return sorted(file.stem for file in (inputs_folder() / "bulk").glob("*.in"))
    except EngineError:
        return []


def deck_name(deck: str | Path) -> str:
    """What a deck is called: its script without the ending, `fall` for fall.in and in.fall."""
    path = Path(deck)
    return path.name.removeprefix("in.") if re.match(r"in\..", path.name) else path.stem


def is_shipped(script: Path) -> bool:
    """Whether a script, as `find_deck` gives it, is one of `inputs/bulk`."""
    return script.parent == (inputs_folder() / "bulk").resolve()


def find_deck(deck: str | Path) -> Path:
    """A deck of `inputs/bulk` by name, or any input script by its path.

    Raises:
        EngineError: There is none; the message lists those of `inputs/bulk`.
    """
    given = str(deck)
    shipped = inputs_folder() / "bulk" / f"{given}.in"
    is_path = os.sep in given or given.endswith(".in")
    for path in (Path(deck),) if is_path else (shipped, Path(deck)):
        if path.is_file():
            return path.resolve()
    if is_path:
        raise EngineError(f"no input script {given}")
    raise EngineError(f"no deck {given!r}; there are {', '.join(deck_names())}")


def read_deck(deck: str | Path, values: Mapping[str, object], folder: Path) -> DeckSource:
    """Read a deck with its includes as the engine will, from the deck's own folder.

    Includes whose names hold variables that are no settings are left to the engine.

    Args:
        deck: Name or path, as `find_deck` takes it.
        values: Settings given another value than the deck's.
        folder: Where results will go, the deck's `output`.

    Raises:
        EngineError: A file is missing.
        ValueError: A value for a setting the deck does not have.
    """
    path = find_deck(deck)
    given = {"inputs": str(inputs_folder()), "output": str(folder)}
    given |= {name: str(value) for name, value in values.items()}
    settings: dict[str, str] = {}
    files: list[Path] = []
    references: set[str] = set()
    defined: set[str] = set()

    def take_in(file: Path, included_by: str, choice: str = "") -> None:
        """The settings and files of a script and of those it includes, in the engine's order."""
        if not file.is_file():
            raise EngineError(f"{included_by} includes {file}, which is not there{choice}")
        if len(files) > MOST_FILES:
            raise EngineError(f"{included_by} includes {file}, and so on: does it include itself?")
        files.append(file)
        for command in commands(file):
            references.update(_REFERENCE.findall(command))
            defined.update(_VARIABLE.findall(command))
            if setting := index_variable(command):
                name, value = setting
                settings.setdefault(name, given.get(name, _with_values(value, settings)))
            elif found := _INCLUDE.match(command):
                if not _REFERENCE.search(included := _with_values(found[1], settings)):
                    take_in(path.parent / included, file.name, _choice(found[1], settings, path))
            else:
                named = (word for word in command.split() if "${inputs}" in word)
                read = [path.parent / _with_values(word, settings) for word in named]
                if found := _MESH.search(command):
                    read.append(path.parent / _with_values(found[1], settings))
                files.extend(file for file in read if file.is_file())

    take_in(path, "")
    references -= defined
    if unknown := sorted(set(given) - set(settings) - references - {"inputs", "output"}):
        none = "has none: a setting is a line `variable NAME index VALUE`"
        known = f"takes {' '.join(settings)}" if settings else none
        raise ValueError(f"{path.name} has no setting {unknown[0]!r}; it {known}")
    return DeckSource(path, files, settings, frozenset(references))
