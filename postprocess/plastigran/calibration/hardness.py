# SPDX-License-Identifier: GPL-2.0-or-later
"""Flow stress from hardness, and conversions between hardness scales.

Vickers hardness is the force in kgf divided by the sloping area of the indentation in mm^2. The
mean pressure H is the force divided by the projected area, which is sin 68 deg = 0.9272 of the
sloping area. For a fully plastic indentation, H is 2.8 times the flow stress at about 8 % strain
(Tabor, The Hardness of Metals, 1951).

Conversions between scales hold for steel that is not austenitic. Scatter is given as the half-width
of a 95 % interval.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from importlib.resources import files
from math import hypot

import attrs
import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from plastigran.declared import Declaration, read_number

CONSTRAINT_FACTOR = 2.8  # mean pressure of an indentation / flow stress
CONSTRAINT_SCATTER = 0.07  # relative 95 % half-width of the factor: 2.6 to 3.0
INDENTATION_STRAIN = 0.08  # strain at which a metal has the flow stress of an indentation
READING_SCATTER = 0.03  # permissible relative error of a hardness tester, ISO 6507-2

#: Rockwell C and Vickers hardness of steel, ASTM E140-12b, table 1.
ROCKWELL_C = np.arange(20, 70, 2.0)
ROCKWELL_C_VICKERS = (
    *(238, 248, 260, 272, 286, 302, 318, 336, 354, 372, 392, 412, 434),
    *(458, 484, 513, 544, 577, 613, 653, 697, 746, 800, 865, 940),
)  # fmt: skip


@attrs.frozen
class HardnessScale:
    """Hardness scale.

    Attributes:
        numbers: Allowed numbers on the scale.
        vickers: Function from a number on the scale to HV.
        scatter: Scatter of this conversion.
        source: Source of this conversion, which is for steel; "" for HV itself.
    """

    numbers: Declaration
    vickers: Callable[[float], float]
    scatter: float = 0.0
    source: str = ""


def _numbers(unit: str, lower: float, upper: float) -> Declaration:
    return Declaration("hardness", unit, lower, upper, lower_allowed=True, upper_allowed=True)


def _rockwell_c_to_vickers(value: float) -> float:
    return float(np.interp(value, ROCKWELL_C, ROCKWELL_C_VICKERS))


SCALES = {
    "HV": HardnessScale(_numbers("HV", 5, 2000), float),
    # ISO 18265, table A.1. In ASTM E140, HB equals HV below 240; above 240, both standards agree
    # within 1.5 %.
    "HB": HardnessScale(
        _numbers("HB", 76, 618), lambda value: value / 0.95, 0.05, "HB = 0.95 HV, ISO 18265"
    ),
    # The scatter of 5 % covers the difference between the manuals of two makers of testers: 4 % in
    # HV, at 41.5 and 54.5 HRC.
    "HRC": HardnessScale(
        _numbers("HRC", 20, 68), _rockwell_c_to_vickers, 0.05, "table 1 of ASTM E140"
    ),
}


@attrs.frozen
class Hardness:
    """Measured hardness.

    Attributes:
        value: Number on the scale.
        scale: HV, HB or HRC.

    Raises:
        ValueError: The scale is unknown, or the number is out of its range.
    """

    value: float
    scale: str = "HV"

    def __attrs_post_init__(self) -> None:
        if self.scale not in SCALES:
            raise ValueError(
                f"the scale of hardness is {self.scale}; it must be one of {', '.join(SCALES)}"
            )
        read_number("hardness", self.value, SCALES[self.scale].numbers)

    @property
    def vickers(self) -> float:
        """Hardness in HV."""
        return SCALES[self.scale].vickers(self.value)

    @property
    def scatter(self) -> float:
        """Relative 95 % half-width of the flow stress [-].

        This value combines the scatters of reading, conversion and constraint factor.
        """
        return hypot(READING_SCATTER, SCALES[self.scale].scatter, CONSTRAINT_SCATTER)

    def __str__(self) -> str:
        return f"{self.value:g} {self.scale}"


def read_hardness(hardness: Hardness | float | str) -> Hardness:
    """Return a hardness from a number, which is HV, or a text such as "45HRC" or "200 HB".

    The load after a scale, as in "380 HV10" or "200 HBW 10/3000", is accepted and ignored.

    Raises:
        ValueError: The value is not such a number or text, or is out of the range of the scale.
    """
    if isinstance(hardness, Hardness):
        return hardness
    positive = r"(?!0*\.?0*(?:[/\s]|$))[\d.]+"
    number, load = r"([-+.\dE]+?)", rf"(?:(?<=HV|HB|BW)\s*{positive}(?:/{positive})*)?"
    match = re.fullmatch(rf"\s*{number}\s*([A-Z]*){load}\s*", str(hardness).upper())
    try:
        value = float(match[1])
    except (TypeError, ValueError):
        raise ValueError(
            f"hardness is {hardness!r}; it must be a number and a scale of {', '.join(SCALES)}, "
            "for example 45HRC"
        ) from None
    return Hardness(value, {"": "HV", "HBW": "HB"}.get(match[2], match[2]))


def indentation_pressure(vickers: ArrayLike) -> np.ndarray:
    """Return the mean pressure H [Pa] on the projected area; `vickers` [HV] may have any shape."""
    return 9.807e6 * np.asarray(vickers, dtype=float) / 0.9272


def flow_stress(vickers: ArrayLike) -> np.ndarray:
    """Return the flow stress [Pa] at about 8 % strain, H/2.8; `vickers` [HV] may have any shape."""
    return indentation_pressure(vickers) / CONSTRAINT_FACTOR


def steel_yield_strength(vickers: ArrayLike) -> np.ndarray:
    """Return the tensile yield strength [Pa] of hypoeutectoid steels from `vickers` (any shape).

    The strength follows from a line fitted to 150 steels of 300 to 1700 MPa. The tensile yield
    strength is lower than the flow stress in a contact.
    Source: Pavlina & Van Tyne 2008, J. Mater. Eng. Perform. 17:888.
    """
    return 1e6 * (2.876 * np.asarray(vickers, dtype=float) - 90.7)


@cache
def leeb_table() -> pd.DataFrame:
    """Return a table of Leeb hardness HLD and Vickers hardness HV of steel, with 59 rows."""
    with (files("plastigran") / "data" / "leeb_d_steel.csv").open() as file:
        return pd.read_csv(file, comment="#")
