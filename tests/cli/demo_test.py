# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony demo: the first command of whoever has installed Balcony."""

import re
import shlex
import shutil
import statistics
import subprocess
from pathlib import Path

import support


class Demo(support.CommandTest):
    def test_a_picture_and_what_to_type_next(self):
        out, _ = self.run_command("demo", "--size", "60x12")
        self.assertIn("gallery.png: 60 x 12 pixels through 'superelliptic'", out)
        _, _, rows = support.png_pixels(self.folder / "gallery.png")
        values = [pixel[0] for row in rows for pixel in row]
        self.assertGreater(statistics.pstdev(values), 20, "the walls look alike everywhere")
        next_lines = re.findall(r"^  (.*\bbalcony (?:render|list) .*)$", out, re.MULTILINE)
        self.assertEqual(len(next_lines), 3)
        for line in next_lines:
            program, *words = shlex.split(line)
            self.assertEqual(program, support.BALCONY)
            small = ("-W", "16", "-s", "1") if words[0] == "render" else ()
            self.run_command(*words, *small)
        self.assertLessEqual({"planet.png", "walls.png"}, set(self.files()))

    def test_options(self):
        document = self.json_of("demo", "-o", "walls.jpg", "--height", "8")
        self.assertEqual((document["output"], document["width"]), ("walls.jpg", 40))
        self.assertTrue(Path(document["scene"]).exists())
        self.assertEqual(self.run_command("demo", "-q", "-W", "20"), ("", ""))
        self.assertLessEqual({"walls.jpg", "gallery.png"}, set(self.files()))

    def test_outputs_that_cannot_be(self):
        self.refused("demo", "-o", "none/a.png", code=3, says="none")
        self.refused("demo", "-o", "picture.txt", code=2, says="picture.txt")

    def test_the_default_size(self):
        out, _ = self.run_command("demo", "--help")
        self.assertIn("(default: 1500x300)", re.sub(r"\s+", " ", out))

    def test_an_installation_that_has_lost_its_gallery(self):
        balcony = self.folder / "bin" / "balcony"
        balcony.parent.mkdir()
        shutil.copy(support.BALCONY, balcony)
        run = subprocess.run([balcony, "demo"], cwd=self.folder, capture_output=True, text=True,
                             timeout=60)
        self.assertEqual(run.returncode, 3)
        self.assertIn("the installation is incomplete: there is no '"
                      f"{self.folder.resolve()}/share/balcony/gallery.glb'", run.stderr)


if __name__ == "__main__":
    support.main()
