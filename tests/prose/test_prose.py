# SPDX-License-Identifier: GPL-2.0-or-later
"""Sentences that users read follow the rules of `rules.py`."""

from __future__ import annotations

import pytest
from extract import all_sentences, cpp_sentences, page_sentences, python_sentences
from rules import LONGEST, faults

#: Sentences that may break a rule, by their place and how they begin, with the reason. At most 20.
EXCEPTIONS: dict[tuple[str, str], str] = {}


def test_every_sentence_keeps_the_rules():
    excused, broken = set(), []
    for sentence in all_sentences():
        for fault in faults(sentence.text):
            key = sentence.place.split(":")[0], sentence.text[:40]
            excused.add(key)
            if key not in EXCEPTIONS:
                broken.append(f"{sentence.place}: {fault}: {sentence.text}")
    assert not broken, "\n".join(broken)
    assert not EXCEPTIONS.keys() - excused, "an exception that is not needed"
    assert len(EXCEPTIONS) <= 20


@pytest.mark.parametrize(
    ("sentence", "fault"),
    [
        ("word " * (LONGEST + 1), "31 words"),
        ("Refused are rigid bodies.", "start with the subject"),
        ("Its energy is not that of its particles.", "that of"),
        ("The model knows no metal.", "do not know"),
        ("It is off, for deltas have no radius.", "because"),
        ("This is no table.", "is not a"),
        ("A run goes on.", "continues"),
        ("The run stops to every digit.", "bitwise identical"),
        ("A dent stays.", "residual indentation"),
        ("The engine stopped.", "LIGGGHTS"),
    ],
)
def test_a_fault_is_found(sentence, fault):
    assert any(fault in found for found in faults(sentence))


def test_a_plain_sentence_has_no_fault():
    assert not list(faults("There is no overlap, so the force is zero."))


def test_sentences_are_found_in_their_sources(tmp_path, monkeypatch):
    """Wrapped lines are joined. Code, tables and docstrings are left out."""
    monkeypatch.setattr("extract.PROJECT", tmp_path)
    page, module, source = (tmp_path / name for name in ("page.md", "module.py", "source.cpp"))
    page.write_text("# Head\nOne `code` sentence,\nin two lines. Another one.\n\n| a | table |\n")
    module.write_text(
        '"""A docstring that is left out."""\n'
        'raise ValueError(f"the {name!r} is wrong; "\n    "give another one")\n'
    )
    source.write_text(
        '// A comment to leave out.\nerror(("the " + name +\n " is wrong" " here"));\n'
    )
    texts = {
        "page": [sentence.text for sentence in page_sentences(page)],
        "module": [sentence.text for sentence in python_sentences(module)],
        "source": [sentence.text for sentence in cpp_sentences(source)],
    }
    assert texts == {
        "page": ["One CODE sentence, in two lines.", "Another one."],
        "module": ["the VALUE is wrong; give another one"],
        "source": ["the VALUE is wrong here"],
    }
