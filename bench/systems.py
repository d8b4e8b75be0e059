#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes rays and pictures that two systems or processors should agree on.

Usage: systems.py BALCONY FOLDER [SCENE ...]

For each built-in camera and each camera file of the repository, FOLDER/NAME.rays has 24 x 16 rays of
its first layer as doubles, unless they are bent. For each scene, FOLDER has pictures through three
cameras by each integrator. Of the folders of two systems, "diff -rq" names the files that differ, and
"oiiotool --diff" says by how much.
"""
import json
import pathlib
import re
import subprocess
import sys

if len(sys.argv) < 3:
    sys.exit(__doc__.strip())
balcony, folder, scenes = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
repository = pathlib.Path(__file__).parent.parent
folder.mkdir(parents=True, exist_ok=True)


def run(*command):
    return subprocess.run([balcony, *map(str, command)], check=True, stdout=subprocess.PIPE).stdout


cameras = {camera["name"]: camera["name"] for camera in json.loads(run("list", "cameras", "--json"))["cameras"]}
for pattern in ("plates/*/camera.cam", "examples/*.cam"):
    for file in sorted(repository.glob(pattern)):
        cameras["-".join(file.relative_to(repository).with_suffix("").parts)] = file
for name, camera in cameras.items():
    if isinstance(camera, pathlib.Path) and re.search(r"^\s*bend ", camera.read_text(), re.MULTILINE):
        continue
    rays = run("rays", camera, "--layer", 1, "--size", "24x16", "--format", "double", "-q")
    (folder / f"{name}.rays").write_bytes(rays)

for scene in map(pathlib.Path, scenes):
    for camera in ("pinhole", "panorama", "superelliptic"):
        for integrator in ("preview", "direct", "path"):
            run("render", scene, "--camera", camera, "--integrator", integrator, "--samples", 16, "--size", "160x90",
                "--exposure", 0, "-q", "-o", folder / f"{scene.stem}-{camera}-{integrator}.exr")
