#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Measures where the error of a path-traced room is: at the border of its lamp, at glass, elsewhere.

Usage: regions.py BALCONY [SCENE...] [--samples COUNT] [--reference COUNT] [--size WxH]
                  [--seeds COUNT] [--keep FOLDER]

Needs numpy and OpenImageIO for Python (python3-numpy, python3-openimageio). The scenes are those of
peers/scenes.py; the room and the kitchen, unless some are named. Prints the processor time of a picture,
and for each region its pixels, their root-mean-square error relative to the mean of the picture, and
their share of the squared error of the picture, against one of another seed with --exact. A pixel
is at a border where the layer `emission` of that picture differs by more than 1 % from a neighbour's.
"""
import argparse
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from pictures import light

sys.path.insert(0, str(Path(__file__).resolve().parent / "peers"))
from scenes import SCENES, write  # noqa: E402

GLASS = ("glass sphere", "ball")  # Objects of the scenes.


def render(options, name, scene, samples, output, *more):
    """The processor time in seconds."""
    x, y, z = SCENES[name].position
    sky = ("--environment", str(SCENES[name].sky)) if SCENES[name].sky else ()
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([options.balcony, "render", scene, "-c", "panorama", "--set", f"px={x}", "--set",
                    f"py={y}", "--set", f"pz={z}", "--bounces", "4", "--size", options.size,
                    "--samples", str(samples), "--quiet", "-o", output, *sky, *more], check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def objects(file):
    """The name of the object at each pixel."""
    import OpenImageIO as oiio
    image = oiio.ImageBuf(str(file))
    ids = image.get_pixels(oiio.FLOAT)[:, :, image.spec().channelnames.index("object.X")]
    names = np.array(["", *image.spec().getattribute("objects")])
    return names[ids.astype(int)]


def regions(file):
    emission = light(file, "emission.").mean(axis=2)
    padded = np.pad(emission, 1, mode="edge")
    height, width = emission.shape
    around = np.stack([padded[j:j + height, i:i + width] for i in range(3) for j in range(3)])
    border = around.max(axis=0) - around.min(axis=0) > 0.01 * around.max(axis=0)
    glass = np.isin(objects(file), GLASS) & ~border
    return {"border": border, "glass": glass, "rest": ~border & ~glass, "all": border | True}


def measure(options, name, folder):
    scene, reference = folder / f"{name}.glb", folder / f"{name}-{options.reference}.exr"
    write(name, scene, SimpleNamespace(triangles=100_000, matt=False))
    if not reference.exists():
        render(options, name, scene, options.reference, reference, "--exact", "--seed", "1000",
               "--layers", "default,emission")
    truth, parts = light(reference), regions(reference)
    squares, seconds = 0.0, 0.0
    for seed in range(options.seeds):
        file = folder / f"{name}-seed.exr"
        seconds += render(options, name, scene, options.samples, file, "--seed", str(seed),
                          "--layers", "none")
        squares = squares + ((light(file) - truth) ** 2).mean(axis=2) / options.seeds
    print(f"{name}: {seconds / options.seeds:.2f} s of processor time")
    for part, where in parts.items():
        if where.any():
            print(f"  {part:6} {where.sum():6} pixels, error "
                  f"{np.sqrt(squares[where].mean()) / truth.mean():.4f}, "
                  f"{100 * squares[where].sum() / squares.sum():3.0f} % of the whole", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("balcony")
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=", ".join(SCENES))
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--reference", type=int, default=4096)
    parser.add_argument("--size", default="160x80")
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--keep", metavar="FOLDER",
                        help="for the pictures; references that are there are used again")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(options.keep or folder)
        folder.mkdir(parents=True, exist_ok=True)
        for name in options.scenes or ("room", "kitchen"):
            measure(options, name, folder)


if __name__ == "__main__":
    main()
