#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Compares Balcony's path tracer with Blender's Cycles on the same scenes, camera and processor.

Usage: compare.py BALCONY [SCENE...] [--speed-only] [--size WxH] [--triangles COUNT]
                  [--samples COUNT] [--matt] [--keep FOLDER]

Needs Blender (package blender), numpy and OpenImageIO for Python (python3-numpy,
python3-openimageio). The scenes are those of scenes.py, all unless some are named. A table has the
samples a second of both programs; then, in the time of 64 samples of Cycles without clamping, the
root-mean-square error of means over boxes of 1, 4 and 16 pixels, and the number of specks: pixels
brighter than 20 times the median and than twice the converged picture. Errors are relative
to the mean, and measured against a converged picture of the same program with SAMPLES samples:
Cycles without clamping, Balcony with --exact. The time of Balcony's denoiser does not count.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from scenes import SCENES, write

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from pictures import boxes, light  # noqa: E402

BOXES = (1, 4, 16)
SAMPLES = 64  # Of Cycles, whose time is the time of all.
BALCONY = {"without path reuse": ("--exact", "--no-path-reuse"), "--exact": ("--exact",),
           "as it comes": (), "--denoise": ("--denoise", "--denoiser", "features")}


class Bench:
    """A scene that both programs render, in a folder."""

    def __init__(self, name, options, folder):
        self.name = name
        self.options = options
        self.folder = folder
        self.scene = SCENES[name]
        self.file = folder / f"{name}.glb"
        write(name, self.file, options)
        self.width, self.height = map(int, options.size.split("x"))

    def balcony(self, samples, output, *more, seed=0):
        """The seconds of tracing."""
        x, y, z = self.scene.position
        sky = ("--environment", str(self.scene.sky)) if self.scene.sky else ()
        facts = subprocess.run(
            [self.options.balcony, "render", self.file, "--camera", "panorama",
             "--set", f"px={x}", "--set", f"py={y}", "--set", f"pz={z}", "--integrator", "path",
             "--bounces", str(self.options.bounces), "--samples", str(samples), "--seed", str(seed),
             "--filter", "blackman-harris", "--size", self.options.size, "--json", "--layers",
             "none", "-o", output, *sky, *more], check=True, capture_output=True, text=True)
        return json.loads(facts.stdout)["seconds"]

    def cycles(self, samples, output=None, defaults=False, seed=0):
        """The seconds of each render, by the list of sample counts."""
        settings = self.folder / "cycles.json"
        settings.write_text(json.dumps({
            "scene": str(self.file), "sky": self.scene.sky, "matt": self.options.matt,
            "defaults": defaults, "output": output and str(output), "width": self.width,
            "height": self.height, "samples": samples, "seed": seed, "bounces": self.options.bounces,
            "position": self.scene.position, "threads": os.cpu_count()}), encoding="utf-8")
        shown = subprocess.run(["blender", "--background", "--factory-startup", "--python",
                                HERE / "cycles.py", "--", settings], check=True,
                               capture_output=True, text=True).stdout
        times = [line for line in shown.splitlines() if line.startswith("times:")]
        if not times:
            sys.exit(f"Blender did not render:\n{shown[-2000:]}")
        return json.loads(times[0][6:])

    def cycles_speed(self, defaults):
        """Samples a second, without what a render takes before its first sample."""
        few, many = self.options.few, self.options.many
        _, first, second = self.cycles([few, few, many], defaults=defaults)
        return (many - few) * self.width * self.height / (second - first)

    def balcony_speed(self, more):
        many = self.options.many
        seconds = min(self.balcony(many, self.folder / "speed.exr", *more) for _ in range(2))
        return many * self.width * self.height / seconds


def rms(picture, truth):
    """Relative to the mean, of the darker 99.9 % so that a few fireflies do not decide."""
    squares = np.sort(((picture - truth) ** 2).mean(axis=2).ravel())
    return float(np.sqrt(squares[:max(1, int(len(squares) * 0.999))].mean()) / truth.mean())


