# SPDX-License-Identifier: GPL-2.0-or-later
"""Expected error of a law, from the results of `plastigran validate` for spheres."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

import attrs
import pandas as pd

#: Default law.
DEFAULT_LAW = "universal"
#: Smallest a/R of the kind "large a/R".
WIDE = 0.05
#: Kinds of contacts in the table of errors.
KINDS = ("perfectly plastic", "hardening", "large a/R")
#: Default speeds, divided by the yield speed.
USUAL_SPEEDS = (1.0, 300.0)


@attrs.frozen
class ExpectedError:
    """Errors of a law compared with finite elements in a regime, as fractions; None if unknown.

    Attributes:
        kind: Kind of contacts: perfectly plastic or hardening, and "large a/R" if it is reached.
        speed_ratio: Smallest and largest speed / yield speed.
        restitution, restitution_largest: Rms and largest error of the coefficient of restitution.
        force, force_largest: Rms and largest error of the largest force.
        reason: Why the error is unknown, if it is not because speeds or law are not in the table.
    """

    kind: str
    speed_ratio: tuple[float, float]
    restitution: float | None = None
    restitution_largest: float | None = None
    force: float | None = None
    force_largest: float | None = None
    reason: str = ""

    @classmethod
    def of_another_pair(cls, speed_ratio: tuple[float, float]) -> ExpectedError:
        """Return an unknown error, for bodies other than spheres on a rigid plane."""
        return cls("", speed_ratio, reason="finite elements are of spheres on a rigid plane")

    def __str__(self) -> str:
        ends = " to ".join(dict.fromkeys(f"{end:.3g}" for end in self.speed_ratio))
        regime = f"{self.reason or self.kind}, {ends} times the yield speed"
        if self.restitution is None:
            return f"not known ({regime})"
        return (
            f"restitution {self.restitution:.1%} rms, {self.restitution_largest:.1%} at most; "
            f"largest force {self.force:.1%} rms, {self.force_largest:.1%} at most ({regime})"
        )


@cache
def errors_table() -> pd.DataFrame:
    """Read the errors by law, kind of contact and speed regime of `plastigran validate`."""
    with (files("plastigran") / "data" / "errors.csv").open() as file:
        return pd.read_csv(file, comment="#")


def expected_error(
    law: str, speed_ratio: tuple[float, float], hardening: bool, contact_radius_ratio: float
) -> ExpectedError:
    """Return the errors of a law for a range of speeds: the largest of its regimes.

    Args:
        law: Name of the law.
        speed_ratio: Smallest and largest speed / yield speed [-].
        hardening: Whether the metal hardens.
        contact_radius_ratio: a/R at the largest speed [-].
    """
    plastic, hardens, wide = KINDS
    kinds = [hardens if hardening else plastic]
    kinds += [wide] if contact_radius_ratio >= WIDE else []
    kind = ", ".join(kinds)
    least, largest = max(speed_ratio[0], 1.0), max(speed_ratio[1], 1.0)
    table = errors_table()
    rows = table[
        (table["law"] == law)
        & table["kind"].isin(kinds)
        & (table["speed_ratio_from"] <= largest)
        & (table["speed_ratio_to"] > least)
    ]
    known = not rows.empty and rows["speed_ratio_to"].max() >= largest
    if not known:
        return ExpectedError(kind, speed_ratio)
    by = {name: part for name, part in rows.groupby("quantity")}
    restitution, force = by["coefficient_of_restitution"], by["force_max"]
    worst = [
        float(part[column].max()) for part in (restitution, force) for column in ("rms", "max")
    ]
    return ExpectedError(kind, speed_ratio, *worst)
