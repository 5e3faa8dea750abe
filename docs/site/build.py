# SPDX-License-Identifier: GPL-2.0-or-later
"""Build a web site from the pages in docs: `./run site` writes build/site/index.html.

The pages are copied to a folder with links to the other folders of the project, so that links in
the pages work there. Pages that are generated from the code are written to the same folder. Sphinx
converts all pages. A warning of Sphinx is an error.
"""

from __future__ import annotations

import fnmatch
import os
import re
import sys
from hashlib import sha256
from pathlib import Path
from shutil import copy2, ignore_patterns

import yaml
from pages import write_pages
from sphinx.cmd.build import main as sphinx

import plastigran
from plastigran import laws

PROJECT = Path(__file__).resolve().parents[2]
#: Pages of the project's top folder that belong to the site.
TOP = ("CONTRIBUTING.md", "CODE_OF_CONDUCT.md", "CHANGELOG.md")


def stage(source: Path) -> Path:
    """Write the input of Sphinx, and return the folder of the pages.

    Unchanged files keep their time of modification.
    """
    pages = source / "docs"
    pages.mkdir(parents=True, exist_ok=True)
    for folder in ("inputs", "contact_models", "tests", "postprocess", "benchmarks", "examples"):
        link = source / folder
        if not link.is_symlink():
            link.symlink_to(PROJECT / folder, target_is_directory=True)
    kept = set()
    skip = ignore_patterns("__pycache__", "*.pyc")
    for folder, folders, files in os.walk(PROJECT / "docs"):
        folders[:] = [name for name in folders if name not in skip(folder, folders)]
        for name in files:
            place = Path(folder).relative_to(PROJECT / "docs") / name
            kept.add(place)
            _copy(Path(folder) / name, pages / place)
    for name in TOP:
        text = (PROJECT / name).read_text().replace("](docs/", "](")
        _write(pages / name, text)
    kept |= {Path(name) for name in TOP}
    kept |= {path.relative_to(pages) for path in write_pages(pages, _write)}
    for path in [path for path in pages.rglob("*.*") if path.relative_to(pages) not in kept]:
        path.unlink()
    return pages


def navigation(pages: Path) -> str:
    """Return the table of contents: toc.yml with its patterns replaced by the matching pages.

    If the title of a matching page has a colon, the text before the colon is the entry, such as the
    name of a law.
    """
    contents = yaml.safe_load((PROJECT / "docs" / "site" / "toc.yml").read_text())
    found = [path.relative_to(pages).with_suffix("") for path in sorted(pages.rglob("*.[mr][ds]*"))]
    named = {contents["root"]}

    def fill(node: dict) -> None:
        entries = []
        for entry in node.get("entries", []):
            if "glob" in entry:
                matches = fnmatch.filter(map(str, found), entry["glob"])
                entries += [_entry(pages, Path(page)) for page in matches]
            else:
                entries.append(entry)
        for entry in entries:
            named.add(entry["file"])
            fill(entry)
        node |= {"entries": entries} if entries else {}
        for tree in node.get("subtrees", []):
            fill(tree)

    fill(contents)
    further = [_entry(pages, page) for page in found if str(page) not in named]
    if further:
        contents["subtrees"].append({"caption": "Further", "entries": further})
    return yaml.safe_dump(contents, sort_keys=False)


def _entry(pages: Path, page: Path) -> dict[str, str]:
    path = next(path for path in pages.glob(f"{page}.*") if path.suffix in (".md", ".rst"))
    heading = re.search(r"^# (.+)$", path.read_text(), re.MULTILINE)
    before, colon, _ = heading[1].partition(": ") if heading else ("", "", "")
    return {"file": str(page)} | ({"title": before.replace("`", "")} if colon else {})


def build(target: Path) -> int:
    """Build the site into a folder. Return 0 if Sphinx gave no warning."""
    pages = stage(target.parent / f"{target.name}_pages")
    _write(pages / "toc.yml", navigation(pages))
    doctrees = target.parent / f"{target.name}_doctrees"
    state, last = _state(pages), doctrees / "state.txt"
    if not last.exists() or last.read_text() != state:
        (doctrees / "environment.pickle").unlink(missing_ok=True)  # read all pages again
    words = ["-W", "--keep-going", "-q", "-d", str(doctrees)]
    status = sphinx([*words, "-c", str(PROJECT / "docs" / "site"), str(pages), str(target)])
    if status:  # read all pages next time, so that Sphinx repeats its warnings
        (doctrees / "environment.pickle").unlink(missing_ok=True)
    _write(last, state)
    return status


def _state(pages: Path) -> str:
    """Return a hash of all files on which every page may depend.

    The hash covers the names of the pages, because Sphinx resolves links when it reads a page. It
    also covers the package, whose code notebooks and references run.
    """
    names = sorted(str(path.relative_to(pages)) for path in pages.rglob("*.*"))
    digest = sha256()
    for path in [*sorted(Path(plastigran.__file__).parent.rglob("*.py")), Path(laws.__file__)]:
        digest.update(path.read_bytes())
    return "\n".join([digest.hexdigest(), *names])


def _copy(path: Path, to: Path) -> None:
    to.parent.mkdir(parents=True, exist_ok=True)
    if not to.exists() or to.stat().st_mtime != path.stat().st_mtime:
        copy2(path, to)


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else PROJECT / "build" / "site"
    status = build(target.absolute())
    print(f"the site is {target / 'index.html'}" if status == 0 else "the site has errors: above")
    sys.exit(status)
