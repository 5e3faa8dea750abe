# SPDX-License-Identifier: GPL-2.0-or-later
"""Colors of lines on a dark background."""

from __future__ import annotations

import colorsys

from matplotlib.colors import to_hex, to_rgb

#: Smallest relative luminance that gives a line on a dark background a contrast ratio of 4.5.
LEAST = 0.24


def luminance(colour: str) -> float:
    """Return the relative luminance of a color, 0 to 1 (WCAG 2.2)."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in to_rgb(colour)]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def on_dark(colour: str) -> str:
    """Return a color of equal hue, light enough for a dark background. Gray levels are inverted."""
    hue, lightness, saturation = colorsys.rgb_to_hls(*to_rgb(colour))
    if not saturation:
        return to_hex(3 * [0.9 - 0.6 * lightness])
    while luminance(colour) < LEAST:
        lightness += 0.02
        colour = to_hex(colorsys.hls_to_rgb(hue, min(lightness, 1.0), saturation))
    return colour
