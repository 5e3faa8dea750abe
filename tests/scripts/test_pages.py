# SPDX-License-Identifier: GPL-2.0-or-later
"""Python on the pages names what there is."""

from __future__ import annotations

import ast
import re
from importlib import import_module
from textwrap import dedent

import pytest

from plastigran.engine.process import PROJECT

PAGES = [PROJECT / "README.md", *sorted((PROJECT / "docs").rglob("*.md"))]
BLOCKS = [
    pytest.param(block, id=f"{page.relative_to(PROJECT)}-{number}")
    for page in PAGES
    for number, block in enumerate(re.findall(r"```python\n(.*?)```", page.read_text(), re.DOTALL))
]


@pytest.mark.parametrize("block", BLOCKS)
def test_imports_of_a_page_are_there(block):
    """Of the package, with every name taken from the package's modules and from `pg`."""
    tree = ast.parse(dedent(block))
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module.startswith("plastigran"):
            module = import_module(node.module)
            assert all(hasattr(module, name.name) for name in node.names), ast.unparse(node)
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            if node.value.id == "pg":
                assert hasattr(import_module("plastigran"), node.attr), ast.unparse(node)


def test_pages_have_python():
    assert len(BLOCKS) > 5
