# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures that commands have drawn, as a page carries them."""

from __future__ import annotations

import base64
import re
from collections.abc import Collection
from pathlib import Path
from xml.etree import ElementTree

import attrs
from PIL import Image, ImageSequence

#: A picture of lines is carried as such up to this size [bytes], else its dots.
LARGEST_LINES = 120_000
#: A picture beyond this size is left out [bytes].
LARGEST = 500_000
#: Width over height from which a picture is wide.
WIDE = 1.7
_KINDS = {".svg": "image/svg+xml", ".png": "image/png", ".gif": "image/gif"}
#: What reading a damaged picture raises.
_DAMAGE = (
    OSError,
    SyntaxError,  # of an SVG, too
    ValueError,
    IndexError,
    Image.DecompressionBombError,
)


@attrs.frozen
class Picture:
    """A figure of a section.

    Attributes:
        name: The file's, in words.
        source: Its content, as an address of the page's own.
        light: Whether its ground is white: the page turns it dark with itself.
        wide: Whether it takes the page's width.
    """

    name: str
    source: str
    light: bool = True
    wide: bool = False


def read_pictures(folder: Path, besides: Collection[str] = ()) -> tuple[list[Picture], list[str]]:
    """The figures in a folder, each once, and sentences on those left out.

    Args:
        folder: Of the files.
        besides: Names without ending of figures that the page shows otherwise.
    """
    if not folder.is_dir():
        return [], []
    found, left = [], []
    files = (file for file in folder.iterdir() if file.suffix in _KINDS)
    for stem in sorted({file.stem for file in files} - set(besides)):
        at_hand = {kind: file for kind in _KINDS if (file := folder / (stem + kind)).is_file()}
        chosen = _choose(at_hand)
        if chosen is None:
            left.append(f"The figure {stem} is too large for this page; it is in {folder}.")
            continue
        try:
            wide = _is_wide(chosen)
        except _DAMAGE:
            left.append(f"The figure {stem} is left out: {chosen} is damaged or cut short.")
            continue
        content = base64.b64encode(chosen.read_bytes()).decode()
        source = f"data:{_KINDS[chosen.suffix]};base64,{content}"
        name, light = stem.replace("_", " "), chosen.stem != "grains"
        found.append(Picture(name, source, light, wide))
    return found, left


def _is_wide(file: Path) -> bool:
    """Whether a picture takes the page's width. It is read whole: errors are of `_DAMAGE`."""
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
    """The file of a figure that a page takes: lines before dots, while they are small."""
    sizes = {kind: file.stat().st_size for kind, file in files.items()}
    if sizes.get(".svg", LARGEST) <= LARGEST_LINES:
        return files[".svg"]
    for kind in (".png", ".gif"):
        if sizes.get(kind, LARGEST) < LARGEST:
            return files[kind]
    return None
