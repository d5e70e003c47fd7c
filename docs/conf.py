"""The site: pages, notebooks and docstrings of this repository, as Sphinx shows them.

    python -m sphinx -W -c docs . build/site
    python -m sphinx -b linkcheck -c docs . build/linkcheck

The first command checks links and anchors between pages, and that every public name has its place.
The second one asks the network for all other addresses, and is no part of `.ci/run`. The source
folder is the repository itself, so links between its files hold in both. No notebook and no
example is run. What only the site has stands in `docs/site/`.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.pycode import ModuleAnalyzer
from sphinx.util.logging import getLogger

import matrixworld

LOGGER = getLogger(__name__)
REPOSITORY = Path(__file__).resolve().parent.parent

project, author = "matrixworld", "the authors of matrixworld"
version = release = matrixworld.__version__
root_doc = "README"
include_patterns = [
    "*.md",
    "docs/**",
    "benchmarks/*.md",
    "evolution/*.md",
    "evolution/games/*.md",
    "evolution/maps/**",
    "evolution/results/**.md",
    "evolution/results/**.png",
    "tutorials/**",
    "web/README.md",
]
exclude_patterns = ["docs/site/contents.md", "docs/site/templates", "docs/class_material"]
templates_path = [str(REPOSITORY / "docs/site/templates")]

extensions = ["myst_nb", "numpydoc", "sphinx.ext.autosummary"]
# Tables of results are reached from pages, not from the contents.
suppress_warnings = ["toc.not_included", "myst.header"]
nb_execution_mode = "off"
myst_heading_anchors = 4
myst_enable_extensions = ["dollarmath"]

API = (REPOSITORY / "docs/site/api.md").read_text("utf-8")
autosummary_context = {"pages": re.findall(r"^   (matrixworld.*)$", API, re.M)}
autosummary_ignore_module_all = False
autosummary_imported_members = True
autodoc_typehints = "none"  # docstrings describe all parameters
default_role = "py:obj"
numpydoc_show_class_members = False  # the template of classes lists them

html_theme = "furo"
html_title = "matrixworld"
# Pages that work alone lie beside the first page of the site.
DOCS = REPOSITORY / "docs"
html_extra_path = [
    str(page) for page in sorted({*DOCS.glob("*.html"), *DOCS.glob("class_material/*.html")})
]


def add_contents(app: Sphinx, document: str, source: list[str]) -> None:
    """Add the contents to the first page, and the teacher's notebooks, if made, to their page."""
    if document == root_doc:
        source[0] += "\n" + (REPOSITORY / "docs/site/contents.md").read_text("utf-8")
    if document == "docs/teachers" and (REPOSITORY / "tutorials/teacher").is_dir():
        source[0] += "\n```{toctree}\n:glob:\n\n../tutorials/teacher/*\n```\n"


def link_whole_pages(app: Sphinx, document: str, source: list[str]) -> None:
    """Open pages that work alone, at their place, where Sphinx would offer a copy to download."""
    names = "|".join(Path(page).stem for page in html_extra_path)
    link = rf"\[([^][]+)\]\((?:[\w./]*/)?((?:{names})\.html(?:#[^)]*)?)\)"
    up = "../" * document.count("/")
    source[0] = re.sub(link, rf"<a href='{up}\2'>\1</a>", source[0])


def name_anchors(app: Sphinx, tree: nodes.document) -> None:
    """Make targets of the anchors that Markdown pages write as HTML, such as in the glossary."""
    slugs = app.env.metadata[app.env.docname].setdefault("myst_slugs", {})
    for node in list(tree.findall(nodes.raw)):
        if found := re.fullmatch(r'<a id="([^"]+)">', node.astext()):
            node.replace_self(nodes.target("", "", ids=[found[1]]))
            slugs[found[1]] = (None, found[1], found[1])


def drop_links_to_folders(app: Sphinx, tree: nodes.document) -> None:
    """Leave only the text of links to folders, which a site has no page for."""
    here = (REPOSITORY / app.env.docname).parent
    for link in list(tree.findall(addnodes.pending_xref)):
        if (here / link["reftarget"]).is_dir():
            link.replace_self(link.children)


def show_markdown(
    app: Sphinx, what: str, name: str, it: Any, options: Any, lines: list[str]
) -> None:
    """Write the tables and headings of Markdown in docstrings as reStructuredText."""
    shown: list[str] = []
    for line in lines:
        indent, text = line[: len(line) - len(line.lstrip())], line.strip()
        if re.fullmatch(r"\|[| -]+", text):
            continue
        if text.startswith("| "):
            if not shown[-1].strip():
                shown += [indent + ".. list-table::", indent + "   :header-rows: 1", ""]
            cells = [cell.strip() for cell in text.strip("|").split(" | ")]
            bullets = ["*", *" " * (len(cells) - 1)]
            shown += [f"{indent}   {b} - {c}" for b, c in zip(bullets, cells, strict=True)]
        elif text.startswith("## "):
            shown += [f"{indent}.. rubric:: {text[3:]}", ""]
        else:
            shown.append(line)
    lines[:] = shown


def describe_data(
    app: Sphinx, what: str, name: str, it: Any, options: Any, lines: list[str]
) -> None:
    """Use the text below a constant in the module that makes it."""
    place = ("", name.rpartition(".")[2])
    ours = [module for module in sys.modules if re.match(r"matrixworld(?!\._core)", module)]
    for module in ours if what == "data" else []:
        if vars(sys.modules[module]).get(place[1]) is it:
            texts = ModuleAnalyzer.for_module(module).find_attr_docs()
            lines[:] = texts.get(place, lines)


def find_public_names(app: Sphinx, env: BuildEnvironment) -> None:
    """Warn of public names that no page describes; the index, one click away, has all others."""
    python = env.domains.python_domain
    for module in python.modules:
        for name in getattr(sys.modules.get(module), "__all__", []):
            if f"{module}.{name}" not in python.objects:
                LOGGER.warning("%s.%s is public, and no page describes it", module, name)


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect what this site does to the events of Sphinx."""
    app.connect("source-read", add_contents)
    app.connect("source-read", link_whole_pages)
    app.connect("doctree-read", name_anchors)
    app.connect("doctree-read", drop_links_to_folders)
    app.connect("env-check-consistency", find_public_names)
    app.connect("autodoc-process-docstring", describe_data, priority=300)
    app.connect("autodoc-process-docstring", show_markdown, priority=400)  # before numpydoc
    return {"parallel_read_safe": True, "parallel_write_safe": True}
