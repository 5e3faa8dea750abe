# SPDX-License-Identifier: GPL-2.0-or-later
"""Read a deck with its included files and the values of its settings, as LIGGGHTS will run it."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from plastigran.engine.process import EngineError, inputs_folder

#: Largest number of files of a deck. If a deck has more files, one of them may include itself.
MOST_FILES = 200
#: Suffixes of mesh files.
MESHES = (".stl", ".vtk")

_SETTING = re.compile(r'variable\s+(\w+)\s+index\s+(?:"([^"]*)"|(\S+))')
_VARIABLE = re.compile(r"variable\s+(\w+)")
_INCLUDE = re.compile(r"include\s+(\S+)")
_MESH = re.compile(rf"\bfile\s+(\S+(?:{'|'.join(map(re.escape, MESHES))}))(?!\S)", re.IGNORECASE)
_REFERENCE = re.compile(r"\$\{(\w+)\}")


def property_name(field: str) -> str:
    """Return the name of a law constant in decks: yieldStrength for yield_strength."""
    first, *others = field.split("_")
    return first + "".join(word.capitalize() for word in others)


def commands(script: Path) -> Iterator[str]:
    """Return the commands of a script without empty lines and comments."""
    for line in script.read_text(encoding="utf-8", errors="replace").splitlines():
        if command := line.split("#")[0].strip():
            yield command


def index_variable(command: str) -> tuple[str, str] | None:
    """Return name and value of a `variable NAME index VALUE` command; None for others."""
    if match := _SETTING.match(command):
        name, quoted, plain = match.groups()
        return name, quoted or plain or ""
    return None


def index_variables(deck: str | Path) -> dict[str, str]:
    """Return the index variables that a script defines, as text; included files are not read."""
    values: dict[str, str] = {}
    for name, value in index_lines(deck):
        values.setdefault(name, value)  # keep the first value, as LIGGGHTS does
    return values


def index_lines(deck: str | Path) -> list[tuple[str, str]]:
    """Return names and values of the index variables in a script; included files are not read."""
    return list(filter(None, map(index_variable, commands(Path(deck)))))


@dataclass(frozen=True)
class DeckSource:
    """Deck with its included files.

    Attributes:
        path: Path of the input script.
        files: Paths of the script, of its included files, of meshes and of other input files.
        settings: Values of all settings, which are the variables that the deck defines with
            `variable NAME index VALUE`.
        references: Names of variables that the deck uses as ${name} but does not define.
    """

    path: Path
    files: list[Path]
    settings: dict[str, str]
    references: frozenset[str]

    @property
    def name(self) -> str:
        """Name of the deck, see `deck_name`."""
        return deck_name(self.path)

    def resolve(self, text: str) -> str:
        """Return a command in which the value of each setting replaces ${name}."""
        return _with_values(text, self.settings)

    def copy(self, folder: Path) -> Path:
        """Copy the files into a folder and return the copied script.

        Files in the folder of inputs or in the folder of the script keep their relative paths.
        Other files are copied by name, with a number if the name is taken. Run the copy with
        `folder` as its folder of inputs.
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
        """Return the relative path of a file in a copy of the deck."""
        inputs = inputs_folder().resolve()
        if file.resolve().is_relative_to(inputs):
            return file.resolve().relative_to(inputs)
        if (plain := Path(os.path.normpath(file))).is_relative_to(self.path.parent):
            return plain.relative_to(self.path.parent)
        return Path(file.name)


def _with_values(text: str, settings: Mapping[str, str]) -> str:
    return _REFERENCE.sub(lambda m: settings.get(m[1], m[0]), text)


def _possible_values(include: str, settings: Mapping[str, str], deck: Path) -> str:
    """Return a hint for a missing included file whose name contains a setting.

    For `include ${material}.in`, the hint lists the values of `material` for which a file exists.
    The hint is empty if the name does not contain exactly one setting.
    """
    names = [name for name in _REFERENCE.findall(include) if name not in ("inputs", "materials")]
    if len(names) != 1 or names[0] not in settings:
        return ""
    (name,) = names
    others = {key: value for key, value in settings.items() if key != name}
    before, after = _with_values(include, others).split(f"${{{name}}}", 1)
    folder, prefix = os.path.split(os.path.join(deck.parent, before))
    files = (file.name for file in Path(folder).glob(f"{prefix}*{after}"))
    words = sorted(file.removeprefix(prefix).removesuffix(after) for file in files)
    if not words:
        return ""
    return f"; {name} is {settings[name]!r}, possible values are {', '.join(words)}"


