#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes ten ordinary scenes whose light is hard to find, and renders them.

Usage: ordinary.py BALCONY FOLDER [PLACE ...] [--samples COUNT] [--size WxH] [--reference COUNT]

Mirrors, glass, brass, tiles, window panes, lamps under shades, a car, a temple, a street: small lamps and suns
that are seen in smooth surfaces make bright specks in the light that walls scatter. The script prints the
specks of a picture as rendered, and those with --exact: pixels that a display shows brighter by 60 of
255 than the median of the 7 x 7 around them, and by 30 than a reference with COUNT samples (1,024),
which borders of lamps and glints of the sun are not. References are rendered with another seed, and
used again if they are in the folder.
"""
import argparse
import math
import pathlib
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent / "peers"))
from room import Glb, quad, sphere  # noqa: E402

GLASS = {"KHR_materials_transmission": {"transmissionFactor": 1.0},
         "KHR_materials_ior": {"ior": 1.5}}
SOLID = {**GLASS, "KHR_materials_volume": {"thicknessFactor": 1.0}}


class Place(Glb):
    """A scene with the materials and shapes of ordinary places."""

    def __init__(self):
        super().__init__()
        self.json["extensionsUsed"] += ["KHR_lights_punctual", "KHR_materials_clearcoat"]
        self.white = self.material("white", (0.8, 0.8, 0.78))
        self.wood = self.material("wood", (0.4, 0.25, 0.15), roughness=0.3)
        self.mirror = self.material("mirror", (0.95, 0.95, 0.95), roughness=0.0, metallic=1.0)
        self.brass = self.material("brass", (0.9, 0.7, 0.3), roughness=0.1, metallic=1.0)
        self.pane = self.material("pane", (1, 1, 1), roughness=0.0, extensions=GLASS)
        self.solid = self.material("solid", (1, 1, 1), roughness=0.0, extensions=SOLID)
        self.tiles = self.material("tiles", (0.75, 0.8, 0.8), roughness=0.05)

    def bulb(self, centre, radius=0.04, strength=2000.0):
        material = self.material("bulb", (0, 0, 0), emissiveFactor=[1.0, 0.85, 0.6], extensions={
            "KHR_materials_emissive_strength": {"emissiveStrength": strength}})
        self.mesh("bulb", sphere(centre, radius, 12), material)

    def sun(self, lux=400.0):
        """Through a window in the wall at -z, steeply down."""
        self.json.setdefault("extensions", {})["KHR_lights_punctual"] = {
            "lights": [{"type": "directional", "color": [1.0, 0.95, 0.85], "intensity": lux}]}
        self.json["nodes"].append({"rotation": [-0.3007, 0.7872, 0.4730, 0.2588],
                                   "extensions": {"KHR_lights_punctual": {"light": 0}}})
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)

    def box(self, name, low, high, material):
        (x, y, z), (a, b, c) = low, high
        w, h, d = a - x, b - y, c - z
        for corner, along, up in (((x, y, c), (w, 0, 0), (0, h, 0)),
                                  ((a, y, z), (-w, 0, 0), (0, h, 0)),
                                  ((a, y, c), (0, 0, -d), (0, h, 0)),
                                  ((x, y, z), (0, 0, d), (0, h, 0)),
                                  ((x, b, c), (w, 0, 0), (0, 0, -d)),
                                  ((x, y, z), (w, 0, 0), (0, 0, d))):
            self.mesh(name, quad(corner, along, up), material)

    def column(self, x, z, radius, low, high, material):
        sides = 24
        corners = [(x + radius * math.cos(2 * math.pi * i / sides),
                    z - radius * math.sin(2 * math.pi * i / sides)) for i in range(sides + 1)]
        for (a, b), (c, d) in zip(corners, corners[1:]):
            self.mesh("column", quad((a, low, b), (c - a, 0, d - b), (0, high - low, 0)), material)

    def room(self, window=False, walls=None):
        """4 x 3 x 4 metres around the origin; the window is in the wall at -z."""
        walls = self.white if walls is None else walls
        self.mesh("floor", quad((-2, 0, 2), (4, 0, 0), (0, 0, -4)), self.wood)
        self.mesh("ceiling", quad((-2, 3, -2), (4, 0, 0), (0, 0, 4)), self.white)
        self.mesh("wall", quad((2, 0, 2), (-4, 0, 0), (0, 3, 0)), walls)
        self.mesh("wall", quad((-2, 0, 2), (0, 0, -4), (0, 3, 0)), walls)
        self.mesh("wall", quad((2, 0, -2), (0, 0, 4), (0, 3, 0)), walls)
        if not window:
            self.mesh("wall", quad((-2, 0, -2), (4, 0, 0), (0, 3, 0)), walls)
            return
        for corner, along, up in (((-2, 0, -2), (4, 0, 0), (0, 1, 0)),
                                  ((-2, 2.4, -2), (4, 0, 0), (0, 0.6, 0)),
                                  ((-2, 1, -2), (1.2, 0, 0), (0, 1.4, 0)),
                                  ((0.8, 1, -2), (1.2, 0, 0), (0, 1.4, 0))):
            self.mesh("wall", quad(corner, along, up), walls)


def mirror():
    place = Place()
    place.room()
    place.mesh("mirror", quad((-1.99, 0.5, 1), (0, 0, -2), (0, 2, 0)), place.mirror)
    place.bulb((1.2, 2.2, -0.5))
    return place


def solid_glass():
    place = Place()
    place.room()
    for i, x in enumerate((-1.0, 0.0, 1.0)):
        place.mesh("ball", sphere((x, 0.35 + 0.1 * i, -0.8), 0.3, 48), place.solid)
    place.bulb((0.3, 2.5, 0.4))
    return place


def thin_glass():
    place = Place()
    place.room(window=True)
    for x in (-1.0, 0.2):
        place.mesh("vase", sphere((x, 0.4, -0.6), 0.35, 48), place.pane)
    place.sun()
    place.bulb((-1.2, 2.4, 1.0))
    return place


def brass():
    place = Place()
    place.room(window=True)
    for i in range(5):
        place.mesh("bowl", sphere((-1.4 + 0.7 * i, 0.3, -0.5 - 0.2 * (i % 2)), 0.25, 48),
                   place.brass)
    place.sun()
    return place


def bathroom():
    place = Place()
    place.room(walls=place.tiles)
    place.mesh("mirror", quad((-1, 1.1, -1.99), (2, 0, 0), (0, 1, 0)), place.mirror)
    place.box("basin", (-0.6, 0.7, -1.95), (0.6, 0.9, -1.3), place.tiles)
    place.mesh("tap", sphere((0.0, 1.0, -1.7), 0.06, 24), place.brass)
    for x in (-0.8, 0.0, 0.8):
        place.bulb((x, 2.3, -1.8), 0.03)
    return place


def panes():
    place = Place()
    place.room(window=True)
    place.mesh("pane", quad((-0.8, 1, -2), (1.6, 0, 0), (0, 1.4, 0)), place.pane)
    place.mesh("pane", quad((-0.8, 1, -1.98), (1.6, 0, 0), (0, 1.4, 0)), place.pane)
    place.box("table", (-0.7, 0.7, -0.8), (0.7, 0.75, 0.2), place.wood)
    place.sun()
    return place


def shade():
    place = Place()
    place.room()
    place.bulb((0.0, 1.8, -0.6))
    place.mesh("shade", sphere((0.0, 1.8, -0.6), 0.2, 48), place.pane)
    place.bulb((1.3, 0.6, -1.3), 0.03)
    place.mesh("globe", sphere((1.3, 0.6, -1.3), 0.16, 48), place.solid)
    place.mesh("hollow", sphere((1.3, 0.6, -1.3), -0.14, 48), place.solid)
    return place


def car():
    place = Place()
    paint = place.material("paint", (0.5, 0.03, 0.03), roughness=0.4, extensions={
        "KHR_materials_clearcoat": {"clearcoatFactor": 1.0, "clearcoatRoughnessFactor": 0.0}})
    ground = place.material("ground", (0.3, 0.3, 0.3))
    place.mesh("ground", quad((-30, 0, 30), (60, 0, 0), (0, 0, -60)), ground)
    place.box("wall", (-6, 0, -5), (6, 3, -4.6), place.white)
    place.box("body", (-2.0, 0.3, -2.6), (2.0, 0.9, -1.2), paint)
    place.box("cabin", (-1.0, 0.92, -2.5), (1.0, 1.5, -1.3), place.pane)
    for x in (-1.3, 1.3):
        place.mesh("hub", sphere((x, 0.35, -1.15), 0.25, 32), place.mirror)
    place.sun(20000.0)
    return place


def temple():
    place = Place()
    marble = place.material("marble", (0.8, 0.77, 0.7))
    polished = place.material("polished", (0.6, 0.6, 0.58), roughness=0.02)
    place.mesh("ground", quad((-40, -0.3, 40), (80, 0, 0), (0, 0, -80)), place.wood)
    place.box("floor", (-3, -0.3, -6), (3, 0, 3), polished)
    place.box("roof", (-3, 3, -6), (3, 3.5, 3), marble)
    place.box("cella", (-1.2, 0, -6), (1.2, 3, -3.5), marble)
    for z in (-5.5, -4, -2.5, -1, 0.5, 2):
        for x in (-2.6, 2.6):
            place.column(x, z, 0.25, 0, 3, marble)
    place.mesh("bowl", sphere((0, 0.5, -1.5), 0.35, 48), place.brass)
    place.sun(20000.0)
    return place


def street():
    place = Place()
    asphalt = place.material("asphalt", (0.1, 0.1, 0.1), roughness=0.5)
    plaster = place.material("plaster", (0.7, 0.6, 0.45))
    shop = place.material("shop", (0.3, 0.25, 0.2))
    place.mesh("ground", quad((-40, 0, 40), (80, 0, 0), (0, 0, -80)), asphalt)
    for side in (-1, 1):
        for i in range(6):
            z = 10 - 4 * i
            low, high = sorted((side * 3.5, side * 7))
            place.box("house", (low, 0, z - 3.8), (high, 5 + i % 2, z), plaster)
            for y in (1, 3):
                place.mesh("window", quad((side * 3.48, y, z - 1.3 + side * 0.6),
                                          (0, 0, -1.2 * side), (0, 1.2, 0)), place.pane)
                place.mesh("behind", quad((side * 3.49, y, z - 1.3 + side * 0.6),
                                          (0, 0, -1.2 * side), (0, 1.2, 0)), shop)
        place.box("post", (side * 2.5 - 0.05, 0, -1.05), (side * 2.5 + 0.05, 2.2, -0.95), shop)
        place.bulb((side * 2.5, 2.4, -1.0), 0.08, 2e5)
        place.mesh("globe", sphere((side * 2.5, 2.4, -1.0), 0.16, 32), place.pane)
    place.box("car", (0.4, 0.3, -4.5), (1.9, 1.3, -1.5), place.mirror)
    place.sun(20000.0)
    return place


SKY = ("--environment", "sky", "--environment-strength", "0.003")
PLACES = {"mirror": (mirror, ()), "solid-glass": (solid_glass, ()), "thin-glass": (thin_glass, SKY),
          "brass": (brass, SKY), "bathroom": (bathroom, ()), "panes": (panes, SKY),
          "shade": (shade, ()), "car": (car, ()), "temple": (temple, ()),
          "street": (street, (*SKY[:3], "0.15"))}
SUNLIT = {"car": "0.0001", "temple": "0.0003", "street": "0.0001"}  # Of white in the display.
VIEW = ("-c", "panorama", "--set", "px=0.2", "--set", "py=-0.7", "--set", "pz=1.4")


def render(balcony, scene, picture, options, samples, more):
    subprocess.run([balcony, "render", scene, *VIEW, "--size", options.size, "-s", str(samples),
                    "--exposure", "0", "-o", picture, "-q", *more],
                   check=True, stderr=subprocess.DEVNULL)


def shown(picture, scale):
    """The size of a picture, and how bright a display shows its pixels, row by row."""
    raw = picture.with_suffix(".ppm")
    subprocess.run(["oiiotool", picture, "--ch", "R,G,B", "--mulc", scale, "--colorconvert",
                    "linear", "sRGB", "-d", "uint8", "-o", raw], check=True)
    _, size, _, data = raw.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    raw.unlink()
    return width, height, [0.2126 * r + 0.7152 * g + 0.0722 * b
                           for r, g, b in zip(data[::3], data[1::3], data[2::3])]


def specks(picture, reference, scale):
    """How many pixels are much brighter than those around them, and than the reference."""
    width, height, light = shown(picture, scale)
    _, _, truth = shown(reference, scale)
    count = 0
    for y in range(3, height - 3):
        for x in range(3, width - 3):
            around = [light[(y + j) * width + x + i] for j in range(-3, 4) for i in range(-3, 4)]
            at = y * width + x
            count += light[at] > max(statistics.median(around) + 60, truth[at] + 30)
    return count


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("balcony")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("places", nargs="*", metavar="PLACE",
                        help=", ".join(PLACES))
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--size", default="320x160")
    parser.add_argument("--reference", type=int, default=1024)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    print(f"{'scene':12}  specks  with --exact")
    for name in options.places or PLACES:
        make, more = PLACES[name]
        scene = options.folder / f"{name}.glb"
        make().write(scene)
        reference = options.folder / f"{name}-{options.size}-{options.reference}.exr"
        if not reference.exists():
            render(options.balcony, scene, reference, options, options.reference,
                   (*more, "--seed", "99"))
        found = []
        for end, exact in (("", ()), ("-exact", ("--exact",))):
            picture = options.folder / f"{name}{end}.exr"
            render(options.balcony, scene, picture, options, options.samples, (*more, *exact))
            found.append(specks(picture, reference, SUNLIT.get(name, "0.25")))
        print(f"{name:12}  {found[0]:6}  {found[1]:12}", flush=True)


if __name__ == "__main__":
    main()
