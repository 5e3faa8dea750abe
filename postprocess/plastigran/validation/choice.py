# SPDX-License-Identifier: GPL-2.0-or-later
"""Errors of the laws by regime, to choose a law."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pandas as pd

from plastigran.calibration.expected_errors import KINDS
from plastigran.validation.laws_on_spheres import FITTED_LAW, ON_FITTED_METALS, QUANTITIES

#: Regimes of the spheres: name, kind of contact, bounds of v/v_Y.
SPHERE_REGIMES = {
    "just beyond yield, v/v_Y 1–10": (KINDS[0], 1, 10),
    "v/v_Y 10–100": (KINDS[0], 10, 100),
    "v/v_Y 100–300": (KINDS[0], 100, 300),
    "v/v_Y 300–1000": (KINDS[0], 300, 1000),
    "hardening, v/v_Y 1–300": (KINDS[1], 1, 300),
    "hardening, beyond v/v_Y 300": (KINDS[1], 300, np.inf),
    "large a/R, 0.05–0.15": (KINDS[2], 1, np.inf),
}
#: Regimes of the rebound hardness of steel: bounds of v/v_Y.
INDENTATION = {
    "a hard ball on a steel flat, v/v_Y 10–300": (10, 300),
    "peening: v/v_Y 1000 and more": (1000, np.inf),
}
RATED = ", with the steel's strain rate"
WORDS = {QUANTITIES[0]: "restitution", QUANTITIES[1]: "force"}


def _errors(
    compared: pd.DataFrame, rebounds: pd.DataFrame, rated: pd.DataFrame | None = None
) -> Mapping[tuple[str, str], pd.DataFrame]:
    """Return columns law and error for each regime and quantity."""
    parts = {}
    for regime, (kind, least, most) in SPHERE_REGIMES.items():
        chosen = compared["speed_ratio"].between(least, most) & (compared["kind"] == kind)
        for quantity, word in WORDS.items():
            part = compared.loc[chosen, ["law", quantity]]
            parts[regime, word] = part.rename(columns={quantity: "error"})
    for added, found in (("", rebounds), (RATED, rated)):
        if found is None:
            continue
        for regime, (least, most) in INDENTATION.items():
            chosen = found["speed_ratio"].between(least, most)
            parts[regime + added, "restitution"] = found.loc[chosen, ["law", "error"]]
    return parts


def by_regime(compared: pd.DataFrame, rebounds: pd.DataFrame, rated: pd.DataFrame) -> pd.DataFrame:
    """Return the three best laws and the last one for each regime.

    Args:
        compared: As of `laws_on_spheres.compare`.
        rebounds: As of `steel.rebounds`.
        rated: The same with the strain rate.

    Returns:
        A row for each regime and quantity. Each law has its root mean square error and its largest
        error [%].
    """
    rows = []
    for (regime, word), part in _errors(compared, rebounds, rated).items():
        found = _sizes(part)
        row = {"regime": regime, "quantity": word}
        for place, name in enumerate(("best", "second", "third")):
            row[name] = _cell(found.iloc[place])
        rows.append(row | {"last": _cell(found.iloc[-1])})
    return pd.DataFrame(rows)


def by_law(compared: pd.DataFrame, rebounds: pd.DataFrame, word: str) -> pd.DataFrame:
    """Return the root mean square error of a quantity [%], laws as rows and regimes as columns.

    The law with the smallest mean comes first. The row of `ON_FITTED_METALS` follows its law.

    Args:
        compared, rebounds: As for `by_regime`.
        word: "restitution" or "force".
    """
    parts = _errors(compared, rebounds)
    columns = {
        regime: _sizes(part)["rms"] for (regime, which), part in parts.items() if which == word
    }
    found = pd.DataFrame(columns)
    order = list(found.mean(axis="columns").drop(ON_FITTED_METALS).sort_values().index)
    order.insert(order.index(FITTED_LAW) + 1, ON_FITTED_METALS)
    return found.loc[order].map(_digits).rename_axis("law").reset_index()


def _sizes(part: pd.DataFrame) -> pd.DataFrame:
    """Return the errors of the laws [%], smallest first: index law, columns rms and max."""
    groups = 100 * part.set_index("law")["error"]
    found = pd.DataFrame(
        {
            "rms": (groups**2).groupby("law").mean() ** 0.5,
            "max": groups.abs().groupby("law").max(),
        }
    )
    # Laws that differ only by round-off are sorted by name.
    return found.sort_values("rms", key=lambda sizes: sizes.round(6), kind="stable")


def _cell(row: pd.Series) -> str:
    return f"`{row.name}` {_digits(row['rms']):g} ({_digits(row['max']):g})"


def _digits(error: float) -> float:
    """Return an error with two digits; from ten, without decimals."""
    return round(error) if error >= 10 else float(f"{error:.2g}")
