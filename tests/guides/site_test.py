# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The site that scripts/site makes: whole, with every link, searched from the disk, fit for a phone.

Usage: site_test.py BALCONY REPOSITORY
"""

import ast
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from html import unescape
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from guide import REPOSITORY, main, skip  # noqa: E402 (reads the other arguments)

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
PHONE = 390  # The width of a common phone, in pixels of CSS.
# Doxygen 1.9.4 links to a section of hidden classes that it does not write.
KNOWN = {"nested-classes"}
# For --dump-dom: the pages of a list that are wider than a phone, and what a slider does on the last.
MEASURE = """<!DOCTYPE html><title>wait</title><script>
const load = (page) => new Promise((done) => {
    const frame = document.createElement("iframe");
    frame.style = "width: %dpx; height: 800px; border: 0";
    frame.onload = () => done(frame);
    frame.src = page;
    document.documentElement.append(frame);
});
(async () => {
    const wide = [];
    for (const page of %s) {
        const frame = await load(page);
        if (frame.contentDocument.documentElement.scrollWidth > %d) wide.push(page);
        frame.remove();
    }
    const page = (await load("docs/gallery.html")).contentDocument;
    const [left, right] = page.querySelector(".pair").children;
    const apart = right.firstChild.getBoundingClientRect().top - left.firstChild.getBoundingClientRect().top;
    page.querySelector(".pair-choice input").click();
    const slider = page.querySelector(".pair input");
    slider.value = 25;
    slider.dispatchEvent(new Event("input"));
    document.title = JSON.stringify({
        wide, apart, over: right.firstChild.getBoundingClientRect().top - left.firstChild.getBoundingClientRect().top,
        clip: page.defaultView.getComputedStyle(right).clipPath});
})();
</script>"""


class Page(HTMLParser):
    """The anchors of a page and what it links to."""

    def __init__(self, file):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name"):
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name).resolve() / "site"
        subprocess.run([REPOSITORY / "scripts/site", cls.folder], check=True)

    def in_browser(self, page, budget):
        """The document that a page of the site has become after some milliseconds."""
        command = [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--allow-file-access-from-files",
                   f"--virtual-time-budget={budget}", "--dump-dom", f"file://{self.folder}/{page}"]
        return subprocess.run(command, check=True, capture_output=True, text=True, timeout=120).stdout

    def test_every_page_of_the_documentation_is_there(self):
        pages = ["README.md", *(file.relative_to(REPOSITORY) for file in
                                (REPOSITORY / "docs").rglob("*.md") if "site" not in file.parts)]
        self.assertGreater(len(pages), 40)
        for page in map(Path, pages):
            self.assertTrue((self.folder / page).with_suffix(".html").exists(), page)

    def test_the_reference_has_every_name_of_the_python_module(self):
        module = ast.parse((REPOSITORY / "python/balcony/__init__.py").read_text(encoding="utf-8"))
        names = next(ast.literal_eval(one.value) for one in module.body
                     if isinstance(one, ast.Assign) and one.targets[0].id == "__all__")
        anchors = Page(self.folder / "docs/site/python_reference.html").anchors
        self.assertGreater(len(names), 20)
        missing = {name for name in names if not {f"balcony.{name}", f"module-balcony.{name}"} & anchors}
        self.assertEqual(missing, set())
        self.assertIn("balcony.Camera.project", anchors)

    def test_every_link_leads_somewhere(self):
        pages = {file: Page(file) for file in self.folder.rglob("*.html")}
        self.assertGreater(len(pages), 300)
        broken = []
        for file, page in pages.items():
            for link in set(page.links):
                parts = urlsplit(link)
                if parts.scheme:
                    continue
                goal = (file.parent / unquote(parts.path)).resolve() if parts.path else file
                anchor = unquote(parts.fragment)
                if not goal.exists() or (anchor and goal in pages and anchor not in KNOWN
                                         and anchor not in pages[goal].anchors):
                    broken.append(f"{file.relative_to(self.folder)}: {link}")
        self.assertEqual(broken, [])

    def test_needs_nothing_from_elsewhere(self):
        for file in self.folder.rglob("*.html"):
            loaded = re.findall(r'<(?:script|img|link rel="stylesheet")[^>]*"(?:https?:)?//[^"]*"',
                                file.read_text(encoding="utf-8"))
            self.assertEqual(loaded, [], file)

    def test_is_searched_from_the_disk(self):
        found = self.in_browser("search.html?q=superellipse", 8000)
        self.assertIn("docs/stages/object-generators.html", found)
        self.assertIn("page(s) matching the search query", found)

    def test_fits_a_phone(self):
        pages = sorted(str(file.relative_to(self.folder)) for folder in ("docs", "editors")
                       for file in (self.folder / folder).rglob("*.html"))
        (self.folder / "measure.html").write_text(
            MEASURE % (PHONE, json.dumps(["index.html", "api/index.html", *pages]), PHONE))
        title = re.search("<title>(.*?)</title>", self.in_browser("measure.html", 60000))[1]
        seen = json.loads(unescape(title))
        self.assertEqual(seen["wide"], [])
        # The pictures of a pair are one below the other, and then one over the other.
        self.assertGreater(seen["apart"], 100)
        self.assertEqual(seen["over"], 0)
        self.assertIn("25%", seen["clip"])


if __name__ == "__main__":
    if not (BROWSER and shutil.which("sphinx-build") and shutil.which("doxygen")):
        skip("no Sphinx, Doxygen or browser", "guides site")
    main()
