# SPDX-License-Identifier: GPL-2.0-or-later
"""Values of the constants that a law requires and that materials lack."""

from __future__ import annotations

from plastigran import laws

#: Values in SI units for bodies of some millimeters. With this surface energy, the pull-off
#: distance is near the overlap at yield.
VALUES = {
    "dissipative_constant": 1e-6,
    "surface_energy": 10.0,
    "loading_stiffness": 1e6,
    "unloading_stiffness": 4e6,
    "stiffness_ratio": 5.0,
}


def required(law: str) -> dict[str, float]:
    """Return values for the constants that a law requires, without per-body constants."""
    table = laws.LAWS[law].parameters()
    names = [row["name"] for row in table if row["default"] is None and not row["per_body"]]
    return {name: VALUES[name] for name in names}
