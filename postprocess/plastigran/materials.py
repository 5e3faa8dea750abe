# SPDX-License-Identifier: GPL-2.0-or-later
"""Materials: one file each in `inputs/materials`, which the decks include and Python reads.

An installed package carries these files; $PLASTIGRAN_INPUTS or a path names files of one's own, in
the same form.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import attrs

from plastigran import laws
from plastigran.declared import Declaration, declaration, number
from plastigran.engine.deck import commands, index_lines, index_variable
from plastigran.engine.process import EngineError, inputs_folder, own_inputs

if TYPE_CHECKING:
    import pandas as pd

#: A wall that neither deforms nor yields.
RIGID = laws.Body(1e30, 0.3, 1e30, 1.61)

#: What tables and folders say of a wall that is `RIGID`, of one that is not there, and of options
#: as they are by default: no material is named so.
RIGID_WALL, NO_WALL, USUAL = TAKEN = "rigid", "none", "default"
#: Names that materials may have.
_NAME = re.compile(r"\w([\w .+-]*[\w.+-])?")

#: Constants of a body in contact, as `laws.Body` takes them.
OF_BODY = (
    "youngs_modulus",
    "poissons_ratio",
    "yield_strength",
    "yield_pressure_factor",
    "tangent_modulus",
    "rate_coefficient",
    "reference_rate",
)


@attrs.frozen
class Material:
    """Bulk constants of one material.

    Raises:
        ValueError: A constant is no number or out of range; the message names it and the range.
    """

    name: str
    youngs_modulus: float = number("Young's modulus", "Pa", 0)
    poissons_ratio: float = number("Poisson's ratio", "-", -1, 0.5, closed=True)
    density: float = number("density", "kg/m^3", 0)
    yield_strength: float = number("uniaxial yield strength, 1e30 for none", "Pa", 0)
    yield_pressure_factor: float = number(
        "contact yield pressure over yield strength, 0 for the Hertz-von Mises value",
        lower=0, upper=10, closed=True, default=0.0,
    )  # fmt: skip
    tangent_modulus: float = number(
        "slope of stress over total strain beyond yield, 0 for perfectly plastic, less than "
        "Young's modulus", "Pa", 0, closed=True, default=0.0,
    )  # fmt: skip
    rate_coefficient: float = number(
        "share of the yield strength that a factor e in rate of strain adds", "-", 0, 1, True, 0.0
    )
    reference_rate: float = number(
        "rate of strain at which the yield strength holds", "1/s", 0, default=1.0
    )
    dissipative_constant: float | None = number(
        "viscous over elastic constants A", "s", 0, closed=True, default=None
    )

    def __attrs_post_init__(self) -> None:
        _check_name(self.name)
        self.body()

    def variables(self, suffix: str = "") -> dict[str, float]:
        """The constants as the decks' variables of the same names, those that are given; with a
        suffix to the names, those that a body beside the particles needs.
        """
        if suffix:
            return {f"{name}{suffix}": getattr(self, name) for name in OF_BODY}
        return attrs.asdict(self, filter=lambda at, value: at.name != "name" and value is not None)

    def missing(self, law: str) -> list[str]:
        """Names of the constants a law must be given and this material does not have."""
        return [name for name in _needed(law) if getattr(self, name, None) is None]

    def law(self, name: str, pair: laws.MaterialPair, **others: float | str):
        """A law for contacts of this material, with those of its constants that have no default.

        Args:
            name: Of the law.
            pair: The two bodies.
            others: Constants that are not the material's, such as lengths of the bodies; options.

        Raises:
            ValueError: The material lacks a constant, or one is out of range; the message names it.
        """
        given = {key: getattr(self, key, None) for key in _needed(name)} | others
        if missing := [key for key, value in given.items() if value is None]:
            raise ValueError(f"material {self.name} gives no {', '.join(missing)}; {name} needs it")
        return laws.LAWS[name](pair, **given)

    def body(self) -> laws.Body:
        """The constants as the laws take them."""
        return laws.Body(*(getattr(self, name) for name in OF_BODY))


def _check_name(name: object) -> None:
    """Refuse a material's name that tables or folders could not have."""
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise ValueError(
            f"name is {name!r}; it must be letters, digits, spaces and _ . + -, "
            "the first a letter, digit or _"
        )
    if name in TAKEN:
        raise ValueError(f"name is {name!r}; {', '.join(TAKEN)} have another meaning in tables")


def _needed(law: str) -> list[str]:
    table = laws.LAWS[law].parameters()
    return [row["name"] for row in table if row["default"] is None and not row["per_body"]]


def folder() -> Path:
    """Where materials are looked for by name."""
    try:
        named = inputs_folder() / "materials"
    except EngineError:  # materials are there without decks
        named = own_inputs() / "materials"
    return named if named.is_dir() else own_inputs() / "materials"


