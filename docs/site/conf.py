# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""How Sphinx makes the site of README.md and docs/: scripts/site runs it."""

import re
import sys
from pathlib import Path

import pygments.token as token
from pygments.lexer import Lexer

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(REPOSITORY / "editors"), str(REPOSITORY / "python")]

from cam_scopes import class_of, scopes  # noqa: E402 (found there)

project = "Balcony"
html_title = project
html_theme = "furo"
highlight_language = "none"
html_copy_source = False
# OpenCV's "%YAML:1.0" is no YAML of the standard.
suppress_warnings = ["misc.highlighting_failure"]
html_static_path = ["static"]
html_css_files = ["pairs.css"]
html_js_files = ["pairs.js"]
templates_path = ["templates"]
html_sidebars = {"**": ["sidebar/brand.html", "sidebar/search.html", "sidebar/scroll-start.html",
                        "sidebar/navigation.html", "reference.html", "sidebar/scroll-end.html"]}
extensions = ["myst_parser", "sphinx.ext.autodoc"]
# The reference of the Python module is made of its texts, without its library.
autodoc_mock_imports = ["balcony._balcony"]
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True
add_module_names = False
default_role = "code"
myst_enable_extensions = ["html_image"]
myst_heading_anchors = 4
root_doc = "README"
include_patterns = ["README.md", "CHANGELOG.md", "docs/**.md", "editors/README.md",
                    "packaging/README.md", "docs/site/python_reference.rst"]
exclude_patterns = ["build", "out", "studio"]

# What Pygments calls the scopes of a camera file, by the beginning of a scope.
TOKENS = {
    "comment": token.Comment,
    "constant.language": token.Name.Constant,
    "constant.numeric": token.Number,
    "entity.name.function": token.Name.Function,
    "entity.name.type": token.Name.Class,
    "keyword.operator": token.Operator,
    "keyword": token.Keyword,
    "storage.type": token.Keyword.Declaration,
    "string": token.String,
    "support.function": token.Name.Builtin,
    "variable": token.Name.Variable,
}


class CameraLexer(Lexer):
    def get_tokens_unprocessed(self, text):
        for begin, part, scope in scopes(text):
            yield begin, class_of(TOKENS, scope) or token.Text, part


def contents(caption, pages):
    """A list of pages for the side bar."""
    return "\n".join(["", "```{toctree}", ":hidden:", f":caption: {caption}", "", *pages, "```", ""])


def listed(text):
    """The pages that the first column of a page's tables links to."""
    return [page.removesuffix(".md") for page in
            dict.fromkeys(re.findall(r"^\| \[[^]]*\]\(([^)#]*)", text, re.MULTILINE))]


def side_bar(page):
    """What is appended to a page, so that the side bar has what its tables list."""
    if page == "README":
        text = (REPOSITORY / "docs/README.md").read_text(encoding="utf-8")
        sections = re.findall(r"^## (.*)\n((?:(?!## ).*\n)*)", text, re.MULTILINE)
        lists = [contents(caption, [f"docs/{name}" for name in listed(rows)])
                 for caption, rows in sections]
        return "".join([*lists, contents("More", ["docs/README", "docs/site/python_reference",
                                                   "editors/README", "packaging/README", "CHANGELOG"])])
    if page == "docs/stages/README":
        text = (REPOSITORY / "docs/stages/README.md").read_text(encoding="utf-8")
        return contents("Stages", listed(text))
    return ""


def without_folders(text, folder):
    """Links to folders of the repository, which a site does not have, become plain text."""
    return re.sub(r"\[([^]]*)\]\(([^)#:]+)\)",
                  lambda link: link[1] if (folder / link[2]).is_dir() else link[0], text)


def read_source(_, page, source):
    folder = (REPOSITORY / page).parent
    source[0] = without_folders(source[0], folder) + side_bar(page)


def examples_as_code(_, kind, name, thing, options, lines):
    """Indented paragraphs of a Python text are examples."""
    for at in range(len(lines) - 1, 0, -1):
        if lines[at].startswith("    ") and not lines[at - 1]:
            lines[at:at] = [".. code-block:: python", ""]


def setup(app):
    app.add_lexer("cam", CameraLexer)
    app.connect("autodoc-process-docstring", examples_as_code)
    app.connect("source-read", read_source)
