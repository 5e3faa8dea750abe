# SPDX-License-Identifier: GPL-2.0-or-later
"""Materials: one file per material in `inputs/materials`, which decks include and Python reads.

An installed package contains these files. You can also use your own files in the same format: give
the path of a file, or set $PLASTIGRAN_INPUTS to your own folder of input scripts.
"""

from __future__ import annotations

import re
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import attrs

from plastigran import laws
from plastigran.declared import Declaration, declarations, number, read_float, read_number
from plastigran.engine.deck import commands, index_lines, index_variable
from plastigran.engine.process import EngineError, inputs_folder, own_inputs

if TYPE_CHECKING:
    import pandas as pd

#: Wall that neither deforms nor yields.
RIGID = laws.Body(1e30, 0.3)

#: Words in results tables and folder names that stand for the wall `RIGID`, for no wall, and for
#: default options of a law. These words cannot be names of materials.
RIGID_WALL, NO_WALL, USUAL = TAKEN = "rigid", "none", "default"
#: Allowed names of materials.
_NAME = re.compile(r"\w([\w .+-]*[\w.+-])?")

#: Constants of a body in contact, by name: unit, range, default and meaning.
BODY_CONSTANTS = {row["name"]: row for row in laws.body_constants()}

#: Declaration of the work of adhesion of two bodies.
SURFACE_ENERGY = Declaration("work of adhesion", "J/m^2", 0, 1e3, True, True)


def body_constant(name: str, required: bool = False) -> Any:
    """Declare a field for a material constant of one body; `laws.Body` checks the range.

    Args:
        name: Name in `BODY_CONSTANTS`.
        required: Whether the field has no default.
    """
    row = BODY_CONSTANTS[name]
    bounds = row["lower"], row["upper"], not row["above"], True
    return attrs.field(
        default=attrs.NOTHING if required or row["default"] is None else row["default"],
        converter=lambda value: read_float(name, value, row["unit"]),
        metadata={"declaration": Declaration(row["meaning"], row["unit"], *bounds)},
    )


def surface_energy_field(meaning: str) -> Any:
    """Declare a keyword-only field for a work of adhesion [J/m^2]; None if it is not given."""
    declaration = attrs.evolve(SURFACE_ENERGY, meaning=meaning)

    def read(value: Any) -> float:
        return read_number("surface_energy", value, declaration)

    converter, metadata = attrs.converters.optional(read), {"declaration": declaration}
    return attrs.field(default=None, kw_only=True, converter=converter, metadata=metadata)


@attrs.frozen
class Material:
    """Constants of one material.

    Raises:
        ValueError: A constant is not a number or out of range; the message names it and the range.
    """

    name: str
    youngs_modulus: float = body_constant("youngs_modulus")
    poissons_ratio: float = body_constant("poissons_ratio")
    density: float = number("density", "kg/m^3", 0)
    yield_strength: float = body_constant("yield_strength", required=True)
    yield_pressure_factor: float = body_constant("yield_pressure_factor")
    tangent_modulus: float = body_constant("tangent_modulus")
    rate_coefficient: float = body_constant("rate_coefficient")
    reference_rate: float = body_constant("reference_rate")
    dissipative_constant: float | None = number(
        "ratio A of viscous to elastic constants", "s", 0, lower_allowed=True, default=None
    )
    surface_energy: float | None = surface_energy_field(
        "work of adhesion Γ of two bodies of the material"
    )

    def __attrs_post_init__(self) -> None:
        _check_name(self.name)
        self.body()

    def variables(self, suffix: str = "") -> dict[str, float]:
        """Return the constants as deck variables, in SI units.

        Without suffix, the result contains all constants that are set. With a suffix, for example
        for a wall, it contains the constants of `BODY_CONSTANTS`, with the suffix added to each
        name.
        """
        if suffix:
            return {f"{name}{suffix}": getattr(self, name) for name in BODY_CONSTANTS}
        return attrs.asdict(self, filter=lambda at, value: at.name != "name" and value is not None)

    def missing(self, law: str) -> list[str]:
        """Return the required constants of a law that this material does not define."""
        return [name for name in _needed(law) if getattr(self, name, None) is None]

    def law(self, name: str, pair: laws.MaterialPair, **others: float | str):
        """Create a law for contacts of this material, with its required constants.

        Args:
            name: Name of the law.
            pair: Constants of the two bodies.
            others: Further constants, such as lengths of the bodies, and options.

        Raises:
            ValueError: The material lacks a constant, or one is out of range; the message names it.
        """
        constants = {key: getattr(self, key, None) for key in _needed(name)} | others
        if missing := [key for key, value in constants.items() if value is None]:
            needs = f"law {name} needs {', '.join(missing)}, which"
            if not has_constants(name):
                raise ValueError(
                    f"{needs} materials cannot define. Give it to plastigran.Contact, or use "
                    "another law"
                )
            raise ValueError(
                f"{needs} material {self.name} does not define. Add it to the material, or use "
                "another law"
            )
        return law_class(name, adhesive="surface_energy" in others)(pair, **constants)

    def body(self) -> laws.Body:
        """Return the constants of the material as a body that the laws accept."""
        return laws.Body(*(getattr(self, name) for name in BODY_CONSTANTS))


