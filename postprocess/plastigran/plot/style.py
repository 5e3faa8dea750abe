# SPDX-License-Identifier: GPL-2.0-or-later
"""How figures look: style, colours, names, and how they are written."""

from __future__ import annotations

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.figure import Figure

STYLE = {
    "font.size": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "0.92",
    "legend.frameon": False,
    "svg.hashsalt": "plastigran",
}
# Colours apart for colour-blind eyes (Okabe & Ito, then Tol's muted), one a law, by alphabet.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#7F7F7F"]
COLOURS += ["#882255", "#999933", "#332288", "#44AA99", "#661100", "#AA4499"]
MARKERS = "osD^vPX<>dph*8"


def title(name: str) -> str:
    """A law's or material's name as a person writes it: authors joined by a dash, years apart."""
    names = {
        "vu_quoc_zhang": "Vu-Quoc–Zhang",
        "viscoelastic_hertz": "Viscoelastic Hertz",
        "aluminium_zv02": "Aluminium",
    }
    words = "–".join(word.capitalize() for word in name.split("_"))
    return names.get(name, words.replace("–20", " 20"))


def save(figure: Figure, path: Path, suffixes: tuple[str, ...] = (".png", ".svg")) -> list[Path]:
    """Write a figure, as PNG and SVG beside each other unless told otherwise; returns the paths."""
    path.parent.mkdir(parents=True, exist_ok=True)
    written = []
    for suffix in suffixes:
        written.append(path.with_suffix(suffix))
        metadata = {"Date": None} if suffix == ".svg" else None
        with plt.rc_context(STYLE):  # its salt makes the same figure the same file
            figure.savefig(written[-1], dpi=160, metadata=metadata)
    plt.close(figure)
    return written
