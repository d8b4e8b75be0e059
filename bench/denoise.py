#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Measures what --denoise leaves of the error of pictures, at several scales.

Usage: denoise.py BALCONY [--samples LIST] [--reference COUNT] [--scene NAME=ARGUMENTS]...
                  [--keep FOLDER]

Needs numpy and OpenImageIO for Python (python3-numpy, python3-openimageio). The scenes are a room
(bench/peers/room.py), and a temple and a street (plates; build_scene stands beside BALCONY). Others
are the arguments of `balcony render`, with --size and --exposure, such as
--scene 'kitchen=kitchen.glb --camera panorama --fit --environment sky --size 320x160 --exposure -11'.

Prints the root-mean-square error of what a display shows (gamma 2.2, clipped at 1, after the
exposure), of means over boxes of 1 to 16 pixels, and FLIP, before and after Balcony's filter, against
a picture with COUNT samples of another seed.
"""
import argparse
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from flip import flip
from pictures import boxes, light

ROOT = Path(__file__).resolve().parent.parent
BOXES = (1, 2, 4, 8, 16)


def built_in_scenes(balcony, folder):
    """The arguments of `balcony render` by name."""
    room, temple, street = (folder / f"{name}.glb" for name in ("room", "temple", "street"))
    subprocess.run([sys.executable, ROOT / "bench/peers/room.py", room, "--triangles", "20000"],
                   check=True)
    for scene in temple, street:
        subprocess.run([Path(balcony).resolve().parent / "plates/build_scene", scene.stem, scene],
                       check=True)
    return {
        "room": f"{room} --camera panorama --set px=0.1 --set py=0.2 --set pz=1.5"
                " --size 320x160 --exposure -3.25",
        "temple": f"{temple} --camera {ROOT}/plates/12-temple/camera.cam --size 300x200"
                  " --exposure -0.45",
        "street": f"{street} --camera {ROOT}/plates/20-street/pinhole.cam --size 320x160"
                  " --environment sky:elevation=26,azimuth=253,turbidity=2.5 --exposure -13"}


def render(balcony, scene, samples, output, *more):
    subprocess.run([balcony, "render", *shlex.split(scene), "--samples", str(samples),
                    "-o", output, "--quiet", *more], check=True)


def shown(picture, exposure, box=1):
    """What a display shows of means over boxes, linear."""
    return np.clip(boxes(picture, box) * 2 ** exposure, 0, 1)


def errors(picture, truth, exposure):
    """By size of the boxes; then FLIP."""
    return [np.sqrt(((shown(picture, exposure, box) ** (1 / 2.2)
                      - shown(truth, exposure, box) ** (1 / 2.2)) ** 2).mean()) for box in BOXES
            ] + [flip(shown(picture, exposure), shown(truth, exposure))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("balcony")
    parser.add_argument("--samples", default="8,16,32,64")
    parser.add_argument("--reference", type=int, default=4096, metavar="COUNT")
    parser.add_argument("--scene", action="append", default=[], metavar="NAME=ARGUMENTS")
    parser.add_argument("--keep", metavar="FOLDER",
                        help="for the pictures; references that are there are used again")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(options.keep or folder)
        folder.mkdir(exist_ok=True)
        scenes = built_in_scenes(options.balcony, folder)
        scenes.update(scene.split("=", 1) for scene in options.scene)
        print("scene, samples: error in boxes of " + ", ".join(map(str, BOXES))
              + " pixels, FLIP")
        for name, scene in scenes.items():
            exposure = float(scene.split("--exposure ")[1].split()[0])
            reference = folder / f"{name}-{options.reference}.exr"
            if not reference.exists():
                render(options.balcony, scene, options.reference, reference, "--seed", "1",
                       "--layers", "none")
            truth = light(reference)
            for samples in map(int, options.samples.split(",")):
                file = folder / f"{name}-{samples}-denoised.exr"
                render(options.balcony, scene, samples, file, "--denoise", "--denoiser", "features",
                       "--layers", "samples")
                before, after = (errors(light(file, layer), truth, exposure)
                                 for layer in ("noisy.", ""))
                print(f"{name:8} {samples:3}: " + " ".join(f"{e:.4f}" for e in before) + "  ->  "
                      + " ".join(f"{e:.4f}" for e in after)
                      + f"  ({before[0] / after[0]:.1f} times less)", flush=True)


if __name__ == "__main__":
    main()