def specks(picture, truth):
    found, expected = picture.mean(axis=2), truth.mean(axis=2)
    return int((found > np.maximum(20 * np.median(expected), 2 * expected)).sum())


def quality(picture, truth):
    return (" ".join(f"{rms(boxes(picture, side), boxes(truth, side)):7.4f}" for side in BOXES)
            + f" {specks(picture, truth):7}")


def agreement(ours, theirs):
    """Of the means by colour, and of 128 parts of the picture."""
    difference = ours.mean(axis=(0, 1)) / theirs.mean(axis=(0, 1)) - 1
    side = ours.shape[0] // 8
    parts = sorted(abs(boxes(ours, side).mean(axis=2) / boxes(theirs, side).mean(axis=2) - 1).ravel())
    return ("mean of Balcony against Cycles by colour: "
            + ", ".join(f"{100 * d:+.2f} %" for d in difference)
            + f"; of {len(parts)} parts of the picture the median differs by "
            + f"{100 * parts[len(parts) // 2]:.2f} %, the largest by {100 * parts[-1]:.1f} %")


def compare(bench):
    options, folder, name = bench.options, bench.folder, bench.name
    truth = {}
    if not options.speed_only:
        files = [folder / f"{name}-{program}-{options.samples}.exr"
                 for program in ("balcony", "cycles")]
        if not files[0].exists():
            bench.balcony(options.samples, files[0], "--exact", seed=1)
        if not files[1].exists():
            bench.cycles([options.samples], files[1], seed=1)
        truth = [light(file) for file in files]

    def row(renderer, speed, render, truth_index):
        samples = max(1, round(SAMPLES * speed / reference))
        line = f"{name:8} {renderer:27} {speed:11,.0f} {speed / reference:6.2f}"
        if truth:
            file = folder / f"{name}-{renderer.replace(' ', '-')}.exr"
            render(samples, file)
            line += f" {samples:8} {quality(light(file), truth[truth_index])}"
        print(line, flush=True)

    reference = bench.cycles_speed(False)
    for renderer, defaults in (("Cycles without clamping", False), ("Cycles as it comes", True)):
        row(renderer, bench.cycles_speed(True) if defaults else reference,
            lambda samples, file: bench.cycles([samples], file, defaults), 1)
    for setting, more in BALCONY.items():
        row(f"Balcony {setting}", bench.balcony_speed(more),
            lambda samples, file: bench.balcony(samples, file, *more), 0)
    if truth:
        print(f"{name:8} {agreement(*truth)}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("balcony")
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=", ".join(SCENES))
    parser.add_argument("--size", default="480x240")
    parser.add_argument("--triangles", type=int, default=100_000, help="of the room")
    parser.add_argument("--bounces", type=int, default=4)
    parser.add_argument("--few", type=int, default=4)
    parser.add_argument("--many", type=int, default=36)
    parser.add_argument("--samples", type=int, default=4096, help="of the converged pictures")
    parser.add_argument("--matt", action="store_true", help="without highlights")
    parser.add_argument("--speed-only", action="store_true")
    parser.add_argument("--keep", metavar="FOLDER",
                        help="for the pictures; converged ones that are there are used again")
    options = parser.parse_args()
    unknown = set(options.scenes) - set(SCENES)
    if unknown:
        parser.error(f"no scene is called {', '.join(sorted(unknown))}; there are "
                     + ", ".join(SCENES))
    if shutil.which("blender") is None:
        sys.exit("Blender is not installed; its Debian package is blender")
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(options.keep or folder)
        folder.mkdir(parents=True, exist_ok=True)
        print(f"{options.size}, {options.bounces} bounces, {os.cpu_count()} processors")
        print(f"{'scene':8} {'renderer':27} {'samples/s':>11} {'ratio':>6} {'samples':>8} "
              + " ".join(f"error {side:<2}" if side > 9 else f"error {side}" for side in BOXES)
              + "  specks")
        for name in options.scenes or SCENES:
            compare(Bench(name, options, folder))


if __name__ == "__main__":
    main()
