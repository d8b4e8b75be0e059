#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Measures what calls of the Python module cost beside the same calls in C++.

Usage: python_calls.py BUILD

BUILD is a folder of a build with the module and the benchmarks; needs numpy (python3-numpy). Prints the
least seconds of each call in C++ and in Python, in turns, and their ratio; then how long the import takes
beyond the start of the interpreter, and a picture of 64 x 64 pixels beyond one of 1 x 1.
"""
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

RUNS, TURNS = 5, 3
SIZE = (4096, 2048)


def least(call):
    taken = []
    for _ in range(RUNS):
        start = time.perf_counter()
        call()
        taken.append(time.perf_counter() - start)
    return min(taken)


def calls():
    """Those of bench/calls.cpp, by their names there."""
    import balcony
    import numpy as np

    random = np.random.default_rng(1996)
    points = random.uniform([4, -1, -1], [10, 1, 1], (1_000_000, 3))
    some = points[:100_000]
    pinhole, panorama, superelliptic = (balcony.camera(name) for name in ("pinhole", "panorama", "superelliptic"))
    return {"rays": lambda: panorama.rays(*SIZE),
            "project_pinhole": lambda: pinhole.project(points, size=SIZE),
            "project_panorama": lambda: panorama.project(points, size=SIZE),
            "project_superelliptic": lambda: superelliptic.project(some, size=SIZE),
            "jacobian": lambda: pinhole.jacobian(some, ["fov", "yaw", "pitch"], size=SIZE)}


def start_of(code):
    return least(lambda: subprocess.run([sys.executable, "-B", "-c", code], check=True))


def pictures():
    """The seconds of a call that renders 64 x 64 pixels, and of one that renders one."""
    import balcony

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "scene.obj")
        file.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
        scene, camera = balcony.load(file), balcony.camera("pinhole")
        return [least(lambda: scene.render(camera, size=size, samples=1, exact=True, exposure=0))
                for size in ((64, 64), (1, 1))]


def main():
    build = Path(sys.argv[1]).resolve()
    module = str(build / "python")
    sys.path.insert(0, module)
    os.environ["PYTHONPATH"] = module
    in_python, in_cpp = {}, {}
    made = calls()
    for _ in range(TURNS):
        lines = subprocess.run([build / "bench/balcony_bench", "calls"], check=True, capture_output=True, text=True)
        for line in filter(None, lines.stdout.splitlines()):
            name, seconds = line.split()
            in_cpp[name] = min(in_cpp.get(name, float("inf")), float(seconds))
        for name, call in made.items():
            in_python[name] = min(in_python.get(name, float("inf")), least(call))
    print(f"{'call':24}{'C++, s':>10}{'Python, s':>12}{'ratio':>8}")
    for name, seconds in in_cpp.items():
        print(f"{name:24}{seconds:>10.4f}{in_python[name]:>12.4f}{in_python[name] / seconds:>8.2f}")
    beyond = start_of("import balcony") - start_of("pass")
    print(f"\nimport balcony takes {1e3 * beyond:.0f} ms beyond the start of the interpreter")
    large, small = pictures()
    print(f"a call of 64 x 64 pixels takes {1e3 * large:.1f} ms, one of 1 x 1 {1e3 * small:.1f} ms")


if __name__ == "__main__":
    main()