def _check_name(name: object) -> None:
    """Reject a material name that cannot be part of a table or of a folder name."""
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise ValueError(
            f"name is {name!r}; it must be letters, digits, spaces and _ . + -, "
            "the first a letter, digit or _"
        )
    if name in TAKEN:
        raise ValueError(
            f"name is {name!r}, but {', '.join(TAKEN)} have another meaning in "
            "tables. Choose another name"
        )


def law_class(name: str, adhesive: bool = False) -> type:
    """Return the class of a law.

    Args:
        name: Name of the law.
        adhesive: Whether to return the variant of the law with adhesion, if there is one.

    Raises:
        ValueError: The law does not exist; the message lists the available laws.
    """
    if not isinstance(name, str) or name not in laws.LAWS:
        raise ValueError(f"no law {name!r}. Available laws: {', '.join(sorted(laws.LAWS))}")
    return (laws.ADHESIVE_LAWS if adhesive else laws.LAWS).get(name, laws.LAWS[name])


def has_constants(law: str) -> bool:
    """Return whether `Material` has a field for every constant that a law requires."""
    return set(_needed(law)) <= {field.name for field in attrs.fields(Material)}


def has_surface_energy(law: str) -> bool:
    """Return whether a law needs a surface energy."""
    return "surface_energy" in _needed(law)


def can_adhere(law: str) -> bool:
    """Return whether a law has adhesion, or takes the option `adhesion jkr`."""
    return has_surface_energy(law) or law in laws.ADHESIVE_LAWS


def _needed(law: str) -> list[str]:
    table = laws.LAWS[law].parameters()
    return [row["name"] for row in table if row["default"] is None and not row["per_body"]]


def folder() -> Path:
    """Return the folder with the material files that can be read by name."""
    with suppress(EngineError):  # if $PLASTIGRAN_INPUTS is wrong, use the project's folder
        named = inputs_folder() / "materials"
        if named.is_dir():
            return named
    return own_inputs() / "materials"


def names() -> list[str]:
    """Return the names of the available materials."""
    return sorted(file.stem for file in folder().glob("*.in"))


def table() -> pd.DataFrame:
    """Return a table of the available materials: rows are materials, columns constants (SI units).

    Raises:
        ValueError: A file cannot be read.
    """
    import pandas as pd  # imported here, because pandas is slow to load

    return pd.DataFrame([attrs.asdict(read_material(name)) for name in names()]).set_index("name")


