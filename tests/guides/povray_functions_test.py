#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The functions for POV-Ray of all examples of cameras, evaluated by POV-Ray; and pictures by the
user_defined camera of POV-Ray 3.8, where that is the one on the PATH.

Usage: povray_functions_test.py BALCONY REPOSITORY EXPORTS

EXPORTS is the folder that write_exports wrote.
"""

import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXPORTS = Path(sys.argv.pop(3)).resolve()

import guide  # noqa: E402 (reads the other arguments)
import png  # noqa: E402
import povray_agreement_test as agreement  # noqa: E402

VERSION = tuple(map(int, re.search(
    r"^POV-Ray (\d+)\.(\d+)",
    subprocess.run(["povray", "--version"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                   text=True).stdout, re.MULTILINE).groups()))


def run_povray(folder, scene, width, height, *options):
    done = subprocess.run(["povray", f"+I{scene}", "+Opicture.png", f"+W{width}", f"+H{height}", "-D",
                           "-A", "+UA", "+FN8", *options], cwd=folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stdout[-3000:])


class Functions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="balcony-povray-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)

    def test_povray_computes_our_rays(self):
        """All cameras in one scene: their names do not collide."""
        exports = json.loads((EXPORTS / "exports.json").read_text())
        width, height = exports["width"], exports["height"]
        examples = {name: entry for name, entry in exports["examples"].items()
                    if "pov" in entry.get("languages", ())}
        points = exports["points"][::5]
        scene = [f"#version {VERSION[0]}.{VERSION[1]};", "global_settings { assumed_gamma 1 }",
                 '#fopen Rays "rays.txt" write']
        for name in examples:
            # POV-Ray 3.7 knows the functions, but not the camera.
            text = (EXPORTS / "pov" / f"{name}.inc").read_text()
            scene.append(text if VERSION >= (3, 8) else text[:text.rindex("#declare")])
            pov = name[0].upper() + name[1:]
            values = [f"str({pov}_{part}({axis}, {pov}_column(X), {pov}_row(Y)), 0, 17)"
                      for part in ("location", "direction") for axis in range(3)]
            scene.append(f"#macro {pov}_write(X, Y) #write (Rays, " + ', " ", '.join(values)
                         + ', "\\n") #end')
            scene += [f"{pov}_write({x / width - 0.5!r}, {0.5 - y / height!r})" for x, y in points]
        (self.folder / "scene.pov").write_text("\n".join([*scene, "#fclose Rays"]) + "\n")
        run_povray(self.folder, "scene.pov", int(width), int(height), "+ER1", "+EC1")
        lines = (self.folder / "rays.txt").read_text().splitlines()
        self.assertEqual(len(lines), len(points) * len(examples))
        worst = 0.0
        for index, (name, entry) in enumerate(examples.items()):
            for at, exact in enumerate(entry["rays"][::5]):
                values = [*map(float, lines[index * len(points) + at].split())]
                there = all(map(math.isfinite, values)) and any(values[3:])
                with self.subTest(camera=name, point=points[at]):
                    self.assertEqual(there, exact is not None, "there is a ray")
                    if there:
                        worst = max(worst, self.difference(values, exact, entry["y_up"]))
        print(f"POV-Ray {VERSION}: {len(examples)} cameras, the largest difference is {worst:.2g}")
        self.assertLess(worst, 1e-9)

    @staticmethod
    def difference(values, exact, y_up):
        """Of coordinates, by their size."""
        def in_povray(v):
            x, y, z = v
            return (x, y, -z) if y_up else (x, z, y)

        wanted = [*in_povray(exact["origin"]), *in_povray(exact["direction"])]
        return max(abs(a - b) / max(1.0, abs(b)) for a, b in zip(values, wanted))


@unittest.skipIf(VERSION < (3, 8), "the POV-Ray on the PATH has no user_defined camera")
class Pictures(agreement.Agreement):
    """The pictures by functions are those of 'balcony render', as those of 'balcony pov' are."""

    AXES = ("y_up", "z_up")
    test_a_lens_takes_the_same_points = None  # The functions have no lens.

    def picture(self, command, *options):
        program, scene = command
        if program == "render":
            return super().picture(command, *options)
        subprocess.run([guide.BALCONY, "export", "c.cam", "--to", "pov", "-o", "c.inc", "--quiet",
                        *options], cwd=self.folder, check=True)
        text = (self.folder / scene).read_text()
        text = re.sub(r"camera \{.*\}", "camera { C }", text.replace("#version 3.7;", ""))
        (self.folder / "functions.pov").write_text('#version 3.8;\n#include "c.inc"\n' + text)
        run_povray(self.folder, "functions.pov", agreement.WIDTH, agreement.HEIGHT)
        return [[agreement.object_of(pixel) for pixel in row]
                for row in png.read(self.folder / "picture.png")]


if __name__ == "__main__":
    guide.main()
