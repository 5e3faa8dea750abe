# SPDX-License-Identifier: GPL-2.0-or-later
"""Settings of Sphinx for the web site of the docs, which `./run site` builds."""

from importlib.metadata import version as version_of

project = "Plastigran"
author = "The maintainers of Plastigran"
copyright = author
release = version = version_of("plastigran")

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "sphinx_external_toc",
]
exclude_patterns = ["site", "*.py", "_build"]
external_toc_path = "toc.yml"  # written by build.py

# Pages in the Markdown dialect of git hosts.
myst_heading_anchors = 4
myst_enable_extensions = ["smartquotes"]
suppress_warnings = ["ref.python"]  # several classes have members of the same name

# Notebooks are Markdown pages whose code runs during the build. An error in this code stops the
# build.
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 120
nb_execution_show_tb = True
nb_merge_streams = True

# The Python reference is generated from docstrings (docs/site/pages.py).
add_module_names = False
toc_object_entries = False  # each page would otherwise contain two thousand entries
autodoc_member_order = "bysource"
autodoc_type_aliases = {"ArrayLike": "ArrayLike"}
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
default_role = "code"
napoleon_numpy_docstring = False
napoleon_use_ivar = True

# The theme has a light and a dark mode, and loads no file from other servers.
html_theme = "furo"
html_title = "Plastigran"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_show_sourcelink = False
highlight_language = "text"
copybutton_prompt_text = "$ "


def process_docstring(app, what, name, found, options, lines):
    """Convert docstrings from plain text: escape |x|, and keep indented blocks of modules."""
    text, literal = [], False
    for line in lines:
        indented = line.startswith("    ")
        if what == "module" and indented and text and not text[-1].strip() and not literal:
            text += ["::", ""]
            literal = True
        elif line.strip() and not indented:
            literal = False
        text.append(line if literal else line.replace("|", r"\|"))
    lines[:] = text


def rejoin_sentence(app, what, name, found, options, lines):
    """Undo the split of a property's docstring at a colon. The part before it is not a type."""
    kinds = [line for line in lines if line.startswith(":type: ")]
    if what in ("property", "attribute") and kinds:
        rest = [line for line in lines if line not in kinds]
        lines[:] = [f"{kinds[0].removeprefix(':type: ')}: {rest[0]}", *rest[1:]]


def skip_member(app, what, name, found, skip, options):
    """Skip the names that a module imports from other packages."""
    module = getattr(found, "__module__", None) or ""
    return True if what == "module" and not module.startswith("plastigran") else None


def setup(app):
    app.connect("autodoc-process-docstring", process_docstring)
    app.connect("autodoc-process-docstring", rejoin_sentence, priority=600)  # after napoleon
    app.connect("autodoc-skip-member", skip_member)
