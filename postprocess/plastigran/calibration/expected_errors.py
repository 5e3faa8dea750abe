# SPDX-License-Identifier: GPL-2.0-or-later
"""Expected errors of laws, from the results of `plastigran validate` for spheres."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

import attrs
import pandas as pd

#: Law that `calibrate` uses by default.
DEFAULT_LAW = "universal"
#: Smallest contact radius / sphere radius of contacts of the kind "large a/R".
WIDE = 0.05
#: Kinds of contacts in the table of errors (data/errors.csv).
KINDS = ("perfectly plastic", "hardening", "large a/R")
#: Default range of impact speeds, divided by the yield speed.
USUAL_SPEEDS = (1.0, 300.0)


@attrs.frozen
class ExpectedError:
    """Errors of a law compared with finite elements, as fractions; None if unknown.

    Attributes:
        regime: Kinds of contact (see `KINDS`) that were compared with finite elements. If there was
            no comparison, the reason.
        speed_ratio: Smallest and largest impact speed / yield speed.
        restitution, restitution_largest: Rms error and largest error of the coefficient of
            restitution.
        force, force_largest: Rms error and largest error of the peak force.
    """

    regime: str
    speed_ratio: tuple[float, float]
    restitution: float | None = None
    restitution_largest: float | None = None
    force: float | None = None
    force_largest: float | None = None

    @classmethod
    def of_another_pair(cls, speed_ratio: tuple[float, float]) -> ExpectedError:
        """Return an `ExpectedError` without values, because the bodies are not sphere and plane."""
        return cls(
            "unknown, because finite elements exist only for spheres on a rigid plane", speed_ratio
        )

    def __str__(self) -> str:
        ends = " to ".join(dict.fromkeys(f"{end:.3g}" for end in self.speed_ratio))
        regime = f"{self.regime}, {ends} times the yield speed"
        if self.restitution is None:
            return f"not known ({regime})"
        return (
            f"restitution {self.restitution:.1%} rms, {self.restitution_largest:.1%} at most; "
            f"largest force {self.force:.1%} rms, {self.force_largest:.1%} at most ({regime})"
        )


@cache
def errors_table() -> pd.DataFrame:
    """Read the errors of `plastigran validate` by law, kind of contact and range of speeds."""
    with (files("plastigran") / "data" / "errors.csv").open() as file:
        return pd.read_csv(file, comment="#")


def expected_error(
    law: str, speed_ratio: tuple[float, float], hardening: bool, contact_radius_ratio: float
) -> ExpectedError:
    """Return the largest errors of a law in a range of impact speeds.

    The errors are unknown if the table of errors does not cover the law or the whole range.

    Args:
        law: Name of the law.
        speed_ratio: Smallest and largest impact speed / yield speed [-].
        hardening: Whether the metal hardens.
        contact_radius_ratio: Contact radius / sphere radius at the largest speed [-].
    """
    perfectly_plastic, hardens, wide = KINDS
    kinds = [hardens if hardening else perfectly_plastic]
    kinds += [wide] if contact_radius_ratio >= WIDE else []
    slowest, fastest = (max(ratio, 1.0) for ratio in speed_ratio)
    table = errors_table()
    rows = table[
        (table["law"] == law)
        & table["kind"].isin(kinds)
        & (table["speed_ratio_from"] <= fastest)
        & (table["speed_ratio_to"] > slowest)
    ]
    if rows.empty or rows["speed_ratio_to"].max() < fastest:
        return ExpectedError(", ".join(kinds), speed_ratio)
    largest = rows.groupby("quantity")[["rms", "max"]].max()
    errors = largest.loc[["coefficient_of_restitution", "force_max"]].to_numpy().ravel()
    return ExpectedError(", ".join(kinds), speed_ratio, *errors.tolist())
