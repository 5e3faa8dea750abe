# SPDX-License-Identifier: GPL-2.0-or-later
"""Errors of the laws in each contact regime, for the choice of a law."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pandas as pd

from plastigran.calibration.expected_errors import KINDS
from plastigran.validation.laws_on_spheres import FITTED_LAW, ON_FITTED_METALS
from plastigran.validation.tables import root_mean_square

#: Regimes of spheres by name: kind of contact, smallest and largest impact speed / yield speed.
SPHERE_REGIMES = {
    "just beyond yield, v/v_Y 1–10": (KINDS[0], 1, 10),
    "v/v_Y 10–100": (KINDS[0], 10, 100),
    "v/v_Y 100–300": (KINDS[0], 100, 300),
    "v/v_Y 300–1000": (KINDS[0], 300, 1000),
    "hardening, v/v_Y 1–300": (KINDS[1], 1, 300),
    "hardening, beyond v/v_Y 300": (KINDS[1], 300, np.inf),
    "large a/R, 0.05–0.15": (KINDS[2], 1, np.inf),
}
#: Regimes of rebound tests on steel by name: smallest and largest impact speed / yield speed.
INDENTATION = {
    "a hard ball on a steel flat, v/v_Y 10–300": (10, 300),
    "peening: v/v_Y 1000 and more": (1000, np.inf),
}
RATED = ", with the steel's strain rate"
WORDS = {"coefficient_of_restitution": "restitution", "force_max": "force"}


def _errors(
    compared: pd.DataFrame, rebounds: Mapping[str, pd.DataFrame]
) -> dict[tuple[str, str], pd.DataFrame]:
    """Return the errors of all laws for each regime and quantity.

    Args:
        compared: Table of `laws_on_spheres.compare`.
        rebounds: Tables of `steel.rebounds`. The key of a table is appended to the names of its
            regimes.

    Returns:
        Tables with the columns law and error, by (regime, quantity).
    """
    errors = {}
    for regime, (contact, lowest, highest) in SPHERE_REGIMES.items():
        inside = compared["speed_ratio"].between(lowest, highest) & (compared["kind"] == contact)
        for quantity, word in WORDS.items():
            part = compared.loc[inside, ["law", quantity]]
            errors[regime, word] = part.rename(columns={quantity: "error"})
    for ending, table in rebounds.items():
        for regime, bounds in INDENTATION.items():
            inside = table["speed_ratio"].between(*bounds)
            errors[regime + ending, "restitution"] = table.loc[inside, ["law", "error"]]
    return errors


def by_regime(compared: pd.DataFrame, rebounds: pd.DataFrame, rated: pd.DataFrame) -> pd.DataFrame:
    """Return the three laws with the smallest errors and the worst law, for each regime.

    Args:
        compared: Table of `laws_on_spheres.compare`.
        rebounds, rated: Tables of `steel.rebounds`, without and with strain-rate dependence of the
            steel.

    Returns:
        Table with a row for each regime and quantity. The name of a law is followed by its root
        mean square error and its largest error [%].
    """
    rows = []
    for (regime, word), errors in _errors(compared, {"": rebounds, RATED: rated}).items():
        sizes = _sizes(errors)
        row = {"regime": regime, "quantity": word}
        for number, rank in enumerate(("best", "second", "third")):
            row[rank] = _cell(sizes.iloc[number])
        rows.append(row | {"last": _cell(sizes.iloc[-1])})
    return pd.DataFrame(rows)


def by_law(compared: pd.DataFrame, rebounds: pd.DataFrame, word: str) -> pd.DataFrame:
    """Return the root mean square error of a quantity [%], laws as rows and regimes as columns.

    The law with the smallest mean error comes first. The law `universal` has two rows: its errors
    for metals outside its fit, and below, its errors for the metals of its fit.

    Args:
        compared, rebounds: As for `by_regime`.
        word: "restitution" or "force".
    """
    errors = _errors(compared, {"": rebounds})
    columns = {
        regime: _sizes(part)["rms"] for (regime, which), part in errors.items() if which == word
    }
    table = pd.DataFrame(columns)
    order = list(table.mean(axis="columns").drop(ON_FITTED_METALS).sort_values().index)
    order.insert(order.index(FITTED_LAW) + 1, ON_FITTED_METALS)
    return table.loc[order].map(_two_digits).rename_axis("law").reset_index()


def _sizes(errors: pd.DataFrame) -> pd.DataFrame:
    """Return the root mean square and the largest error of each law [%], smallest first.

    The index of the table is the law; the columns are rms and max.
    """
    by_law = (100 * errors.set_index("law")["error"]).groupby("law")
    sizes = pd.DataFrame(
        {"rms": by_law.agg(root_mean_square), "max": by_law.agg(lambda e: e.abs().max())}
    )
    # Laws whose errors differ only by round-off are sorted by name.
    return sizes.sort_values("rms", key=lambda rms: rms.round(6), kind="stable")


def _cell(row: pd.Series) -> str:
    return f"`{row.name}` {_two_digits(row['rms']):g} ({_two_digits(row['max']):g})"


def _two_digits(error: float) -> float:
    """Round an error to two digits; if it is at least ten, to a whole number."""
    return round(error) if error >= 10 else float(f"{error:.2g}")
