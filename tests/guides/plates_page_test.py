# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The page of the plates in a browser: whole, without anything from elsewhere, and no wider than a
phone.

Usage: plates_page_test.py BALCONY REPOSITORY
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from guide import BALCONY, REPOSITORY, main, skip  # noqa: E402 (reads the other arguments)

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
FACTS = {"width": 60, "height": 30, "passes": 16, "seconds": 0.5, "rays": 28800,
         "camera_share": 0.012}
MEASURED = [{"what": "pictures <wholly> visible", "value": 7, "at_least": 7, "met": True},
            {"what": "median anisotropy", "value": 1.3, "at_least": 1, "at_most": 1.25, "met": False}]
# What the page has become, for --dump-dom: its width beyond the window, and the height of a compared
# picture with the slider at both ends.
MEASURE = """<script>addEventListener("load", () => {
    const compare = document.querySelector(".compare"), slider = document.querySelector(".slider input");
    const height_at = (value) => {
        slider.value = value;
        slider.dispatchEvent(new Event("input"));
        return Math.round(compare.getBoundingClientRect().height);
    };
    const broken = [...document.images].filter((image) => image.loading != "lazy" && !image.naturalWidth);
    document.title = JSON.stringify({
        beyond: document.documentElement.scrollWidth - innerWidth, plate: height_at(100),
        pinhole: height_at(0), broken: broken.length});
});</script>"""


class PlatesPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.plates = sorted(path.name for path in (REPOSITORY / "plates").glob("[0-9][0-9]-*"))
        cls.draw("wide.png", "160x40")
        cls.draw("high.png", "80x60")
        for name in cls.plates:
            shutil.copy(cls.folder / "wide.png", cls.folder / f"{name}.png")
            (cls.folder / f"{name}.json").write_text(json.dumps(FACTS))
            (cls.folder / f"{name}.pinhole").write_text("high.png\n")
        (cls.folder / "properties.json").write_text(json.dumps({"1": MEASURED}))
        subprocess.run([sys.executable, "-B", REPOSITORY / "plates/page/make_page.py", cls.folder],
                       cwd=REPOSITORY, check=True)
        cls.page = (cls.folder / "index.html").read_text(encoding="utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def draw(cls, name, size):
        subprocess.run([BALCONY, "draw", "pinhole", "-o", cls.folder / name, "--size", size,
                        "--quiet"], check=True)

    def in_browser(self, width):
        (self.folder / "measured.html").write_text(self.page + MEASURE, encoding="utf-8")
        done = subprocess.run(
            [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             f"--window-size={width},1200", f"--user-data-dir={self.folder}/profile", "--dump-dom",
             (self.folder / "measured.html").as_uri()],
            capture_output=True, text=True, timeout=120, check=True)
        return json.loads(re.search(r"<title>(.*?)</title>", done.stdout)[1])

    def test_every_plate_has_a_section(self):
        for name in self.plates:
            self.assertIn(f'<section id="{name}">', self.page)
        self.assertEqual(self.page.count('type="range"'), len(self.plates))

    def test_nothing_comes_from_elsewhere(self):
        for address in re.findall(r'(?:src|href)="([^"]*)"', self.page):
            self.assertNotRegex(address, r"^(\w+:|/)")
        self.assertNotIn("@import", self.page)
        self.assertNotIn("url(", self.page)

    def test_measured_values(self):
        self.assertIn("pictures &lt;wholly&gt; visible", self.page)
        self.assertIn('<tr class="missed"><td>median anisotropy</td><td class="value">1.3</td>'
                      "<td>1 to 1.25</td>", self.page)

    def test_cameras_are_highlighted(self):
        self.assertIn('<span class="keyword">camera</span> <span class="name">superelliptic</span>',
                      self.page)
        self.assertIn('<span class="number">36</span><span class="unit">deg</span>', self.page)
        self.assertIn('<span class="comment">// All four walls', self.page)

    def test_the_commands_are_those_of_the_plate(self):
        self.assertIn("build_scene gallery gallery.glb --without-pictures-and-walls\n"
                      "balcony render gallery.glb --camera plates/02-superelliptic/camera.cam",
                      self.page)

    def test_fits_a_phone_and_a_desk(self):
        for width in (500, 1280):
            with self.subTest(width=width):
                seen = self.in_browser(width)
                self.assertLessEqual(seen["beyond"], 0)
                self.assertEqual(seen["broken"], 0)
                # Both pictures have the width of the frame, 4 : 1 and 4 : 3.
                self.assertAlmostEqual(seen["pinhole"] / seen["plate"], 3, delta=0.1)


if __name__ == "__main__":
    if not BROWSER:
        skip("no browser (chromium)")
    main()
