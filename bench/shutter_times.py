#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Compares samples that share the time of their pass with samples that have times of their own, on
the windmill of docs/motion.md: time, and error against many samples. Needs python3-openimageio and
python3-numpy.

    /usr/bin/python3 bench/shutter_times.py build/release/balcony
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
import OpenImageIO

SCENE = Path(__file__).resolve().parent.parent / "docs/pictures/windmill.gltf"
EXPOSURE = 0.1
# A time for each sample: a hash of its place in the picture.
VIEW = """
    axes   y_up
    aspect 8/5
    map    u = -1 .. 1, v = square
    eye    surface(u, v) = [1.2, 1.9, 11.5]
    toward surface(u, v) = [1.2 + 0.6*u, 2 + 0.6*v, 10.5]
    look   relative
"""
HASH = "43758.5*sin(1259*x + 10246*y)"
CAMERAS = f"""
camera shared {{ {VIEW} }}
camera own {{ {VIEW}    time = t + 0.1*({HASH} - floor({HASH}) - 1/2)
}}
"""


def rendered(balcony, folder, camera, integrator, samples):
    """The picture and the seconds of tracing."""
    shutter = EXPOSURE if camera == "shared" else 0
    file = f"{folder}/{camera}-{integrator}-{samples}.exr"
    said = subprocess.run(
        [balcony, "render", SCENE, "-c", f"{folder}/cameras.cam:{camera}", "--time", "0.8",
         "--shutter", str(shutter), "--size", "480x300", "-s", str(samples), "--integrator",
         integrator, "--layers", "none", "--json", "-o", file],
        check=True, capture_output=True)
    picture = OpenImageIO.ImageBuf(file).get_pixels()[:, :, :3]
    return picture, json.loads(said.stdout)["seconds"]


def main():
    balcony = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "cameras.cam").write_text(CAMERAS)
        print(f"{'integrator':<12}{'samples':>8}{'times':>8}{'seconds':>9}{'error':>10}"
              f"{'error² · seconds':>18}")
        for integrator, many in (("preview", 2048), ("path", 512)):
            truth, _ = rendered(balcony, folder, "shared", integrator, many)
            for samples in (8, 32):
                for camera in ("shared", "own"):
                    picture, seconds = rendered(balcony, folder, camera, integrator, samples)
                    error = numpy.sqrt(numpy.mean((picture - truth) ** 2))
                    print(f"{integrator:<12}{samples:>8}{camera:>8}{seconds:>9.2f}{error:>10.5f}"
                          f"{error ** 2 * seconds:>18.2e}")


if __name__ == "__main__":
    main()
