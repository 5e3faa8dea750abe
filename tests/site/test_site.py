# SPDX-License-Identifier: GPL-2.0-or-later
"""The site builds without warnings, its notebooks run, and all its links have targets."""

from __future__ import annotations

import re
import subprocess
import sys
from fcntl import LOCK_EX, flock
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag, urlsplit

import pytest
from commands import all_commands

from plastigran.cli import parser
from plastigran.engine.process import PROJECT

SITE = PROJECT / "build" / "site"
#: Elements whose files a browser loads by itself, and the attribute that names the file.
FETCHED = {"script": "src", "img": "src", "iframe": "src", "source": "src", "link": "href"}


class Page(HTMLParser):
    """Parsed HTML page.

    Attributes:
        links: Targets of its links.
        fetched: Addresses of files that a browser loads with the page.
        places: Its anchors, the names after `#` to which a link can point.
    """

    def __init__(self, path: Path):
        super().__init__()
        self.links: set[str] = set()
        self.fetched: set[str] = set()
        self.places: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        self.places |= {given[name] for name in ("id", "name") if name in given}
        if tag == "a" and "href" in given:
            self.links.add(given["href"])
        if tag in FETCHED and FETCHED[tag] in given and given.get("rel") != "canonical":
            self.fetched.add(given[FETCHED[tag]])


@pytest.fixture(scope="module")
def pages() -> dict[Path, Page]:
    """Build the site as `./run site` does, except unchanged pages; return its pages by path."""
    SITE.parent.mkdir(exist_ok=True)
    with open(SITE.with_suffix(".lock"), "w") as lock:
        flock(lock, LOCK_EX)
        script = PROJECT / "docs" / "site" / "build.py"
        built = subprocess.run([sys.executable, script, SITE], capture_output=True, text=True)
    assert built.returncode == 0, built.stderr[-4000:]
    return {path: Page(path) for path in SITE.rglob("*.html")}


def test_no_link_is_dead(pages):
    dead = []
    for path, page in pages.items():
        for link in page.links | page.fetched:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            place, anchor = urldefrag(link)
            target = (path.parent / unquote(urlsplit(place).path)).resolve() if place else path
            if not target.is_file():
                dead.append(f"{path.relative_to(SITE)}: {link}")
            elif anchor and target in pages and unquote(anchor) not in pages[target].places:
                dead.append(f"{path.relative_to(SITE)}: {link}")
    assert not dead


def test_the_site_loads_no_foreign_file(pages):
    """Pages and style sheets load scripts, styles, pictures and fonts from the site only."""
    foreign = {f for page in pages.values() for f in page.fetched if urlsplit(f).netloc}
    for sheet in (SITE / "_static").rglob("*.css"):
        foreign |= set(
            re.findall(r"(?:@import|url\()\s*[\"']?(https?:[^\"')]*)", sheet.read_text())
        )
    assert not foreign


def test_commands_public_names_and_laws_have_their_pages(pages):
    """The site has all commands and public Python names, and two pages for each law.

    One page describes the law; the other one describes its C++ header.
    """
    from plastigran import __all__ as public_names
    from plastigran import laws

    reference = (SITE / "reference" / "commands.html").read_text()
    missing = [c.prog for c in all_commands(parser()) if f"usage: {c.prog} " not in reference]
    assert not missing
    text = (SITE / "python.html").read_text()
    assert not [name for name in public_names if f"pg.{name}" not in text]
    for name in laws.LAWS:
        assert SITE / "laws" / f"{name}.html" in pages
        assert SITE / "reference" / "cpp" / "laws" / f"{name}.html" in pages


def test_the_notebooks_ran(pages):
    """Each notebook shows pictures and the output of its cells."""
    notebooks = sorted((PROJECT / "docs" / "notebooks").glob("*.md"))
    assert len(notebooks) >= 5
    for notebook in notebooks:
        text = (SITE / "notebooks" / notebook.with_suffix(".html").name).read_text()
        assert "&lt;Figure size" not in text, "a text replaces a figure"
        assert "cell_output" in text and re.search(r"_images/[\w.]+\.(svg|png)", text), notebook
