# SPDX-License-Identifier: GPL-2.0-or-later
"""Sentences that users and developers read follow the rules of `rules.py`."""

from __future__ import annotations

import pytest
from extract import all_sentences, cpp_sentences, page_sentences, python_sentences
from rules import LONGEST, faults

#: Sentences that may break a rule, by their place and first 40 characters, with the reason.
EXCEPTIONS: dict[tuple[str, str], str] = {}


def test_every_sentence_follows_the_rules():
    excused, broken = set(), []
    for sentence in all_sentences():
        for fault in faults(sentence.text):
            key = sentence.place.split(":")[0], sentence.text[:40]
            excused.add(key)
            if key not in EXCEPTIONS:
                broken.append(f"{sentence.place}: {fault}: {sentence.text}")
    assert not broken, "\n".join(broken)
    assert not EXCEPTIONS.keys() - excused, "an exception that is not needed"
    assert len(EXCEPTIONS) <= 20 and all(EXCEPTIONS.values())


@pytest.mark.parametrize(
    ("sentence", "fault"),
    [
        ("word " * (LONGEST + 1), "31 words"),
        ("Refused are rigid bodies.", "start with the subject"),
        ("Told that a sphere flattens it has 8.6 %.", "start with the subject"),
        ("What contacts dissipate warms the grains.", "'what'"),
        ("It shows the energy of what yields.", "'what'"),
        ("Its energy is not that of its particles.", "that of"),
        ("The model knows no metal.", "do not know"),
        ("The first says which picture it wrote.", "do not know"),
        ("The other is finite elements.", "'the first' or 'the other'"),
        ("of the impact, m/s", "name the noun"),
        ("Of the contact.", "name the noun"),
        ("It is off, for deltas have no radius.", "because"),
        ("This is no table.", "is not a"),
        ("0.81 over hertz", "ratio"),
        ("The times were taken beside other work.", "ratio"),
        ("A run goes on.", "continues"),
        ("The run stops to every digit.", "bitwise identical"),
        ("A dent stays.", "residual indentation"),
        ("The engine stopped.", "LIGGGHTS"),
    ],
)
def test_a_fault_is_found(sentence, fault):
    assert any(fault in description for description in faults(sentence))


@pytest.mark.parametrize(
    "sentence",
    [
        "There is no overlap, so the force is zero.",
        "Of the plastic work, 84 % lies near the surface.",
        "The message names the value, what is allowed, and what to do.",
    ],
)
def test_a_plain_sentence_has_no_fault(sentence):
    assert not list(faults(sentence))


def test_sentences_of_a_page(tmp_path, monkeypatch):
    monkeypatch.setattr("extract.PROJECT", tmp_path)
    page = tmp_path / "page.md"
    page.write_text(
        "# Head\nOne `code` sentence,\nin two lines. Another one.\n\n"
        "| short cell | a cell with several words |\n\n```\nnot a sentence at all\n```\n"
    )
    assert [sentence.text for sentence in page_sentences(page)] == [
        "One CODE sentence, in two lines.",
        "Another one.",
        "a cell with several words",
    ]


def test_sentences_of_a_python_module(tmp_path, monkeypatch):
    monkeypatch.setattr("extract.PROJECT", tmp_path)
    module = tmp_path / "module.py"
    module.write_text(
        '"""A module in\none line.\n\n    code to leave out\n"""\n'
        'def public(x):\n    """Return it.\n\n    Args:\n        x: A number [m].\n    """\n'
        'def _private():\n    """Leave this out."""\n'
        'raise ValueError(f"the {name!r} is wrong; "\n    "give another one")\n'
    )
    assert {sentence.text for sentence in python_sentences(module)} == {
        "A module in one line.",
        "Return it.",
        "A number.",
        "the VALUE is wrong; give another one",
    }


def test_sentences_of_a_cpp_file(tmp_path, monkeypatch):
    monkeypatch.setattr("extract.PROJECT", tmp_path)
    source = tmp_path / "source.cpp"
    source.write_text(
        '// A comment to leave out.\nerror(("the " + name +\n " is wrong" " here"));\n'
    )
    assert [sentence.text for sentence in cpp_sentences(source)] == ["the VALUE is wrong here"]
