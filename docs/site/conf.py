"""The documentation site: scripts/docs. Nothing is loaded from the network, now or by a reader."""

import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, os.environ.get("TRIPUS_PACKAGE", str(ROOT / "build/release/python")))

import tripus  # noqa: E402

project = "Tripus"
author = "the authors of Tripus"
copyright = author
release = version = tripus.__version__

extensions = ["myst_nb", "sphinx.ext.autodoc"]
source_suffix = {".md": "myst-nb"}
exclude_patterns = ["site"]
root_doc = "index"

html_theme = "furo"
html_title = f"Tripus {release}"
html_static_path = []
html_show_sphinx = False
html_theme_options = {"source_view_link": ""}

# Tutorials are notebooks and run; an error in one is an error of the build.
nb_execution_mode = os.environ.get("TRIPUS_DOCS_EXECUTE", "force")
nb_execution_timeout = 120
nb_execution_raise_on_error = True
nb_merge_streams = True
# The widget manager and require.js would come from a network; no widget is used.
nb_ipywidgets_js = {}

myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
# The pages link to files of the repository as well.
suppress_warnings = ["myst.xref_missing", "myst.header", "misc.highlighting_failure"]

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_default_options = {"members": True}

_TABLE = re.compile(r"^\s*[\w.]+(, [\w.]+)*\s{2,}\S")


def _as_rst(app, what, name, obj, options, lines):
    """Docstrings are plain text: tables of names stay as they are, bars are bars."""
    out, block = [], []
    for line in [*lines, ""]:
        if line.strip():
            block.append(line)
            continue
        if block and _TABLE.match(block[0]) and not block[0].lstrip().startswith(">>>"):
            out += ["::", "", *("    " + each for each in block)]
        elif block and not block[0].lstrip().startswith(">>>"):
            out += [each.replace("|", r"\|").replace("*", r"\*") for each in block]
        else:
            out += block
        out.append("")
        block = []
    lines[:] = out


_CONTENTS = {
    "Tutorials": "tutorials/triangulation tutorials/solid tutorials/same-or-not",
    "Python": "python notebooks/drawing notebooks/metric notebooks/manifold notebooks/many api",
    "Reference": "diagrams meshing formats verdicts proof canonical embedding parameterise orthospectrum studies",
    "Theory": "theory notation architecture reliability",
}


def _with_contents(app, docname, source):
    """docs/index.md is for readers of the files; the site wants its contents as well."""
    if docname == "index":
        listed = " ".join(_CONTENTS.values()).split()
        others = sorted(
            page.relative_to(ROOT / "docs").with_suffix("").as_posix()
            for page in (ROOT / "docs").rglob("*.md")
        )
        more = " ".join(page for page in others if page not in [*listed, "index"])
        for caption, pages in {**_CONTENTS, "More": more}.items():
            if not pages:
                continue
            lines = "\n".join(pages.split())
            source[0] += f"\n```{{toctree}}\n:caption: {caption}\n:hidden:\n\n{lines}\n```\n"


def setup(app):
    app.connect("source-read", _with_contents)
    app.connect("autodoc-process-docstring", _as_rst)
