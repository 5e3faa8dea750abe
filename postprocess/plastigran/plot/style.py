# SPDX-License-Identifier: GPL-2.0-or-later
"""How figures look: style, colours, names, and how they are written."""

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
# Colours apart for colour-blind eyes (Okabe & Ito, then Tol's muted), one for each law of a shape,
# and grey; black is for what they are held against. `law_number` has a law's.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8C564B", "#DC267F"]
COLOURS += ["#882255", "#999933", "#332288", "#44AA99", "#661100", "#AA4499"]
COLOURS += ["#117733", "#7F7F7F"]
MARKERS = [*"osD^vPX<>dp*", (6, 1, 0), (4, 1, 0), "h", "."]


def title(name: str) -> str:
    """A law's or material's name as a person writes it: authors joined by a dash, years apart."""
    names = {
        "vu_quoc_zhang": "Vu-Quoc–Zhang",
        "viscoelastic_hertz": "Viscoelastic Hertz",
        "aluminium_zv02": "Aluminium",
        "mdr": "MDR",
    }
    words = "–".join(word.capitalize() for word in name.split("_"))
    return names.get(name, words.replace("–20", " 20"))


def law_number(law: str) -> int:
    """The place of a law's colour and marker in `COLOURS` and `MARKERS`: in every figure the same,
    apart from those of other laws for its shape of bodies. One that this package does not have is
    grey."""
    from plastigran import laws  # compiled: figures without laws do not wait for it

    if law not in laws.LAWS:
        return len(COLOURS) - 1
    alike = sorted(name for name, each in laws.LAWS.items() if each.shape == laws.LAWS[law].shape)
    return alike.index(law)


def law_colour(law: str) -> str:
    """A law's colour; see `law_number`."""
    return COLOURS[law_number(law)]


def styled(changes: Mapping[str, object] | None = None) -> AbstractContextManager[None]:
    """Context, or decorator of a function, in which figures are made in the style.

    Args:
        changes: Other values for matplotlib's settings.
    """
    return matplotlib.rc_context(STYLE | dict(changes or {}))


def subplots(
    rows: int = 1, columns: int = 1, *, figsize: tuple[float, float], **arrangement: object
) -> tuple[Figure, Axes | np.ndarray]:
    """A figure that no window shows, with its axes.

    Args:
        rows: Of axes.
        columns: Of axes.
        figsize: Width and height [inch].
        **arrangement: Keywords of `matplotlib.figure.Figure.subplots` and of its grid's ratios.

    Returns:
        The figure, and one Axes or an array of them as `Figure.subplots` has it.
    """
    figure = Figure(figsize=figsize, layout="constrained")
    return figure, figure.subplots(rows, columns, **arrangement)


def subplot_mosaic(
    mosaic: list[list[str]], *, figsize: tuple[float, float]
) -> tuple[Figure, dict[str, Axes]]:
    """A figure that no window shows, with axes named and placed as in `Figure.subplot_mosaic`."""
    figure = Figure(figsize=figsize, layout="constrained")
    return figure, figure.subplot_mosaic(mosaic)


def save(
    figure: Figure,
    path: Path,
    suffixes: tuple[str, ...] = (".png", ".svg"),
    resolution: int = 160,
) -> list[Path]:
    """Write a figure, as PNG and SVG beside each other unless told otherwise; returns the paths.

    Args:
        figure: What is written.
        path: Where, whatever its suffix.
        suffixes: Of the files.
        resolution: Of pictures of dots, dots an inch.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    written = []
    for suffix in suffixes:
        written.append(path.with_suffix(suffix))
        metadata = {"Date": None} if suffix == ".svg" else None
        with styled():  # its salt makes the same figure the same file
            figure.savefig(written[-1], dpi=resolution, metadata=metadata)
    return written