def read_material(name: Material | str | Path) -> Material:
    """Read a material by name or from a file. Return `name` unchanged if it is a Material.

    Raises:
        ValueError: `name` is not a Material, a name or a path; the material does not exist; or a
            constant is missing, unknown, repeated, not a number or out of range.
    """
    if isinstance(name, Material):
        return name
    if not isinstance(name, str | Path):
        raise ValueError(f"{name!r} is not a material; it must be a Material, a name or a path")
    path = Path(name)
    if path.suffix == ".in" and not path.is_file():
        raise ValueError(
            f"the material file {path} does not exist. Materials available by name: "
            f"{', '.join(names())}"
        )
    if path.suffix != ".in":
        path = folder() / f"{name}.in"
    if not path.is_file():
        file = Path(f"{name}.in")
        hint = (
            f"To use the file in this folder, give its full name {file}. " if file.is_file() else ""
        )
        raise ValueError(
            f"no material {str(name)!r}. {hint}Available materials: {', '.join(names())}"
        )
    try:
        lines = index_lines(path)
    except UnicodeDecodeError:
        raise ValueError(f"{path} is not a text file in UTF-8") from None
    _check_lines(path)
    values: dict[str, str] = {}
    for constant, value in lines:
        if constant in values:
            raise ValueError(f"{path}: {constant} is defined twice. Remove one line")
        values[constant] = value
    fields = {field.name: field for field in attrs.fields(Material)[1:]}
    required = [name for name, field in fields.items() if field.default is attrs.NOTHING]
    if missing := [name for name in required if name not in values]:
        raise ValueError(
            f"{path}: {', '.join(missing)} is not defined. Add `variable NAME index VALUE`"
        )
    if unknown := sorted(values.keys() - fields.keys()):
        raise ValueError(
            f"{path}: {unknown[0]} is not a constant of a material. Available constants: "
            f"{', '.join(fields)}"
        )
    try:
        return Material(path.stem, **values)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error


def _check_lines(file: Path) -> None:
    """Reject lines that LIGGGHTS would execute but `read_material` would ignore."""
    for command in commands(file):
        if "\ufeff" in command:
            raise ValueError(f"{file} begins with a byte order mark. Save it as UTF-8 without one")
        if len(command.split()) != 4 or not index_variable(command):
            raise ValueError(
                f"{file}: command {command!r} is not allowed. A material file may "
                "contain only lines `variable NAME index VALUE`"
            )


def material_lines(material: Material) -> str:
    """Return the lines of a material file with the constants that the material defines."""
    declared = declarations(Material)
    return "\n".join(
        f"variable {name:22s} index {value:<18.12g} # {declared[name].unit}"
        for name, value in material.variables().items()
    )


def write_material(material: Material, file: Path, remark: str, force: bool = False) -> None:
    """Write a material as a file that decks include and `read_material` reads.

    Args:
        material: Material.
        file: Path that ends in .in, in an existing folder.
        remark: Source of the constants, one line.
        force: Whether to overwrite the file.

    Raises:
        ValueError: The path does not end in .in.
        FileExistsError: The file exists and may not be overwritten.
        FileNotFoundError: The folder does not exist.
    """
    check_material_file(file, force)
    file.write_text(f"# {remark}\n{material_lines(material)}\n", encoding="utf-8")


def check_material_file(file: Path, force: bool = False) -> None:
    """Check whether `write_material` can write a file; errors are those of `write_material`."""
    if file.suffix != ".in":
        raise ValueError(f"{file} cannot be a material file: its name must end in .in")
    if not file.parent.is_dir():
        raise FileNotFoundError(
            f"cannot write {file.name}: the folder {file.parent} does not exist. Create the folder"
        )
    if file.exists() and not force:
        raise FileExistsError(f"{file} exists. Use --force to overwrite it")


def material_field(
    meaning: str, default: str | attrs.NothingType | None = attrs.NOTHING, suffix: str = ""
):
    """Declare a field for the material of a body in an experiment.

    The field accepts a Material, the name of a material, or the path of a material file.

    Args:
        meaning: Meaning of the field in words.
        default: Default material; None for a rigid body. With None, the field is keyword-only and
            also accepts "rigid" and `RIGID`.
        suffix: Suffix of the deck variables that take the constants of this material, such as
            "_other" in `youngs_modulus_other`.
    """
    return attrs.field(
        default=default,
        kw_only=default is None,
        converter=_read_unless_rigid if default is None else read_material,
        metadata={"declaration": Declaration(meaning, value_type=str), "suffix": suffix},
    )


def _read_unless_rigid(name: Material | laws.Body | str | Path | None) -> Material | None:
    """Return a material; None for None, "rigid" and `RIGID`."""
    is_rigid = name is None or name == RIGID_WALL or (isinstance(name, laws.Body) and name == RIGID)
    return None if is_rigid else read_material(name)
