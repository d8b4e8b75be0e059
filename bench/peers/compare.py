#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Compares Balcony's path tracer with Blender's Cycles on the same scene, camera and processor.

Usage: compare.py BALCONY [--speed-only] [--size WxH] [--triangles COUNT] [--samples COUNT] [--matt]

Needs Blender (package blender), numpy and OpenImageIO for Python (python3-numpy,
python3-openimageio). Prints samples a second of both and their ratio, with and without the reuse of
paths, which Cycles does not do. Unless --speed-only is given, also the root-mean-square error of both
at equal time, Balcony's with its defaults, against converged pictures of their own with SAMPLES
samples, and how far these two differ.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
POSITION = (0.1, 0.2, 1.5)  # Of the camera, with z up.


def read(file):
    import OpenImageIO as oiio
    image = oiio.ImageBuf(str(file))
    return image.get_pixels(oiio.FLOAT)[:, :, :3].astype("float64")


class Room:
    def __init__(self, options, folder):
        self.options = options
        self.folder = Path(folder)
        self.scene = self.folder / "room.glb"
        subprocess.run([sys.executable, str(HERE / "room.py"), str(self.scene),
                        "--triangles", str(options.triangles)]
                       + ["--matt"] * options.matt, check=True)
        self.width, self.height = map(int, options.size.split("x"))

    def balcony(self, samples, output, seed=0, more=()):
        """The seconds of tracing."""
        x, y, z = POSITION
        facts = subprocess.run(
            [self.options.balcony, "render", str(self.scene), "--camera", "panorama",
             "--set", f"px={x}", "--set", f"py={y}", "--set", f"pz={z}", "--integrator", "path",
             "--bounces", str(self.options.bounces), "--samples", str(samples), "--seed", str(seed),
             "--filter", "blackman-harris", "--size", self.options.size, "--json",
             "-o", str(output), *more], check=True, capture_output=True, text=True)
        return json.loads(facts.stdout)["seconds"]

    def cycles(self, samples, output=None):
        """The seconds of each render, by the list of sample counts."""
        settings = self.folder / "cycles.json"
        settings.write_text(json.dumps({
            "scene": str(self.scene), "matt": self.options.matt, "output": output and str(output), "width": self.width,
            "height": self.height, "samples": samples, "bounces": self.options.bounces,
            "position": POSITION, "threads": os.cpu_count()}), encoding="utf-8")
        shown = subprocess.run(["blender", "--background", "--factory-startup", "--python",
                                str(HERE / "cycles.py"), "--", str(settings)], check=True,
                               capture_output=True, text=True).stdout
        times = [line for line in shown.splitlines() if line.startswith("times:")]
        if not times:
            sys.exit(f"Blender did not render:\n{shown[-2000:]}")
        return json.loads(times[0][6:])


def rms(picture, truth):
    """Relative to the mean, of the darker 99.9 % so that a few fireflies do not decide."""
    import numpy as np
    squares = ((picture - truth) ** 2).mean(axis=2).ravel()
    kept = np.sort(squares)[:int(len(squares) * 0.999)]
    return float(np.sqrt(kept.mean()) / truth.mean()), float(np.sqrt(squares.mean())
                                                             / truth.mean())


def speeds(room):
    """Samples a second of both, without what a render takes before its first sample."""
    few, many = room.options.few, room.options.many
    pixels = room.width * room.height
    ours = min(room.balcony(many, room.folder / "ours.exr", more=["--no-path-reuse"])
               for _ in range(2))
    reused = min(room.balcony(many, room.folder / "ours.exr") for _ in range(2))
    _, first, second = room.cycles([few, few, many])
    balcony_speed = many * pixels / ours
    cycles_speed = (many - few) * pixels / (second - first)
    print(f"{room.options.size}, {room.options.bounces} bounces, "
          f"{room.options.triangles} triangles, {os.cpu_count()} processors")
    reuse_speed = many * pixels / reused
    print(f"samples a second: Balcony without path reuse {balcony_speed:,.0f}, "
          f"Cycles {cycles_speed:,.0f}, ratio {balcony_speed / cycles_speed:.2f}; "
          f"with path reuse {reuse_speed:,.0f}, ratio {reuse_speed / cycles_speed:.2f}",
          flush=True)
    return reuse_speed / cycles_speed


def errors(room, ratio):
    """Root-mean-square errors at equal time, each against its own converged picture."""
    truth = {"Balcony": room.folder / "ours_truth.exr", "Cycles": room.folder / "cycles_truth.exr"}
    room.balcony(room.options.samples, truth["Balcony"], seed=1)
    room.cycles([room.options.samples], truth["Cycles"])
    samples = 64
    room.cycles([samples], room.folder / "cycles.exr")
    room.balcony(max(1, round(samples * ratio)), room.folder / "ours.exr")
    ours = rms(read(room.folder / "ours.exr"), read(truth["Balcony"]))
    theirs = rms(read(room.folder / "cycles.exr"), read(truth["Cycles"]))
    print(f"error in the time of {samples} samples of Cycles, relative to the mean: "
          f"Balcony {ours[0]:.4f} (all pixels {ours[1]:.4f}), "
          f"Cycles {theirs[0]:.4f} ({theirs[1]:.4f}), ratio {ours[0] / theirs[0]:.2f}")
    return truth


def agreement(room, truth):
    ours, theirs = read(truth["Balcony"]), read(truth["Cycles"])
    difference = ours.mean(axis=(0, 1)) / theirs.mean(axis=(0, 1)) - 1
    blocks = [(ours[y:y + room.height // 8, x:x + room.width // 16].mean()
               / theirs[y:y + room.height // 8, x:x + room.width // 16].mean() - 1)
              for y in range(0, room.height, room.height // 8)
              for x in range(0, room.width, room.width // 16)]
    print("mean of Balcony against Cycles by colour: "
          + ", ".join(f"{100 * d:+.2f} %" for d in difference)
          + f"; of {len(blocks)} parts of the picture the median differs by "
          + f"{100 * sorted(map(abs, blocks))[len(blocks) // 2]:.2f} %, "
          + f"the largest by {100 * max(map(abs, blocks)):.1f} %")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("balcony")
    parser.add_argument("--size", default="480x240")
    parser.add_argument("--triangles", type=int, default=100_000)
    parser.add_argument("--bounces", type=int, default=4)
    parser.add_argument("--few", type=int, default=4)
    parser.add_argument("--many", type=int, default=36)
    parser.add_argument("--samples", type=int, default=4096, help="of the converged pictures")
    parser.add_argument("--matt", action="store_true", help="the room without highlights")
    parser.add_argument("--speed-only", action="store_true")
    parser.add_argument("--keep", help="a folder for the pictures")
    options = parser.parse_args()
    if shutil.which("blender") is None:
        sys.exit("Blender is not installed; its Debian package is blender")
    with tempfile.TemporaryDirectory() as folder:
        if options.keep:
            folder = options.keep
            os.makedirs(folder, exist_ok=True)
        room = Room(options, folder)
        ratio = speeds(room)
        if not options.speed_only:
            agreement(room, errors(room, ratio))


if __name__ == "__main__":
    main()
