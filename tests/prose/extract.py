# SPDX-License-Identifier: GPL-2.0-or-later
"""Extract the sentences that users and developers read.

They are the text of the pages, the help of the commands, the docstrings of public Python names, and
the messages in Python, C++ and the shell script `run`.
"""

from __future__ import annotations

import argparse
import ast
import re
from collections.abc import Iterator
from inspect import cleandoc
from pathlib import Path

import attrs

from plastigran.cli import parser
from plastigran.engine.process import PROJECT

#: A string in code or a cell of a table counts as prose if it has at least this number of words.
WORDS = 4
_SENTENCE_END = re.compile(r"(?<=[.!?])\s+|(?<=[:;])\s+(?=[A-Z`*\[(\"])|\n+")
#: Parts of a sentence that are read as one word, in the order in which they are replaced.
_AS_ONE_WORD = (
    (r"``[^`]*``|`[^`]*`", "CODE"),
    (r"\$[^$]*\$", "VALUE"),
    (r" ?\[[^\]]*\]", ""),  # a unit, or the shape of an array
    (r"\S+(?: [-−+=*/<>≤≥|]+ \S*[^\s.,;:])+", "EQUATION"),
    (r"(\w[\w.-]*( \([^)]*\))?, ){4,}\w[\w.-]*", "LIST"),
)
_SECTION = re.compile(r"(Args|Attributes|Raises|Returns|Warns|Yields):")
_ITEM = re.compile(r"    [*\w, .]+: (.*)")
_STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')
_SHELL_TEXT = re.compile(
    r"\b(?:fail|say) (\"[^\"]*\"|'[^']*')|^  [a-z-]+(?: [A-Z_]+)?  +(\S.*)$", re.M
)


@attrs.frozen
class Sentence:
    """A sentence and its place.

    Attributes:
        place: File and line, or the command whose help contains the sentence.
        text: Text of the sentence. One word replaces each piece of code, value, equation or list
            of names.
    """

    place: str
    text: str


def all_sentences() -> Iterator[Sentence]:
    """Yield every sentence."""
    for page in [*PROJECT.glob("*.md"), *sorted((PROJECT / "docs").rglob("*.md"))]:
        yield from page_sentences(page)
    yield from help_sentences()
    for folder in ("postprocess", "benchmarks", "docs"):
        for module in sorted((PROJECT / folder).rglob("*.py")):
            yield from python_sentences(module)
    for folder in ("lammps", "liggghts", "plastigran", "python"):
        for file in sorted((PROJECT / "contact_models" / folder).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                yield from cpp_sentences(file)
    for literal, usage in _SHELL_TEXT.findall((PROJECT / "run").read_text(encoding="utf-8")):
        yield from _sentences("run", re.sub(r"\$\S+", "VALUE", literal.strip("\"'") or usage))


def _sentences(place: str, text: str, least_words: int = 2) -> Iterator[Sentence]:
    """Yield the sentences of a paragraph of Markdown."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    for pattern, word in _AS_ONE_WORD:
        text = re.sub(pattern, word, text)
    for sentence in _SENTENCE_END.split(text):
        sentence = sentence.strip(" *-_")
        if len(sentence.split()) >= least_words:
            yield Sentence(place, sentence)


def page_sentences(path: Path) -> Iterator[Sentence]:
    """Yield the sentences of a Markdown page, without code, equations and headings."""
    place = str(path.relative_to(PROJECT))
    page = path.read_text(encoding="utf-8")
    page = re.sub(r"\A---\n.*?\n---\n", "", page, flags=re.DOTALL)
    page = re.sub(r"^ *(```+|~~~+).*?^ *\1", "", page, flags=re.DOTALL | re.MULTILINE)
    page = re.sub(r"\$\$.*?\$\$|<!--.*?-->", "", page, flags=re.DOTALL)
    paragraph: list[str] = []
    for line in [*page.splitlines(), ""]:
        skipped = re.match(r"\s*(#|:::|<|\+\+\+|\(.*\)=$|$)|    ", line)
        alone = re.match(r"\s*(\||!\[)", line)
        if skipped or alone or re.match(r"\s*([-*]|\d+\.) ", line):
            yield from _sentences(place, " ".join(paragraph))
            paragraph = []
        if alone:
            for cell in re.split(r"(?<!\\)\|", line.strip(" !")):
                yield from _sentences(place, cell, WORDS)
        elif not skipped:
            paragraph.append(line.strip())


def help_sentences() -> Iterator[Sentence]:
    """Yield the sentences of the help of every command."""
    top = parser()
    (subparsers,) = (a for a in top._actions if isinstance(a, argparse._SubParsersAction))
    helps = {action.dest: action.help or "" for action in subparsers._choices_actions}
    for name, command in {"": top, **subparsers.choices}.items():
        texts = [helps.get(name, ""), command.description or "", command.epilog or ""]
        texts += [action.help or "" for action in command._actions]
        for line in "\n".join(texts).split("\n"):
            if not re.match(r"\s*(plastigran|\.venv|cd) ", line):
                yield from _sentences(f"plastigran {name} --help", line.replace("%%", "%"))


def python_sentences(path: Path) -> Iterator[Sentence]:
    """Yield the sentences of a Python module: docstrings of public names, messages and texts."""
    read: set[ast.AST] = set()  # nodes whose text has been read
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        place = f"{path.relative_to(PROJECT)}:{getattr(node, 'lineno', 1)}"
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            if not getattr(node, "name", "").startswith("_"):
                yield from docstring_sentences(place, ast.get_docstring(node) or "")
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            read.add(node.value)  # a docstring
        elif node not in read:
            read.update(ast.walk(node) if isinstance(node, ast.JoinedStr) else ())
            text = _text(node)
            if len(text.split()) >= WORDS:
                yield from _sentences(place, text)


def docstring_sentences(place: str, docstring: str) -> Iterator[Sentence]:
    """Yield the sentences of a docstring, without indented code."""
    paragraph: list[str] = []
    section = False
    for line in [*cleandoc(docstring).splitlines(), ""]:
        heading, item = _SECTION.fullmatch(line), _ITEM.match(line)
        section = bool(heading) or (section and (not line or line.startswith(" ")))
        is_code = line.startswith("    ") and not section
        if heading or is_code or not line or (section and item):
            yield from _sentences(place, " ".join(paragraph))
            paragraph = []
        if not heading and not is_code:
            paragraph.append(item[1] if section and item else line.strip())


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
            yield from _sentences(str(path.relative_to(PROJECT)), text.replace("\\n", "\n"))
