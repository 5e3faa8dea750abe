# SPDX-License-Identifier: GPL-2.0-or-later
"""Drop tests: restitution of a ball on a plate at one or more speeds, read from a table.

The file has a line of column names and then one line per drop. Columns are separated by commas,
semicolons or blanks; # starts a comment. The impact is given as `speed` [m/s] or `drop_height` [m],
the initial height of the lowest point of the ball above the plate. The rebound is given as
`restitution` [-], `rebound_speed` [m/s] or `rebound_height` [m]. Air drag is neglected.
"""

from __future__ import annotations

from pathlib import Path

import attrs
import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from plastigran import laws
from plastigran.contact import Contact
from plastigran.declared import Declaration, read_number
from plastigran.materials import RIGID, Material
from plastigran.physics.rebound_hardness import GRAVITATIONAL_ACCELERATION, dented_flat

IMPACT = {
    "speed": Declaration("impact speed", "m/s", 1e-4, 1000),
    "drop_height": Declaration("height of the fall", "m", 1e-6, 10),
}
REBOUND = {
    # The upper bound is slightly above 1, because a value must be below the bound.
    "restitution": Declaration("coefficient of restitution", "-", 0, 1.000001),
    "rebound_speed": Declaration("speed after the impact", "m/s", 0, 1000),
    "rebound_height": Declaration("height after the impact", "m", 0, 10),
}
BALL_RADIUS = 5e-3  # default radius of the ball [m]
SYNONYMS = {"coefficient_of_restitution": "restitution"}


def _floats(values: ArrayLike) -> np.ndarray:
    return np.array(values, dtype=float, ndmin=1)


@attrs.frozen
class DropTest:
    """Drops of one ball on one plate. `ball` or `plate` is None for the metal to be calibrated.

    Attributes:
        speed: Impact speeds (N,), m/s.
        restitution: Coefficients of restitution (N,).
        ball: Material of the ball.
        plate: Material of the plate, or `RIGID`.
        radius: Radius of the ball [m]. The radius affects the restitution only if the yield
            strength depends on the strain rate.

    Raises:
        ValueError: A speed or restitution is out of range, the numbers of speeds and restitutions
            differ, neither ball nor plate is the metal, or there is no drop.
    """

    speed: np.ndarray = attrs.field(converter=_floats, eq=attrs.cmp_using(np.array_equal))
    restitution: np.ndarray = attrs.field(converter=_floats, eq=attrs.cmp_using(np.array_equal))
    ball: Material | None = None
    plate: Material | laws.Body | None = RIGID
    radius: float = BALL_RADIUS

    def __attrs_post_init__(self) -> None:
        for value in self.speed:
            read_number("speed", value, IMPACT["speed"])
        for value in self.restitution:
            read_number("restitution", value, REBOUND["restitution"])
        if self.speed.shape != self.restitution.shape:
            raise ValueError(
                f"there are {self.speed.size} speeds and {self.restitution.size} restitutions; "
                "their numbers must be equal"
            )
        if self.ball is not None and self.plate is not None:
            raise ValueError(
                f"ball is {self.ball.name} and plate is {self.plate_name}, so neither is the "
                "calibrated metal. Omit ball, or make the plate the calibrated metal: "
                "plate=None, on the command line `--plate metal`"
            )
        if not len(self.speed):
            raise ValueError("the drop test contains no drop; at least one is needed")

    @property
    def ball_name(self) -> str:
        """Name of the ball in messages."""
        return "the metal" if self.ball is None else self.ball.name

    @property
    def plate_name(self) -> str:
        """Name of the plate in messages."""
        if self.plate is None:
            return "the metal"
        return self.plate.name if isinstance(self.plate, Material) else "a rigid plate"

    def contact(self, law: str, metal: Material) -> Contact:
        """Return the contact of ball and plate; `metal` is the body whose attribute is None."""
        options = dented_flat(law) if self.ball else {}
        return Contact(law, self.ball or metal, self.plate or metal, radius=self.radius, **options)


def read_drop_test(path: str | Path) -> pd.DataFrame:
    """Read speeds [m/s] and restitutions [-]: columns `speed` and `restitution`, one row per drop.

    Raises:
        ValueError: A column is missing, unknown or repeated, or a value is not a number or out of
            range; the message names file, drop, value and range.
        OSError: The file cannot be read.
    """
    path = Path(path)
    try:
        # Read without a header: pandas then rejects a line with more fields than the first line.
        lines = pd.read_csv(
            path, sep=r"\s*[,;]\s*|\s+", comment="#", engine="python", header=None, dtype=str
        )
    except UnicodeDecodeError as error:
        raise ValueError(f"{path} is not a table of drops: {error}") from None
    except (pd.errors.ParserError, pd.errors.EmptyDataError) as error:
        raise ValueError(
            f"{path} is not a table of drops: {error}. Use a decimal point, not a comma"
        ) from None
    table = lines.iloc[1:].set_axis([SYNONYMS.get(name, name) for name in lines.iloc[0]], axis=1)
    columns = f"use one of {', '.join(IMPACT)} and one of {', '.join(REBOUND)}"
    if unknown := [name for name in table if name not in IMPACT | REBOUND]:
        raise ValueError(f"{path}: {unknown[0]!r} is not a column of a drop test; {columns}")
    if not table.columns.is_unique:
        raise ValueError(f"{path} has two columns with the same name; {columns}")
    for choices in (IMPACT, REBOUND):
        present = [name for name in choices if name in table]
        if len(present) != 1:
            names = " and ".join(present) or f"none of {', '.join(choices)}"
            raise ValueError(f"{path} has {names}; {columns}")
    drops = [
        _read_drop(f"{path}: {{}} of drop {row}", line)
        for row, line in enumerate(table.to_dict("records"), start=1)
    ]
    return pd.DataFrame(drops, columns=["speed", "restitution"], dtype=float)


def _read_drop(label: str, cells: dict[str, str]) -> tuple[float, float]:
    """Return impact speed [m/s] and restitution [-] of one line of the table.

    Args:
        label: Name of a cell in error messages; {} stands for the column.
        cells: Text of each cell of the line, by name of the column.
    """
    values = {}
    for name, declaration in (IMPACT | REBOUND).items():
        if name in cells:
            try:
                values[name] = read_number(label.format(name), cells[name], declaration)
            except ValueError as error:
                hint = ". Check the unit: m" if name == "drop_height" else ""
                raise ValueError(f"{error}{hint}") from None
    speed = values.get("speed") or _fall_speed(values["drop_height"])
    if "restitution" in values:
        return speed, values["restitution"]
    rebound_speed = values.get("rebound_speed") or _fall_speed(values["rebound_height"])
    ratio = rebound_speed / speed
    return speed, read_number(label.format("restitution"), ratio, REBOUND["restitution"])


def _fall_speed(height: float) -> float:
    """Return the speed [m/s] after a free fall from a height [m]."""
    return float(np.sqrt(2 * GRAVITATIONAL_ACCELERATION * height))
