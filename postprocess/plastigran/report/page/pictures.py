# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures that earlier commands wrote, encoded for the HTML page."""

from __future__ import annotations

import base64
import re
from collections.abc import Collection
from pathlib import Path
from xml.etree import ElementTree

import attrs
from PIL import Image, ImageSequence

#: Largest SVG file in a page [bytes]. If an SVG file is larger, the page contains the bitmap of the
#: same figure.
LARGEST_SVG = 120_000
#: Largest bitmap in a page [bytes].
LARGEST_BITMAP = 500_000
#: Width / height above which a picture takes the full width of the page.
WIDE = 1.7
#: MIME types by suffix, preferred types first.
_MIME_TYPES = {".svg": "image/svg+xml", ".png": "image/png", ".gif": "image/gif"}
#: Exceptions that reading a damaged picture raises. A damaged SVG file raises SyntaxError.
_DAMAGE = (OSError, SyntaxError, ValueError, IndexError, Image.DecompressionBombError)


@attrs.frozen
class Picture:
    """Figure in a section of a page.

    Attributes:
        name: Name of the file without suffix, in words.
        source: Content of the file as a data URL.
        light: Whether the background is white. The dark mode of the page darkens such figures.
        wide: Whether the figure takes the full width of the page.
    """

    name: str
    source: str
    light: bool
    wide: bool


def read_pictures(folder: Path, replaced: Collection[str] = ()) -> tuple[list[Picture], list[str]]:
    """Return the figures in a folder for the page, and sentences about figures that are left out.

    `replaced` are names (without suffix) of figures that are not needed, because the page has an
    interactive chart or the view of grains instead.
    """
    if not folder.is_dir():
        return [], []
    pictures, missing = [], []
    stems = {file.stem for file in folder.iterdir() if file.suffix in _MIME_TYPES}
    for stem in sorted(stems - set(replaced)):
        file = _choose(folder, stem)
        if file is None:
            missing.append(f"Figure {stem} is too large for this page. See {folder}.")
            continue
        try:
            wide = _is_wide(file)
        except _DAMAGE:
            missing.append(f"Figure {stem} is left out, because {file} is cut short or damaged.")
            continue
        content = base64.b64encode(file.read_bytes()).decode()
        source = f"data:{_MIME_TYPES[file.suffix]};base64,{content}"
        pictures.append(Picture(stem.replace("_", " "), source, stem != "grains", wide))
    return pictures, missing


def _choose(folder: Path, stem: str) -> Path | None:
    """Return the file of a figure for the page: the SVG file if it is small, otherwise a bitmap."""
    for suffix in _MIME_TYPES:
        file = folder / (stem + suffix)
        limit = LARGEST_SVG if suffix == ".svg" else LARGEST_BITMAP
        if file.is_file() and file.stat().st_size <= limit:
            return file
    return None


def _is_wide(file: Path) -> bool:
    """Return whether a picture is wide; the whole file is read to detect damage.

    Raises:
        One of `_DAMAGE`: The file is damaged.
    """
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
