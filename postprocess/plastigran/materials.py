# SPDX-License-Identifier: GPL-2.0-or-later
"""Materials of `inputs/materials`: the input scripts include them, Python reads the same files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from plastigran import laws
from plastigran.engine.deck import index_variables
from plastigran.engine.process import inputs_folder


@dataclass(frozen=True)
class Material:
    """Bulk constants of one material.

    Attributes:
        name: The file's stem.
        youngs_modulus: E [Pa].
        poissons_ratio: nu [-].
        density: [kg/m^3].
        yield_strength: Uniaxial sigma_Y [Pa].
        yield_pressure_factor: Contact yield pressure over yield strength [-]; 0 stands for the
            Hertz-von Mises value.
        dissipative_constant: Viscous over elastic constants A [s]; None where the file gives none.
    """

    name: str
    youngs_modulus: float
    poissons_ratio: float
    density: float
    yield_strength: float
    yield_pressure_factor: float = 0.0
    dissipative_constant: float | None = None

    def variables(self) -> dict[str, float]:
        """The constants as the decks' variables of the same names."""
        return {k: value for k, value in vars(self).items() if k != "name" and value is not None}

    def missing(self, law: str) -> list[str]:
        """Names of the constants a law must be given and this material does not have."""
        return [name for name in _needed(law) if getattr(self, name, None) is None]

    def law(self, name: str, pair: laws.MaterialPair, **others: float | str):
        """A law for contacts of this material, with those of its constants that have no default.

        Args:
            name: Of the law.
            pair: The two bodies.
            others: What is not the material's: lengths that bodies bring, options.

        Raises:
            ValueError: The material lacks one, or it is out of range; the message names it.
        """
        if missing := self.missing(name):
            raise ValueError(f"material {self.name} gives no {', '.join(missing)}; {name} needs it")
        return laws.LAWS[name](pair, **{key: getattr(self, key) for key in _needed(name)}, **others)

    def body(self) -> laws.Material:
        """The constants as the laws take them. Raises ValueError when one is out of range."""
        return laws.Material(
            self.youngs_modulus,
            self.poissons_ratio,
            self.yield_strength,
            self.yield_pressure_factor,
        )


def _needed(law: str) -> list[str]:
    table = laws.LAWS[law].parameters()
    return [row["name"] for row in table if row["default"] is None and not row["per_body"]]


#: A wall that neither deforms nor yields.
RIGID = laws.Material(1e30, 0.3, 1e30, 1.61)


def names() -> list[str]:
    """Names of the materials at hand."""
    return sorted(file.stem for file in (inputs_folder() / "materials").glob("*.in"))


def read_material(name: str | Path) -> Material:
    """Read a material by name, or from a file of the same form given by its path.

    Raises:
        ValueError: No such material, or a constant is missing, not a number or out of range.
    """
    path = Path(name)
    if path.suffix != ".in":
        path = inputs_folder() / "materials" / f"{name}.in"
    if not path.exists():
        raise ValueError(f"no material {str(name)!r}; there are {', '.join(names())}")
    values = {}
    for variable, text in index_variables(path).items():
        try:
            values[variable] = float(text)
        except ValueError:
            raise ValueError(f"{path}: {variable} is {text!r}, not a number") from None
    wanted = [field for field in Material.__dataclass_fields__ if field != "name"]
    missing = [field for field in wanted if field not in values and not hasattr(Material, field)]
    if missing:
        raise ValueError(f"{path}: no value for {', '.join(missing)}")
    material = Material(path.stem, **{key: values[key] for key in wanted if key in values})
    if not 0 < material.density < float("inf"):
        raise ValueError(f"{path}: density is {material.density:g}; it must be positive [kg/m^3]")
    try:
        material.body()
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error
    return material