def deck_names() -> list[str]:
    """Return the names of the decks of `inputs/bulk`."""
    try:
        return sorted(file.stem for file in (inputs_folder() / "bulk").glob("*.in"))
    except EngineError:
        return []


def deck_name(deck: str | Path) -> str:
    """Return the name of a deck: `fall` for fall.in and in.fall."""
    path = Path(deck)
    return path.name.removeprefix("in.") if re.match(r"in\..", path.name) else path.stem


def is_supplied(script: Path) -> bool:
    """Return whether an input script, a result of `find_deck`, is a deck of `inputs/bulk`."""
    return script.parent == (inputs_folder() / "bulk").resolve()


def find_deck(deck: str | Path) -> Path:
    """Return a deck of `inputs/bulk` by name, or an input script by its path.

    Raises:
        EngineError: The deck does not exist; the message lists the decks of `inputs/bulk`.
    """
    name = str(deck)
    is_path = os.sep in name or name.endswith(".in")
    supplied = [] if is_path else [inputs_folder() / "bulk" / f"{name}.in"]
    for path in (*supplied, Path(deck)):
        if path.is_file():
            return path.resolve()
    if is_path:
        raise EngineError(f"the input script {name} does not exist")
    raise EngineError(f"no deck {name!r}. Available decks: {', '.join(deck_names())}")


def read_deck(deck: str | Path, values: Mapping[str, object], folder: Path) -> DeckSource:
    """Read a deck with its includes, as LIGGGHTS reads them in the folder of the deck.

    An included file is not read if its name contains a variable that is not a setting.

    Args:
        deck: Name or path, see `find_deck`.
        values: Settings to override.
        folder: Folder of the results, the value of the deck variable `output`.

    Raises:
        EngineError: A file is missing, or the deck includes too many files.
        ValueError: A value is given for a setting that the deck does not have.
    """
    path = find_deck(deck)
    overrides = {"inputs": str(inputs_folder()), "output": str(folder)}
    overrides |= {name: str(value) for name, value in values.items()}
    settings: dict[str, str] = {}
    files: list[Path] = []
    references: set[str] = set()
    defined: set[str] = set()

    def read(file: Path, included_by: str, hint: str = "") -> None:
        """Collect the settings and files of a script and its includes, in the order of LIGGGHTS."""
        if not file.is_file():
            if (inputs_folder() / file.name).is_file():
                hint = f". Write `include ${{inputs}}/{file.name}`"
            raise EngineError(f"{included_by} includes {file}, which does not exist{hint}")
        if len(files) > MOST_FILES:
            raise EngineError(
                f"the deck includes more than {MOST_FILES} files; {included_by} includes {file}. "
                "Check whether a file includes itself"
            )
        files.append(file)
        for command in commands(file):
            references.update(_REFERENCE.findall(command))
            defined.update(_VARIABLE.findall(command))
            if setting := index_variable(command):
                name, value = setting
                settings.setdefault(name, overrides.get(name, _with_values(value, settings)))
            elif include := _INCLUDE.match(command):
                name = _with_values(include[1], settings)
                if not _REFERENCE.search(name):
                    hint = _possible_values(include[1], settings, path)
                    read(path.parent / name, file.name, hint)
            else:
                names = [word for word in command.split() if "${inputs}" in word]
                if mesh := _MESH.search(command):
                    names.append(mesh[1])
                others = (path.parent / _with_values(name, settings) for name in names)
                files.extend(other for other in others if other.is_file())

    read(path, "")
    references -= defined
    if unknown := sorted(set(overrides) - set(settings) - references - {"inputs", "output"}):
        none = "has none. A setting is a line `variable NAME index VALUE`"
        possible = f"has {', '.join(settings)}" if settings else none
        raise ValueError(f"{path.name} has no setting {unknown[0]!r}; the deck {possible}")
    return DeckSource(path, files, settings, frozenset(references))
