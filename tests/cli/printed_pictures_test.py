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
# It runs until it is ended, and has tests of its own.
SERVER = "studio"
# What makes the pictures of commands small, and options of which it takes the place.
MORE = {"render": ("--size", "120", "--samples", "4", "-o", "picture.png"),
        "animate": ("--size", "120", "--samples", "4", "--frames", "1-2", "--overwrite", "-o", "film.#.png"),
        "warp": ("--size", "120", "-o", "picture.png")}
REPLACED = ("--size", "--samples", "-s", "--frames", "-o")
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
        cls.lines = [line for line in cls.lines if not set(SPECIAL) & set(line) and line[0] != SERVER and (
            any(word.endswith(SCENES) for word in line) or line[0] == "warp")]

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

    @staticmethod
    def small(scene, line):
        """A line as it runs on a scene, in small: lines that differ in what is replaced are the same."""
        words = [scene if word.endswith(SCENES) else word for word in line if word != "--watch"]
        more = MORE.get(words[0], ())
        for option in set(REPLACED) & set(words) if more else ():
            del words[words.index(option):words.index(option) + 2]
        return (*words, *more)

    def test_each_line_makes_a_picture_that_shows_something(self):
        shown = 0
        for scene in self.scenes:
            self.run_command("render", scene, "--camera", "panorama", "--size", "240", "-s", "4", "-o",
                             "photo.png")
            for line in dict.fromkeys(self.small(scene, line) for line in self.lines):
                with self.subTest(scene=scene, line=" ".join(line)):
                    said = "".join(self.run_command(*line))
                    if line[0] in MORE and not any(excuse in said for excuse in EXCUSES):
                        shown += 1
                        self.assertEqual(flaw(self.folder / line[-1].replace("#", "1")), "", said)
        self.assertGreater(shown, 20)

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