def names() -> list[str]:
    """Names of the materials at hand."""
    return sorted(file.stem for file in folder().glob("*.in"))


def table() -> pd.DataFrame:
    """The materials at hand: one row each, by name; a column for each constant, in SI units.

    Raises:
        ValueError: A file cannot be read.
    """
    import pandas as pd  # slow to load

    return pd.DataFrame([attrs.asdict(read_material(name)) for name in names()]).set_index("name")


def read_material(name: Material | str | Path) -> Material:
    """Read a material by name, or from a file of the same form given by its path.

    A material itself is handed back.

    Raises:
        ValueError: It is none of these, there is no such material, or a constant is missing,
            unknown, given twice, not a number or out of range.
    """
    if isinstance(name, Material):
        return name
    if not isinstance(name, str | Path):
        raise ValueError(f"{name!r} is no material; it must be a Material, a name or a path")
    path = Path(name)
    if path.suffix == ".in" and not path.is_file():
        raise ValueError(f"no file {path}; materials known by name are {', '.join(names())}")
    if path.suffix != ".in":
        path = folder() / f"{name}.in"
    if not path.is_file():
        file = Path(f"{name}.in")
        hint = f"is it {file}? " if file.is_file() else ""
        raise ValueError(f"no material {str(name)!r}; {hint}there are {', '.join(names())}")
    try:
        lines = index_lines(path)
    except UnicodeDecodeError:
        raise ValueError(f"{path} is not a text file") from None
    _check_lines(path)
    values = dict(lines)
    if len(values) < len(lines):
        names_given = [each for each, _ in lines]
        twice = next(each for each in names_given if names_given.count(each) > 1)
        raise ValueError(f"{path}: {twice} is given twice")
    constants = attrs.fields(Material)[1:]
    if missing := [at.name for at in constants if at.name not in values and _required(at)]:
        raise ValueError(f"{path}: no value for {', '.join(missing)}")
    if unknown := sorted(values.keys() - {at.name for at in constants}):
        known = ", ".join(at.name for at in constants)
        raise ValueError(f"{path}: {unknown[0]} is no constant of a material; there are {known}")
    given = {at.name: values[at.name] for at in constants if at.name in values}
    try:
        return Material(path.stem, **given)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error


def _check_lines(file: Path) -> None:
    """Refuse commands that the engine would run and this would not read."""
    for command in commands(file):
        if "\ufeff" in command:
            raise ValueError(f"{file} begins with a byte order mark; save it as UTF-8 without one")
        if len(command.split()) != 4 or not index_variable(command):
            raise ValueError(f"{file}: {command!r} must be variable NAME index VALUE")


def material_lines(material: Material) -> str:
    """The constants that are given, as lines of a material's file."""
    units = {name: said.unit for name, said in declaration(Material).items()}
    return "\n".join(
        f"variable {name:22s} index {value:<18.12g} # {units[name]}"
        for name, value in material.variables().items()
    )


def write_material(material: Material, file: Path, remark: str, force: bool = False) -> None:
    """Write a material as a file that decks include and `read_material` takes.

    Args:
        material: What to write.
        file: Path that ends in .in; its folder is there.
        remark: Where the constants are from, a line.
        force: Overwrite the file.

    Raises:
        ValueError: The path does not end in .in.
        FileExistsError: The file is there, and may not be overwritten.
        FileNotFoundError: Its folder is not there.
    """
    check_material_file(file, force)
    file.write_text(f"# {remark}\n{material_lines(material)}\n", encoding="utf-8")


def check_material_file(file: Path, force: bool = False) -> None:
    """Refuse what `write_material` refuses, before the material is known."""
    if file.suffix != ".in":
        raise ValueError(f"{file} is no name of a material's file; it must end in .in")
    if not file.parent.is_dir():
        raise FileNotFoundError(f"no folder {file.parent} for {file.name}")
    if file.exists() and not force:
        raise FileExistsError(f"{file} exists; --force overwrites it")


def _required(field: attrs.Attribute) -> bool:
    return field.default is attrs.NOTHING


def material_field(
    meaning: str, default: str | attrs.NothingType | None = attrs.NOTHING, suffix: str = ""
):
    """A field of a case for a material, taken as one, by name or by the path of a file. Where the
    default is None, a rigid body, "rigid" and `RIGID` stand for that, and it goes by keyword only.
    The deck knows its constants by their names with the suffix.
    """
    return attrs.field(
        default=default,
        kw_only=default is None,
        converter=_read_unless_rigid if default is None else read_material,
        metadata={"declaration": Declaration(meaning, kind=str), "suffix": suffix},
    )


def _read_unless_rigid(name: Material | laws.Body | str | Path | None) -> Material | None:
    """A material, or None for a body that is rigid, which "rigid" and `RIGID` stand for, too."""
    is_rigid = name is None or name == RIGID_WALL or (isinstance(name, laws.Body) and name == RIGID)
    return None if is_rigid else read_material(name)
