# SPDX-License-Identifier: GPL-2.0-or-later
"""Sources are the same in BibTeX, in CITATION.cff and on the pages of the laws."""

from __future__ import annotations

import re
import tomllib
from unicodedata import normalize

import pytest
import yaml

from plastigran import laws
from plastigran.citation import SOFTWARE, cite, entries, fields, subjects
from plastigran.cli import main
from plastigran.engine.process import PROJECT

CFF = yaml.safe_load((PROJECT / "CITATION.cff").read_text())
SOURCES = {key: fields(entry) for key, entry in entries().items() if key != SOFTWARE}


def plain(text: str) -> str:
    """Return a field of BibTeX without braces and accents."""
    text = re.sub(r"""\\["'`^]""", "", re.sub(r"[{}]", "", text))
    return normalize("NFKD", text).encode("ascii", "ignore").decode()


def test_every_law_has_sources_and_no_other_name_has():
    assert set(subjects()) == {*laws.LAWS, "rate_factor"}
    assert len(SOURCES) == len(CFF["references"])


@pytest.mark.parametrize(
    "reference", CFF["references"], ids=lambda r: f"{r['start']}" if "start" in r else r["title"]
)
def test_citation_file_and_bibtex_have_the_same_work(reference):
    found = [s for s in SOURCES.values() if plain(s["title"]) == plain(reference["title"])]
    assert len(found) == 1
    source = found[0]
    names = [f"{a['family-names']}, {a['given-names']}" for a in reference["authors"]]
    assert plain(source["author"]) == plain(" and ".join(names))
    assert source["year"] == str(reference["year"])
    assert source.get("volume") == (str(reference["volume"]) if "volume" in reference else None)
    assert source.get("pages") == reference.get("start")
    if "journal" in reference:
        assert plain(source["journal"]) == plain(reference["journal"])
    named = {name for name in laws.LAWS if re.search(rf"\b{name}\b", reference["notes"])}
    assert set(source["keywords"].split(", ")) == (named or {"rate_factor"})


def test_the_version_is_the_package_s():
    software = fields(entries()[SOFTWARE])
    project = tomllib.loads((PROJECT / "pyproject.toml").read_text())["project"]
    assert software["version"] == CFF["version"] == project["version"]
    assert software["title"] == CFF["title"]
    page = (PROJECT / "docs" / "citing.md").read_text()
    assert cite() in page


@pytest.mark.parametrize("law", sorted(set(laws.LAWS) - {"universal"}))
def test_a_law_s_page_names_its_sources(law):
    """The page has the family name of the first author and the year of each source."""
    page = plain((PROJECT / "docs" / "laws" / f"{law}.md").read_text())
    for key in subjects()[law]:
        source = SOURCES[key]
        first = plain(source["author"]).split(",")[0]
        assert first in page and source["year"] in page, key


def test_command(capsys):
    assert main(["cite", "kogut_etsion", "stronge"]) == 0
    said = capsys.readouterr().out
    assert said.startswith("@software{plastigran,")
    # `kogut_etsion` and `stronge` have five sources. Zhang & Vu-Quoc (2002) is one for `stronge`.
    assert said.count("@article") + said.count("@book") == 5
    assert main(["cite", "universal"]) == 0
    assert capsys.readouterr().out.startswith("% universal is a law of this software; cite the")
    assert main(["cite", "nix"]) == 1
    assert "no citation for 'nix'. Available names: brake_2012" in capsys.readouterr().err


def test_all_entries_are_cited_once():
    said = cite(list(subjects()))
    assert all(said.count(f"{{{key},\n") == 1 for key in entries())
