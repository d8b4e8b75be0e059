# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs what the README and the help show of a scene on scenes from elsewhere, and judges the pictures."""

import itertools
import shutil
import statistics
import subprocess

import elsewhere
import support
from documentation_test import FENCED, command_lines

COMMANDS = ("", "render", "animate", "check", "locate", "info", "warp")
SCENES = (".glb", ".gltf")
# These are about what a reader may not have: the demo's gallery, a camera in the scene, shards.
SPECIAL = ("build/release/gallery.glb", "scene:Front", "--shard")
# Words of a picture that cannot be otherwise: the camera is not for such a scene.
EXCUSES = ("of the rays of camera", "start in closed objects")


def flaw(path):
    """What is wrong with a picture, or nothing. Nearly black is what --exposure auto brightens: the
    median of what has light is below 0.004, 13 in a file. Nearly white is 2 with a view transform."""
    width, height, rows = support.png_pixels(path)
    values = sorted(0.2126*r + 0.7152*g + 0.0722*b for row in rows for r, g, b, a in row if a > 127)
    if len(values) < 0.2*width*height:
        return "blank"
    median = statistics.median([value for value in values if value > 0] or [0])
    contrast = values[-len(values)//20] - values[len(values)//20]
    return ("too dark" if median < 13 else "too bright" if median > 245 else
            "of one colour" if contrast < 8 else "")


class PrintedPictures(support.CommandTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.lines = []
        for words in COMMANDS:
            cls.lines += command_lines(cls.help_of(words))
        readme = (support.REPOSITORY / "README.md").read_text()
        cls.lines += itertools.chain(*map(command_lines, FENCED.findall(readme)))

    @staticmethod
    def help_of(command):
        words = [support.BALCONY, *command.split(), "--help"]
        return subprocess.run(words, check=True, capture_output=True, text=True).stdout

    def setUp(self):
        super().setUp()
        self.scenes = [path.name for path in elsewhere.write(self.folder)]
        shutil.copy(support.REPOSITORY / "examples" / "my.cam", self.folder)
        (self.folder / "examples").symlink_to(support.REPOSITORY / "examples")
        (self.folder / "corners.csv").write_text("1,2,3\n")

    def run_on(self, scene, line):
        """Runs a line on a scene, in small; returns the picture that it makes, and what it says."""
        words = [scene if word.endswith(SCENES) else word for word in line if word != "--watch"]
        command, picture = words[0], None
        if command in ("render", "animate", "warp"):
            if "-o" in words:
                del words[words.index("-o"):words.index("-o") + 2]
            picture = "film.1.png" if command == "animate" else "picture.png"
            words += ["--size", "120", "-o", picture.replace("1", "#")]
        if command in ("render", "animate"):
            words += ["--samples", "4"]
        if command == "animate":
            words += ["--frames", "1-2", "--overwrite"]
        return picture, "".join(self.run_command(*words))

    def test_each_line_makes_a_picture_that_shows_something(self):
        shown = 0
        for scene in self.scenes:
            self.run_command("render", scene, "--camera", "panorama", "--size", "240", "-o", "photo.png")
            for line in self.lines:
                on_scene = any(word.endswith(SCENES) for word in line) or line[0] == "warp"
                if not on_scene or set(SPECIAL) & set(line):
                    continue
                with self.subTest(scene=scene, line=" ".join(line)):
                    picture, said = self.run_on(scene, line)
                    if picture and not any(excuse in said for excuse in EXCUSES):
                        shown += 1
                        self.assertEqual(flaw(self.folder / picture), "", said)
        self.assertGreater(shown, 30)

    def test_a_bad_picture_is_noticed(self):
        for words, wrong in ((("--camera", "panorama", "--exposure", "-7"), "too dark"),
                             (("--camera", "panorama", "--exposure", "4"), "too bright"),
                             (("--camera", "pinhole", "--background", "transparent", "--no-fit",
                               "--set", "px=900"), "blank"),
                             (("--camera", "pinhole", "--no-fit", "--set", "px=900",
                               "--environment", "0.5"), "of one colour")):
            self.run_command("render", "town.gltf", *words, "--size", "48", "-s", "1", "-o", "p.png")
            self.assertEqual(flaw(self.folder / "p.png"), wrong)


if __name__ == "__main__":
    support.main()
