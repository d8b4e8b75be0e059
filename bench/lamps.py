#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Measures what many lamps cost: a hall with 20 and with 20,000 lamps of the same light in all.

Usage: lamps.py BALCONY FOLDER [--lamps COUNT ...] [--samples COUNT] [--reference COUNT] [--size WxH]

The lamps hang at random places above the heads in a hall with sixty pillars and a glossy floor; each
second one has a texture in which a quarter shines. The picture looks down, as the edges of small lamps
that are seen would have most of the noise. The script prints for each hall the seconds of
preparing it and of tracing, the error against a reference with another seed, relative to the mean, and
the seconds for the error of the first hall, as a ratio. Needs numpy and OpenImageIO for Python.
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE / "peers"))
from compare import rms  # noqa: E402
from ordinary import Place  # noqa: E402
from pictures import light  # noqa: E402
from room import png, quad  # noqa: E402

LENGTH, WIDTH, HEIGHT = 40.0, 20.0, 5.0
AREA = 8.0  # Of all lamps.


class Hall(Place):
    def __init__(self, lamps):
        super().__init__()
        self.box("hall", (0, 0, 0), (LENGTH, HEIGHT, WIDTH), self.white)
        self.mesh("floor", quad((0, 0.01, WIDTH), (LENGTH, 0, 0), (0, 0, -WIDTH)), self.wood)
        for i in range(60):
            x, z = 2 + 4 * (i % 10), 1.7 + 3.3 * (i // 10)
            self.box("pillar", (x, 0, z), (x + 0.5, HEIGHT, z + 0.5), self.white)
        strength = {"KHR_materials_emissive_strength": {"emissiveStrength": 20.0}}
        quarter = self.texture(png(64, 64, lambda x, y: (255,) * 3 if x < 32 and y < 32 else (0,) * 3))
        side = math.sqrt(AREA / lamps)
        shape = quad((-0.5, 0, -0.5), (1, 0, 0), (0, 0, 1))
        meshes = []
        for name, more in (("lamp", {}), ("picture", {"emissiveTexture": {"index": quarter}})):
            material = self.material(name, (0, 0, 0), emissiveFactor=[1.0, 0.9, 0.7],
                                     extensions=strength, **more)
            self.mesh(name, shape, material)
            meshes.append(len(self.json["meshes"]) - 1)
            self.json["nodes"].pop()
            self.json["scenes"][0]["nodes"].pop()
        places = random.Random(1)
        for i in range(lamps):
            self.json["nodes"].append({
                "name": f"lamp {i}", "mesh": meshes[i % 2], "scale": [side, 1, side],
                "translation": [places.uniform(0.5, LENGTH - 0.5), places.uniform(3, HEIGHT - 0.1),
                                places.uniform(0.5, WIDTH - 0.5)]})
            self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)


def render(options, scene, samples, output, seed):
    """What the command tells of it."""
    shown = subprocess.run(
        [options.balcony, "render", scene, "--camera", "pinhole", "--set", "px=13", "--set", "py=-10.2",
         "--set", "pz=1.6", "--set", "pitch=-25deg", "--set", "fov=75deg", "--integrator", "path",
         "--exact", "--samples", str(samples), "--seed", str(seed), "--size", options.size, "--json",
         "--layers", "none", "-o", output], check=True, capture_output=True, text=True).stdout
    return json.loads(shown)


def main():
    parser = argparse.ArgumentParser(description="measures what many lamps cost")
    parser.add_argument("balcony")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--lamps", type=int, nargs="+", default=[20, 20_000], metavar="COUNT")
    parser.add_argument("--samples", type=int, default=64, metavar="COUNT")
    parser.add_argument("--reference", type=int, default=2048, metavar="COUNT")
    parser.add_argument("--size", default="240x120", metavar="WxH")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    print("  lamps  preparing  tracing    error  seconds for the error of the first")
    first = None
    for lamps in options.lamps:
        scene = options.folder / f"hall-{lamps}.glb"
        Hall(lamps).write(scene)
        truth = options.folder / f"hall-{lamps}-{options.size}-{options.reference}.exr"
        if not truth.exists():
            render(options, scene, options.reference, truth, 1)
        facts = render(options, scene, options.samples, options.folder / f"hall-{lamps}.exr", 0)
        error = rms(light(options.folder / f"hall-{lamps}.exr"), light(truth))
        cost = facts["seconds"] * error ** 2
        first = first or cost
        prepared = facts["load_seconds"] + facts["build_seconds"]
        print(f"{lamps:7} {prepared:10.2f} {facts['seconds']:8.2f} {error:8.4f}  {cost / first:6.2f} x",
              flush=True)


if __name__ == "__main__":
    main()
