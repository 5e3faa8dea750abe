# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of earlier commands, packed for a page."""

from __future__ import annotations

import base64
import re
from collections.abc import Collection
from pathlib import Path
from xml.etree import ElementTree

import attrs
from PIL import Image, ImageSequence

#: Largest SVG file [bytes] that a page contains; for a larger one it takes the bitmap.
LARGEST_LINES = 120_000
#: Largest picture [bytes] that a page contains.
LARGEST = 500_000
#: Ratio of width to height from which a picture is wide.
WIDE = 1.7
_KINDS = {".svg": "image/svg+xml", ".png": "image/png", ".gif": "image/gif"}
#: Exceptions of damaged pictures.
_DAMAGE = (
    OSError,
    SyntaxError,  # damaged SVG, too
    ValueError,
    IndexError,
    Image.DecompressionBombError,
)


@attrs.frozen
class Picture:
    """Figure of a section.

    Attributes:
        name: Name of the file in words.
        source: Content as a data URL.
        light: Whether the background is white; the page darkens it in its dark mode.
        wide: Whether the figure takes the width of the page.
    """

    name: str
    source: str
    light: bool = True
    wide: bool = False


def read_pictures(folder: Path, besides: Collection[str] = ()) -> tuple[list[Picture], list[str]]:
    """Return the figures in a folder, and sentences on those left out.

    Args:
        folder: Folder of the files.
        besides: Names without suffix of figures that the page shows in another form.
    """
    if not folder.is_dir():
        return [], []
    found, left = [], []
    files = (file for file in folder.iterdir() if file.suffix in _KINDS)
    for stem in sorted({file.stem for file in files} - set(besides)):
        at_hand = {kind: file for kind in _KINDS if (file := folder / (stem + kind)).is_file()}
        chosen = _choose(at_hand)
        if chosen is None:
            left.append(f"Figure {stem} is too large for this page. See {folder}.")
            continue
        try:
            wide = _is_wide(chosen)
        except _DAMAGE:
            left.append(f"Figure {stem} is left out, because {chosen} is cut short or damaged.")
            continue
        content = base64.b64encode(chosen.read_bytes()).decode()
        source = f"data:{_KINDS[chosen.suffix]};base64,{content}"
        name, light = stem.replace("_", " "), chosen.stem != "grains"
        found.append(Picture(name, source, light, wide))
    return found, left


def _is_wide(file: Path) -> bool:
    """Return whether a picture takes the page's width. Read it fully; errors are in `_DAMAGE`."""
    if file.suffix == ".svg":
        content = file.read_bytes()
        ElementTree.fromstring(content)
        head = content[:4000].decode(errors="replace")
        sides = re.search(r"viewBox=\"\S+ \S+ (\S+) (\S+)\"", head)
        return bool(sides) and float(sides[1]) > WIDE * float(sides[2])
    with Image.open(file) as image:
        for frame in ImageSequence.Iterator(image):
            frame.load()
        return image.width > WIDE * image.height


def _choose(files: dict[str, Path]) -> Path | None:
    """Return the file of a figure for the page: a small SVG, otherwise a bitmap."""
    sizes = {kind: file.stat().st_size for kind, file in files.items()}
    if sizes.get(".svg", LARGEST) <= LARGEST_LINES:
        return files[".svg"]
    for kind in (".png", ".gif"):
        if sizes.get(kind, LARGEST) < LARGEST:
            return files[kind]
    return None
