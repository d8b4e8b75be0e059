# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs docs/povray.md, at a small size, and gives `balcony pov` what may go wrong."""

import json
import os
import re
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

import guide
import png

EXAMPLES = Path("/usr/share/doc/povray/examples")
if None in (shutil.which("povray"), shutil.which("oiiotool")) or not EXAMPLES.is_dir():
    guide.skip("POV-Ray, its examples or oiiotool are not installed")


def quick(line):
    """The same command at a quarter of the width and height, with one ray per pixel."""
    def quarter(size):
        return "--size " + "x".join(str(int(side) // 4) for side in size[1].split("x"))

    return re.sub(r"-s \d+", "-s 1", re.sub(r"--size (\S+)", quarter, line))


class PovrayGuide(guide.GuideTest):
    PAGE = "povray.md"
    EDIT = staticmethod(quick)

    def test_every_command_makes_its_picture(self):
        names = [re.search(r"-o (\S+)", line)[1] for line in self.outputs]
        self.assertEqual(len(names), 10)
        for name in names:
            self.assertGreater((self.folder / name).stat().st_size, 1000, name)

    def test_the_table_of_axes_is_that_of_the_help(self):
        rows = re.findall(r"^\| `(\w+)`(?: \(default\))? \| `<", guide.page_text("povray.md"),
                          re.MULTILINE)
        said = self.run_line("balcony complete pov --axes ''")
        self.assertEqual(rows, [line.split("\t")[0] for line in said.splitlines()])


SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -10> look_at 0 }
light_source { <-3, 5, 1> rgb 1 }
#include "part.inc"
plane { y, -1 pigment { rgb <0.5, 0.3, 0.1> } }
"""
PART = "sphere { <5, 0, 1>, 1.5 pigment { rgb <1, clock, 0> } }\n"
CAMERA = """camera c(fov = 1) {
    map u = fov .. -fov, v = square
    eye point(0, 0, 0) toward plane((1, 0, 0))
}
picture inset 60 x 40 {
    layer c
    layer c(fov = 0.2) { clip ellipse  place (0.6, 0.1) .. (0.9, 0.5)  alpha 0.8  frame(0.02) }
}
"""


class Robustness(unittest.TestCase):
    def setUp(self):
        self.folder = Path(guide.tempfile.mkdtemp(prefix="balcony-povray-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "scene.pov").write_text(SCENE)
        (self.folder / "part.inc").write_text(PART)
        (self.folder / "c.cam").write_text(CAMERA)

    def pov(self, *words, code=0, **settings):
        done = subprocess.run([guide.BALCONY, "pov", *words], cwd=self.folder, text=True,
                              capture_output=True, **settings)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def facts(self, *words):
        return json.loads(self.pov("scene.pov", "--camera", "c.cam:c", "--size", "60x40", "-s", "1",
                                   "-o", "p.png", "--json", *words).stdout)

    def test_names_with_any_characters(self):
        folder = self.folder / "a $(touch x) 'b\" \\ ü"
        folder.mkdir()
        names = [folder / f"{n} $HOME 'q\" ; & *{e}" for n, e in (("s", ".pov"), ("c", ".cam"),
                                                               ("p", ".png"))]
        names[0].write_text(SCENE)
        (folder / "part.inc").write_text(PART)
        names[1].write_text(CAMERA[:CAMERA.index("picture")])
        before = sorted(os.listdir(folder))
        self.pov(names[0], "--camera", names[1], "--size", "60", "-s", "1", "-o", names[2])
        self.assertEqual(sorted(os.listdir(folder)), sorted([*before, names[2].name]))

    def test_a_mistake_is_shown_in_the_users_file(self):
        (self.folder / "scene.pov").write_text(SCENE + "box { <0,0,0>, <1,1,1> pigmint { rgb 1 } }\n")
        said = self.pov("scene.pov", "--camera", "c.cam:c", "-o", "p.png", code=1).stderr
        self.assertIn("scene.pov:7:1: error: POV-Ray: No matching }", said)
        self.assertIn("7 | box {", said)
        (self.folder / "scene.pov").write_text(SCENE)
        (self.folder / "part.inc").write_text("\nsphere { 0 }\n")
        said = self.pov("scene.pov", "--camera", "c.cam:c", "-o", "p.png", code=1).stderr
        self.assertIn("part.inc:2:1: error: POV-Ray: ", said)
        self.assertFalse((self.folder / "p.png").exists())

    def test_what_cannot_be_used(self):
        for words, code, message in (
                (("lost.pov",), 1, "there is no file 'lost.pov'"),
                (("scene.pov", "--axes", "x_up"), 2, "--axes cannot be 'x_up'"),
                (("scene.pov", "--samples", "0"), 2, "--samples cannot be '0'"),
                (("scene.pov", "-o", "c.cam"), 2, "'c.cam' is not a picture format"),
                (("scene.pov", "--", "+Zfoo"), 1, "options for POV-Ray after --")):
            said = self.pov(words[0], "--camera", "c.cam:c", "--size", "60", *words[1:], code=code)
            self.assertIn(message, said.stderr)

    def test_the_camera_is_not_replaced(self):
        camera = self.folder / "camera.png"
        camera.write_bytes((self.folder / "c.cam").read_bytes())
        said = self.pov("scene.pov", "--camera", "camera.png:c", "-o", "camera.png", code=2)
        self.assertIn("'camera.png' is read here and would be overwritten", said.stderr)
        self.assertEqual(camera.read_bytes(), (self.folder / "c.cam").read_bytes())

    def test_a_missing_program(self):
        said = self.pov("scene.pov", "--camera", "c.cam:c", code=3, env={"PATH": "/nowhere"})
        self.assertIn("apt install povray", said.stderr)

    def test_the_mesh_is_within_its_tolerance(self):
        facts = self.facts()
        self.assertEqual((facts["povray_runs"], facts["rays"]), (1, 2400))
        self.assertLess(facts["largest_error"], 0.05)

    def test_time_is_povrays_clock_and_options_reach_it(self):
        pictures = []
        for words in ((), ("--time", "1"), ("--", "Declare=unused=1", "+Q0")):
            self.facts(*words)
            pictures.append((self.folder / "p.png").read_bytes())
        self.assertEqual(len(set(pictures)), 3)

    def test_colours_are_those_of_povrays_own_picture(self):
        for head in ("#version 3.7; global_settings { assumed_gamma 1 }",
                     "#version 3.7; global_settings { assumed_gamma 2.2 }",
                     "#version 3.6; global_settings { assumed_gamma 2.2 }", "#version 3.6;", ""):
            (self.folder / "flat.pov").write_text(
                head + "\nbackground { rgb <0.2, 0.5, 1.3> }\ncamera { location 0 look_at z }\n")
            subprocess.run(["povray", "+Iflat.pov", "+Oown.png", "+W8", "+H8", "-D", "+FN8"],
                           cwd=self.folder, check=True, capture_output=True)
            self.pov("flat.pov", "--camera", "c.cam:c", "--size", "8x8", "-s", "2", "-o", "p.png")
            own, ours = (png.read(self.folder / name)[4][4] for name in ("own.png", "p.png"))
            self.assertEqual(ours[:3], own[:3], head)

    def test_light_beyond_white_is_in_exr_files(self):
        (self.folder / "flat.pov").write_text(
            "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <4, 4, 4> }\n")
        self.pov("flat.pov", "--camera", "c.cam:c", "--size", "8x8", "-s", "1", "-o", "p.exr")
        said = guide.run_line("oiiotool --stats p.exr", self.folder, os.environ["PATH"])
        self.assertRegex(said, r"Stats Avg: 4\.0+ 4\.0+ 4\.0+ 1\.0+ ")

    def test_a_picture_with_an_inset_is_composed(self):
        said = self.pov("scene.pov", "--camera", "c.cam:inset", "-s", "2", "-o", "p.png", "--json")
        facts = json.loads(said.stdout)
        self.assertEqual((facts["width"], facts["height"]), (60, 40))
        self.assertEqual(facts["povray_runs"], 1)
        # Both layers, each as often as there are passes; the inset only where it is visible.
        self.assertGreater(facts["rays"], 2 * 2400)
        self.assertLess(facts["rays"], 2 * 2400 * 1.2)

    def test_a_signal_ends_povray_and_leaves_nothing_behind(self):
        (self.folder / "slow.pov").write_text(
            SCENE + "#declare I = 0; #while (I < 1e9) #declare I = I + 1; #end\n")
        own = self.folder / "temporary"
        own.mkdir()
        run = subprocess.Popen([guide.BALCONY, "pov", "slow.pov", "--camera", "c.cam:c", "-o",
                                "p.png", "-q"], cwd=self.folder,
                               env=dict(os.environ, TMPDIR=str(own)))
        while not list(own.iterdir()):
            self.assertIsNone(run.poll(), "it has ended too early")
            time.sleep(0.1)
        time.sleep(1)
        run.send_signal(signal.SIGINT)
        self.assertEqual(run.wait(timeout=30), 130)
        self.assertEqual(list(own.iterdir()), [])


if __name__ == "__main__":
    guide.main()
