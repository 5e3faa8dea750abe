# SPDX-License-Identifier: GPL-2.0-or-later
"""Lines of a deck with calibrated constants."""

from __future__ import annotations

from collections.abc import Mapping

from plastigran.engine.deck import property_name


def deck_lines(
    law: str, body: Mapping[str, float], pair: Mapping[str, float], comment: str = ""
) -> list[str]:
    """Return the lines of a deck for grains of one atom type.

    Args:
        law: Words that follow `model` in pair_style: law, tangential model and options.
        body: Constants of the grains by name.
        pair: Constants of the contact of two grains by name.
        comment: Comment at the end of the lines of `pair`.
    """
    fix = "fix {} all property/global {} {} {:.6g}"
    return [
        *(fix.format(k, property_name(k), "peratomtype", v) for k, v in body.items()),
        *(
            fix.format(k, property_name(k), "peratomtypepair 1", v) + comment
            for k, v in pair.items()
        ),
        "# Friction is not calibrated: set the coefficient of your pair of materials.",
        "fix coefficient_friction all property/global coefficientFriction peratomtypepair 1 0.3",
        f"pair_style gran model {law}",
    ]
