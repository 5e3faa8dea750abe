# SPDX-License-Identifier: GPL-2.0-or-later
"""Type checkers and editors find the public names of `import plastigran as pg`."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import jedi
import pytest

import plastigran as pg

#: Type that mypy reports for each public name, or the beginning of its text.
TYPES = {
    "RIGID": "plastigran.laws.Body",
    "Contact": "def (law: str, a: plastigran.materials.Material",
    "bulk": "types.ModuleType",
    "calibrate": "def (",
    "cite": "def (names: ",
    "collide": "def (laws: str",
    "laws": "types.ModuleType",
    "material": "def (name: ",
    "open": "def (folder: str",
    "laws.Thornton": "def (pair: plastigran.laws.MaterialPair",
    'Contact("mdr", "steel", RIGID, radius=1.0).yield_speed': "float",
}

EDITOR = f"""
import jedi, json
here = jedi.InterpreterEnvironment()
head = "import plastigran as pg\\n"
found = {{}}
for name in {pg.__all__}:
    script = jedi.Script(head + "pg." + name, environment=here)
    found[name] = [definition.full_name for definition in script.goto(2, 4, follow_imports=True)]
contact = head + 'pg.Contact("mdr", "steel", pg.RIGID, radius=1.0).'
members = [member.name for member in jedi.Script(contact, environment=here).complete()]
print(json.dumps({{"definitions": found, "contact": members}}))
"""


def test_public_names_have_types():
    assert sorted(pg.__all__) == sorted(pg._PUBLIC)
    assert set(pg.__all__) == {name for name in TYPES if name.isidentifier()}


def test_a_type_checker_knows_every_name(tmp_path):
    """mypy finds the type of each name, and reports an error for a name that does not exist."""
    script = tmp_path / "script.py"
    lines = [f"reveal_type({re.sub(r'^|(?<=, )(?=RIGID)', 'pg.', name)})" for name in TYPES]
    script.write_text("\n".join(["import plastigran as pg", *lines, "pg.Kontact", ""]))
    command = [sys.executable, "-m", "mypy", "--follow-imports", "silent", script.name]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    found = re.findall(r'note: Revealed type is "(.*)"', done.stdout)
    assert len(found) == len(TYPES), done.stdout + done.stderr
    for name, revealed in zip(TYPES, found, strict=True):
        assert revealed.startswith(TYPES[name]), name
    assert 'Module has no attribute "Kontact"' in done.stdout
    assert "Found 1 error" in done.stdout


@pytest.fixture(scope="module")
def editor():
    """Definitions that jedi finds without running code of the package.

    Python runs without `site`, because `site` runs the import hook of an editable installation.
    """
    paths = [Path(pg.__file__).parents[1], Path(jedi.__file__).parents[1]]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, paths))}
    done = subprocess.run(
        [sys.executable, "-S", "-c", EDITOR],
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


@pytest.mark.parametrize("name", pg.__all__)
def test_an_editor_finds_the_definition(editor, name):
    (found,) = editor["definitions"][name]
    assert found.startswith("plastigran.")


def test_an_editor_completes_a_contact(editor):
    members = {"restitution", "path", "impact", "yield_speed", "yield_overlap", "yield_force"}
    assert members <= set(editor["contact"])
