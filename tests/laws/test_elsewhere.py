# SPDX-License-Identifier: GPL-2.0-or-later
"""Another project can use the headers of the laws with a copy of the folder and one -I option."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from plastigran import laws
from plastigran.engine.process import PROJECT

PROGRAM = """
#include <cstdio>
#include "plastigran/laws/LAW.h"
int main() {
  const plastigran::Body steel{2.1e11, 0.3, 3e8};
  const plastigran::CLASS law(plastigran::combine(steel, steel), {});
  plastigran::CLASS::State state;
  law.respond(0.005, 1e-5, state);
  std::printf("%.17g", law.respond(0.005, 0.9e-5, state).force);
}
"""


@pytest.fixture
def force(tmp_path):
    """`force(law, class_name, header)` compiles and runs a program of another project.

    The program prints the force of a law during unloading.
    """
    theirs = tmp_path / "their project"
    shutil.copytree(PROJECT / "contact_models" / "plastigran", theirs / "plastigran")

    def run(law: str, class_name: str, header: str | None = None) -> float:
        if header:
            (theirs / "plastigran" / "laws" / f"{law}.h").write_text(header)
        program = PROGRAM.replace("LAW", law).replace("CLASS", class_name)
        (theirs / "main.cpp").write_text(program)
        warnings = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
        compiler = ["g++", "-std=c++17", *warnings, "-I", ".", "main.cpp", "-o", "main"]
        subprocess.run(compiler, cwd=theirs, check=True)
        main = subprocess.run([theirs / "main"], capture_output=True, text=True, check=True)
        return float(main.stdout)

    return run


def expected(law: str) -> float:
    steel = laws.Body(2.1e11, 0.3, 3e8)
    contact = laws.LAWS[law](laws.combine(steel, steel))
    return float(contact.follow(0.005, [1e-5, 0.9e-5])["force"][-1])


def test_a_program_of_another_project_uses_a_law(force):
    found = force("kogut_etsion", "KogutEtsion")
    # The program is compiled without optimization, so round-off differs.
    assert found == pytest.approx(expected("kogut_etsion"), rel=1e-13)


def test_the_law_of_the_page_on_adding_one_compiles_and_is_thorntons(force):
    page = (PROJECT / "docs" / "add_a_law.md").read_text()
    header = re.search(r"```cpp\n(.*?)```", page, re.DOTALL)[1]
    found = force("constant_pressure", "ConstantPressure", header)
    # The page computes the same law in another order, so round-off differs.
    assert found == pytest.approx(expected("thornton"), rel=1e-12)
