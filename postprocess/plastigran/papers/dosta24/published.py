# SPDX-License-Identifier: GPL-2.0-or-later
"""Published results of the benchmark of Dosta et al. 2024."""

from __future__ import annotations

from importlib.resources import files

import pandas as pd

#: Height of the ball's center at the start, in the coordinates of the published data [m].
START = 0.06


def _read(name: str) -> pd.DataFrame:
    with (files("plastigran") / "data" / f"dosta24_{name}.csv").open() as file:
        return pd.read_csv(file, comment="#")


def eight_codes() -> dict[str, pd.DataFrame]:
    """Return the displacement of the ball in beds of 25000 grains, by code.

    Returns:
        For each code, columns time [s], mean displacement over its beds [m], and sd, the standard
        deviation of the displacement [m].
    """
    table = _read("impact_25k")
    codes = [name.removesuffix("_mean") for name in table if name.endswith("_mean")]
    return {
        code: pd.DataFrame(
            {
                "time": table["time_s"],
                "displacement": table[f"{code}_mean"] - START,
                "sd": table[f"{code}_sd"],
            }
        )
        for code in codes
    }


def reruns(grains: int) -> dict[str, pd.DataFrame]:
    """Return the displacement of the ball in the bed with published grain positions, by code.

    Args:
        grains: Number of grains of the bed: 25000, 50000 or 100000.

    Returns:
        For LIGGGHTS and MUSEN, columns time [s] and displacement [m].
    """
    table = _read("impact_reruns")
    return {
        label: pd.DataFrame(
            {
                "time": table["time_s"],
                "displacement": table[f"{grains // 1000}k_{code}"] - START,
            }
        )
        for label, code in (("LIGGGHTS", "liggghts"), ("MUSEN", "musen"))
    }


def silo(orifice: str) -> dict[str, pd.DataFrame]:
    """Return the number of grains in the silo versus time, for grains of material M1, by code.

    Args:
        orifice: Orifice of the silo: large or small.

    Returns:
        For MUSEN and, with the large orifice, LIGGGHTS: columns time [s] and held (number of
        grains above the orifice).
    """
    table = _read("silo")
    return {
        code: pd.DataFrame({"time": table["time_s"], "held": table[column]}).dropna()
        for code in ("LIGGGHTS", "MUSEN")
        if (column := f"{orifice}_M1_{code.lower()}") in table
    }


def drum() -> dict[str, pd.DataFrame]:
    """Return the numbers of grains in two opposite quadrants (zones) of the drum, by code.

    Returns:
        For LIGGGHTS and MUSEN, columns time [s], and small_1, small_2, large_1 and large_2: the
        numbers of small grains (M1) and large grains (M2) in zones 1 and 2.
    """
    table = _read("drum")
    return {
        code: pd.DataFrame(
            {
                "time": table["time_s"],
                **{
                    f"{size}_{zone}": table[f"{code.lower()}_zone{zone}_{material}"]
                    for size, material in (("small", "M1"), ("large", "M2"))
                    for zone in (1, 2)
                },
            }
        ).dropna()
        for code in ("LIGGGHTS", "MUSEN")
    }
