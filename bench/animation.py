#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Measures what a frame of `balcony animate` costs beside tracing its rays and writing its file, which
`balcony render` does, too: moving the scene and preparing it, the first look at the lights, the film.
Of each scene, the medians over the frames and the maximum.

    python3 bench/animation.py build/release/balcony SCENE...
"""

import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

FRAMES = 24
SIZE = "1280x720"


def frames_of(balcony, scene, folder):
    """The seconds of each frame, and of these the ones for tracing and for writing."""
    done = subprocess.run(
        [balcony, "animate", scene, "--frames", f"1-{FRAMES}", "--size", SIZE, "--samples", "1",
         "--integrator", "preview", "--turntable", "--overwrite", "-o", str(folder / "f.##.png"),
         "--json"],
        check=True, capture_output=True)
    return [(one["seconds"], one["trace_seconds"], one["write_seconds"])
            for one in json.loads(done.stdout)["pictures"]]


def main():
    balcony, scenes = sys.argv[1], sys.argv[2:]
    print("| scene | frame, ms | tracing, ms | file, ms | besides, ms | at most, ms |")
    print("|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            frames = frames_of(balcony, scene, Path(folder))
            besides = [1000 * (whole - traced - written) for whole, traced, written in frames]
            whole, traced, written = (1000 * statistics.median(part) for part in zip(*frames))
            print(f"| {Path(scene).name} | {whole:.0f} | {traced:.0f} | {written:.0f} | "
                  f"{statistics.median(besides):.0f} | {max(besides):.0f} |")


if __name__ == "__main__":
    main()
