# SPDX-License-Identifier: GPL-2.0-or-later
"""Style of figures: settings of matplotlib, colors, titles of laws, and files."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import AbstractContextManager
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.axes import Axes
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
# Colors that color-blind readers can distinguish (palettes of Okabe & Ito and of Tol). `law_number`
# assigns a color to each law; the last color, gray, is for unknown laws. Black is for reference
# data.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8C564B", "#DC267F"]
COLOURS += ["#882255", "#999933", "#332288", "#44AA99", "#661100", "#AA4499"]
COLOURS += ["#117733", "#7F7F7F"]
MARKERS = [*"osD^vPX<>dp*", (6, 1, 0), (4, 1, 0), "h", "."]
#: Titles of laws and materials that differ from the words of their names.
TITLES = {
    "vu_quoc_zhang": "Vu-Quoc–Zhang",
    "viscoelastic_hertz": "Viscoelastic Hertz",
    "aluminium_zv02": "Aluminium",
    "mdr": "MDR",
}


def title(name: str) -> str:
    """Return the name of a law or material for titles: "kogut_etsion" gives "Kogut–Etsion"."""
    words = "–".join(word.capitalize() for word in name.split("_"))
    return TITLES.get(name, words.replace("–20", " 20"))


def law_number(law: str) -> int:
    """Return the index of a law in `COLOURS` and `MARKERS`, the same in every figure.

    Laws of one family have different indices. The laws for one shape of bodies form two families:
    laws without adhesion that are elastic at first touch, and all other laws. An unknown law has
    the index of gray.
    """
    # Import the compiled module here, because figures without laws work without this module.
    from plastigran import laws

    if law not in laws.LAWS:
        return len(COLOURS) - 1

    def family(name: str) -> tuple[str, bool]:
        law_class = laws.LAWS[name]
        return law_class.shape, law_class.elastic_first and not law_class.adhesive

    return sorted(name for name in laws.LAWS if family(name) == family(law)).index(law)


def law_colour(law: str) -> str:
    """Return the color of a law; see `law_number`."""
    return COLOURS[law_number(law)]


def styled(changes: Mapping[str, object] | None = None) -> AbstractContextManager[None]:
    """Return a context manager (or decorator) that applies `STYLE` and further settings."""
    return matplotlib.rc_context(STYLE | dict(changes or {}))


def subplots(
    rows: int = 1, columns: int = 1, *, figsize: tuple[float, float], **arrangement: object
) -> tuple[Figure, Axes | np.ndarray]:
    """Return a figure without a window, and its Axes (an array of Axes if there are several).

    Args:
        rows, columns: Numbers of rows and columns of Axes.
        figsize: Width and height [inch].
        **arrangement: Keywords of `matplotlib.figure.Figure.subplots`, such as height_ratios.
    """
    figure = Figure(figsize=figsize, layout="constrained")
    return figure, figure.subplots(rows, columns, **arrangement)


def subplot_mosaic(
    mosaic: list[list[str]], *, figsize: tuple[float, float]
) -> tuple[Figure, dict[str, Axes]]:
    """Return a figure without a window, and its axes by name; see `Figure.subplot_mosaic`."""
    figure = Figure(figsize=figsize, layout="constrained")
    return figure, figure.subplot_mosaic(mosaic)


def save(
    figure: Figure,
    path: Path,
    suffixes: tuple[str, ...] = (".png", ".svg"),
    resolution: int = 160,
) -> list[Path]:
    """Write a figure to files and return their paths.

    Args:
        figure: Figure to write.
        path: Path of the files. `suffixes` replace its suffix.
        suffixes: Suffixes of the files.
        resolution: Dots per inch of bitmaps.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    files = [path.with_suffix(suffix) for suffix in suffixes]
    for file in files:
        metadata = {"Date": None} if file.suffix == ".svg" else None
        with styled():  # STYLE has a fixed svg.hashsalt, so that SVG files are reproducible
            figure.savefig(file, dpi=resolution, metadata=metadata)
    return files
