# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbers in the cells of a page."""

from __future__ import annotations

import numpy as np


def number(value: object) -> str:
    """Return a table cell as text: four digits, with powers of ten as superscripts."""
    if isinstance(value, bool | np.bool_):
        return "yes" if value else "no"
    if not isinstance(value, int | float | np.integer | np.floating):
        return "" if value is None else str(value)
    if np.isnan(value):
        return ""
    text = f"{value:.4g}"
    if "e" not in text:
        return text.replace("-", "−")
    mantissa, power = text.split("e")
    return f"{mantissa} × 10{_raised(int(power))}".replace("-", "−").removeprefix("1 × ")


def _raised(power: int) -> str:
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
