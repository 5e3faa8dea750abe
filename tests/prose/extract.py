# SPDX-License-Identifier: GPL-2.0-or-later
"""Extract the sentences that users read: pages, command help, messages in Python and C++."""

from __future__ import annotations

import argparse
import ast
import re
from collections.abc import Iterator
from pathlib import Path

import attrs

from plastigran.cli import parser
from plastigran.engine.process import PROJECT

#: Number of words from which a string of code is a message and not a name or a deck line.
WORDS = 4
_SENTENCE_END = re.compile(r"(?<=[.!?:;])\s+(?=[A-Z`*\[(\"])|\n+")
_STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


@attrs.frozen
class Sentence:
    """A sentence and its place.

    Attributes:
        place: File and line, or the command whose help contains the sentence.
        text: Text. Code is replaced by CODE, a value of a message by VALUE, and a list of names by
            LIST.
    """

    place: str
    text: str


def page_sentences(path: Path) -> Iterator[Sentence]:
    """Yield the sentences of a Markdown page, without code, equations, tables and headings."""
    place = str(path.relative_to(PROJECT))
    for paragraph in _paragraphs(path.read_text(encoding="utf-8")):
        for text in _split(paragraph):
            yield Sentence(place, text)


def _paragraphs(page: str) -> Iterator[str]:
    page = re.sub(r"\A---\n.*?\n---\n", "", page, flags=re.DOTALL)
    page = re.sub(r"^(```+|~~~+).*?^\1", "", page, flags=re.DOTALL | re.MULTILINE)
    page = re.sub(r"\$\$.*?\$\$|<!--.*?-->", "", page, flags=re.DOTALL)
    paragraph: list[str] = []
    for line in [*page.splitlines(), ""]:
        apart = re.match(r"\s*(\||#|!\[|:::|<|\+\+\+|\(.*\)=$|$)|    ", line)
        if apart or re.match(r"\s*([-*]|\d+\.) ", line):
            yield " ".join(paragraph)
            paragraph = []
        if not apart:
            paragraph.append(line.strip())


def _split(text: str) -> Iterator[str]:
    """Yield the sentences of a paragraph of Markdown."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"`[^`]*`", "CODE", text)
    text = re.sub(r"\$[^$]*\$", "VALUE", text)
    text = re.sub(r"([\w.-]+, ){5,}[\w.-]+", "LIST", text)
    for sentence in _SENTENCE_END.split(text):
        sentence = sentence.strip(" *-_")
        if len(sentence.split()) > 1:
            yield sentence


def help_sentences() -> Iterator[Sentence]:
    """Yield the sentences of the help of every command."""
    top = parser()
    (subparsers,) = (a for a in top._actions if isinstance(a, argparse._SubParsersAction))
    helps = {action.dest: action.help or "" for action in subparsers._choices_actions}
    for name, command in {"": top, **subparsers.choices}.items():
        texts = [helps.get(name, ""), command.description or "", command.epilog or ""]
        texts += [action.help or "" for action in command._actions]
        for text in texts:
            for line in text.split("\n"):
                if re.match(r"\s*(plastigran|\.venv|cd) ", line):
                    continue
                for sentence in _split(line.replace("%%", "%")):
                    yield Sentence(f"plastigran {name} --help", sentence)


def python_sentences(path: Path) -> Iterator[Sentence]:
    """Yield the sentences of the messages and texts of a Python module, without docstrings."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    inside: set[ast.AST] = set()
    for node in ast.walk(tree):
        if node in inside:
            continue
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            inside.add(node.value)  # a docstring
        if isinstance(node, ast.JoinedStr):
            inside.update(set(ast.walk(node)) - {node})
        text = _text(node)
        if len(text.split()) >= WORDS:
            place = f"{path.relative_to(PROJECT)}:{node.lineno}"
            yield from (Sentence(place, sentence) for sentence in _split(text))


def _text(node: ast.AST) -> str:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(_text(part) if isinstance(part, ast.Constant) else "VALUE"
                       for part in node.values)  # fmt: skip
    return ""


def cpp_sentences(path: Path) -> Iterator[Sentence]:
    """Yield the sentences of the strings of a C++ file; strings of one expression are joined."""
    code = re.sub(r"//[^\n]*|^\s*#[^\n]*", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    texts, end = [""], 0
    for literal in _STRING.finditer(code):
        between = code[end : literal.start()]
        if between.strip() == "":
            texts[-1] += literal[1]
        elif end and re.fullmatch(r"\s*(\+|<<)[^;?:{}\"]*(\+|<<)\s*", between.replace("::", "")):
            texts[-1] += f"VALUE{literal[1]}"
        else:
            texts.append(literal[1])
        end = literal.end()
    for text in texts:
        if len(text.split()) >= WORDS:
            for sentence in _split(text.replace("\\n", "\n")):
                yield Sentence(str(path.relative_to(PROJECT)), sentence)


def all_sentences() -> Iterator[Sentence]:
    """Yield every sentence of the pages, the help, and the messages in Python and C++."""
    for page in [*PROJECT.glob("*.md"), *sorted((PROJECT / "docs").rglob("*.md"))]:
        yield from page_sentences(page)
    yield from help_sentences()
    for module in sorted((PROJECT / "postprocess").rglob("*.py")):
        yield from python_sentences(module)
    for folder in ("liggghts", "plastigran", "python"):
        for file in sorted((PROJECT / "contact_models" / folder).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                yield from cpp_sentences(file)
