#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The PyTorch functions and the Mitsuba sensors of all examples of cameras: their rays, and their gradients
beside the exact derivatives of Balcony.

Usage: gradients_test.py BALCONY REPOSITORY EXPORTS

EXPORTS is the folder that write_exports wrote. The folder gradients/stand_ins has what stands for PyTorch
where it is not installed, and for Mitsuba.
"""

import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXPORTS = Path(sys.argv.pop(3)).resolve()

import guide  # noqa: E402 (reads the other arguments)
from rays import MAGNIFYING, pixels_between  # noqa: E402

FOLDER = Path(__file__).parent / "gradients"
STAND_INS = guide.STAND_INS
TORCH = guide.python_with("torch", "numpy")
PYTHON = TORCH or guide.python_with("numpy")
# Built-in cameras whose parameters stay open, of many kinds: angles and lengths, tables, conditions, and rays
# that miss.
LEARNT = ("superelliptic", "fisheye_polynomial", "panini", "catadioptric_hyperbolic", "mirror_ball", "pushbroom",
          "portrait_lens", "general_linear", "coin", "torus_flight", "path_strip", "swing", "hyperbolic",
          "cylindrical_anamorphosis", "slide_curved", "cubemap_cross")


def run(script, *arguments, stand_ins):
    environment = dict(os.environ)
    if stand_ins:
        environment["PYTHONPATH"] = str(STAND_INS)
    done = subprocess.run([PYTHON, "-B", FOLDER / script, *map(str, arguments)], env=environment, check=True,
                          stdout=subprocess.PIPE)
    return done.stdout


def vector(ray, name):
    return [*ray["origin" + name], *ray["direction" + name]]


class GradientsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="balcony-gradients-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.exports = json.loads((EXPORTS / "exports.json").read_text())["examples"]
        run("torch_rays.py", EXPORTS, cls.folder / "torch.json", stand_ins=TORCH is None)
        made = json.loads((cls.folder / "torch.json").read_text())
        cls.made = made["examples"]
        print(f"PyTorch is {made['torch']}")

    def pairs(self, name, rays):
        """An exact and a made ray each."""
        return list(zip(self.exports[name]["rays"], rays, strict=True))

    def compare(self, made, tolerance):
        """The largest difference in pixels; every camera must keep to the tolerance of its name."""
        largest = (0.0, "")
        for name, rays in made.items():
            for exact, ray in self.pairs(name, rays):
                with self.subTest(camera=name):
                    self.assertEqual(exact is None, ray is None, "there is a ray")
                    if exact is not None:
                        pixels = pixels_between(exact, ray[:3], ray[3:])
                        largest = max(largest, (pixels, name))
                        self.assertLess(pixels, tolerance(name))
        print(f"{len(made)} cameras; the largest difference is {largest[0]:.2g} pixels, of {largest[1]}")

    def test_torch_has_the_same_rays(self):
        self.assertGreaterEqual(len(self.made) + 3, len(self.exports), "all but meshes")
        self.compare({name: one["rays"] for name, one in self.made.items()}, lambda _: 1e-6)

    def test_rays_of_single_precision(self):
        # As those of GLSL, which has the same precision.
        self.compare({name: one["single"] for name, one in self.made.items()},
                     lambda name: 0.05 * MAGNIFYING.get(name, 1.0))

    def test_gradients_by_positions(self):
        """They are our exact derivatives, and 0 where there is no ray; nowhere are they not numbers."""
        largest = (0.0, "")
        for name, one in self.made.items():
            for i, (exact, _) in enumerate(self.pairs(name, one["rays"])):
                learnt = [[one["slopes"][c][k][i] for c in range(6)] for k in (0, 1)]
                with self.subTest(camera=name, point=i):
                    if exact is None:
                        self.assertEqual(learnt, [[0.0] * 6] * 2)
                        continue
                    for ours, theirs in zip((vector(exact, "_by_x"), vector(exact, "_by_y")), learnt):
                        size = max(map(abs, ours))
                        difference = max(abs(a - b) for a, b in zip(ours, theirs)) / (size + 1e-6)
                        largest = max(largest, (difference, name))
                        self.assertLess(difference, 1e-9)
        print(f"gradients by positions differ by {largest[0]:.2g} of their size, of {largest[1]}")

    def export(self, names, language):
        for name in names:
            subprocess.run([guide.BALCONY, "export", name, "--to", language, "--parameters", "all", "-o",
                            self.folder / f"{name}_{language}.py"], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def compare_by_parameter(self, found):
        """Those that a program printed; each camera has its differences by parameter."""
        count = sum(len(one) for one in found.values())
        self.assertGreater(count, 3 * len(LEARNT))
        largest = max((difference, name, parameter) for name, one in found.items()
                      for parameter, difference in one.items())
        print(f"gradients by {count} parameters; the largest difference is {largest}")
        for name, one in found.items():
            for parameter, difference in one.items():
                with self.subTest(camera=name, parameter=parameter):
                    # Differences of steps of 1e-4 have rounding errors of 1e-12.
                    self.assertLess(difference, 1e-7)

    def test_gradients_by_parameters(self):
        self.export(LEARNT, "numpy")
        self.export(LEARNT, "torch")
        self.compare_by_parameter(json.loads(
            run("torch_parameters.py", self.folder, *LEARNT, stand_ins=TORCH is None)))

    def test_mitsuba_has_gradients_by_parameters(self):
        names = [name for name in LEARNT if name != "panini"]  # Its s is the end of its range.
        self.export(names, "mitsuba")
        self.compare_by_parameter(json.loads(
            run("mitsuba_parameters.py", self.folder, *names, stand_ins=True)))

    def test_torch_finds_points_where_balcony_locates_them(self):
        wanted = found = 0
        for name, one in self.made.items():
            entries = self.exports[name]["located"]
            if not entries:
                continue
            places = one["found"]
            for i, (entry, position, distance) in enumerate(
                    zip(entries, places["positions"], places["distances"], strict=True)):
                wanted += 1
                if math.isnan(distance):
                    self.assertEqual(places["x"][i], [0.0] * 3)
                    continue
                found += 1
                with self.subTest(camera=name, point=i):
                    nearest = min(entry["sightings"], key=lambda one: math.dist(one[:2], position),
                                  default=None)
                    if nearest is not None:
                        self.assertLess(math.dist(nearest[:2], position), 0.01)
                        self.assertAlmostEqual(nearest[2], distance, delta=1e-3 * nearest[2])
                    self.assert_moves(places, i)
        self.assertGreater(wanted, 2000)
        self.assertGreater(found, 0.995 * wanted)

    def assert_moves(self, places, i):
        """The position of a point has the gradients of differences, whose steps of 1e-5 are wrong by some
        thousandths where small parts of a picture show much."""
        for k, coordinate in enumerate("xy"):
            for gradient, row in zip(places[coordinate][i], places["differences"], strict=True):
                self.assertTrue(math.isfinite(gradient))
                if math.isfinite(row[i][k]):
                    self.assertAlmostEqual(gradient, row[i][k], delta=5e-3 * (1 + abs(gradient)))

    def test_mitsuba(self):
        output = self.folder / "mitsuba.json"
        run("mitsuba_rays.py", EXPORTS, output, stand_ins=True)
        made = json.loads(output.read_text())
        self.assertGreaterEqual(len(made) + 3, len(self.exports), "all but meshes")
        self.compare({name: [one and one["ray"] for one in rays] for name, rays in made.items()},
                     lambda _: 1e-6)
        for name, rays in made.items():
            for exact, one in self.pairs(name, rays):
                if exact is not None:
                    with self.subTest(camera=name):
                        self.assert_beside(exact, one["beside"])

    def assert_beside(self, exact, beside):
        """The rays of the next pixels have the derivatives of this one."""
        o, d = exact["origin"], exact["direction"]
        for axis, first in (("_by_x", 0), ("_by_y", 3)):
            for a, b, slope in zip(o, beside[first:first + 3], exact["origin" + axis]):
                self.assertAlmostEqual(a + slope, b, delta=1e-9 * (1 + abs(a) + abs(slope)))
            moved = [a + slope for a, slope in zip(d, exact["direction" + axis])]
            for a, b in zip(moved, beside[6 + first:9 + first]):
                self.assertAlmostEqual(a / math.hypot(*moved), b, delta=1e-9)


if __name__ == "__main__":
    if PYTHON is None:
        guide.skip("NumPy is not installed")
    guide.main()
