# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The rays of exported sensors with their differentials, in the cameras' own axes, as JSON.

Usage: mitsuba_rays.py FOLDER OUTPUT
"""

import importlib
import json
import sys

import mitsuba as mi
import numpy as np

FOLDER, OUTPUT = sys.argv[1:]
sys.path.insert(0, FOLDER + "/mitsuba")
EXPORTS = json.load(open(FOLDER + "/exports.json"))
WIDTH, HEIGHT = int(EXPORTS["width"]), int(EXPORTS["height"])
# A part of the film, so that positions are those of the whole picture.
CROP, OFFSET = (WIDTH // 2, HEIGHT // 3), (WIDTH // 4, HEIGHT // 3)
X, Y = np.array(EXPORTS["points"]).T


def columns(v):
    return np.stack([np.broadcast_to(c.value, X.shape) for c in v.all], -1)


def of_example(name, entry):
    importlib.import_module(name)
    up = [0, 1, 0] if entry["y_up"] else [0, 0, 1]
    sensor = mi.load_dict({
        "type": name, "film": mi.Film((WIDTH, HEIGHT), CROP, OFFSET),
        "to_world": mi.ScalarTransform4f().look_at([0, 0, 0], [1, 0, 0], up)})
    assert sensor.needs_aperture_sample() == entry["lens"]
    ray, weight = sensor.sample_ray_differential(
        mi.Float(0.0), mi.Float(0.5),
        mi.Point2f(mi.Float((X - OFFSET[0]) / CROP[0]), mi.Float((Y - OFFSET[1]) / CROP[1])),
        mi.Point2f(mi.Float(0.5), mi.Float(0.5)))
    assert ray.has_differentials
    there = np.broadcast_to(weight.r.value, X.shape)
    assert set(np.unique(there)) <= {0.0, 1.0}
    o, d, o_x, o_y, d_x, d_y = map(columns, (ray.o, ray.d, ray.o_x, ray.o_y, ray.d_x, ray.d_y))
    return [None if t == 0 else {"ray": row[:6], "beside": row[6:]}
            for t, row in zip(there, np.concatenate([o, d, o_x, o_y, d_x, d_y], -1).tolist())]


mi.set_variant("llvm_ad_rgb_double")
made = {name: of_example(name, entry) for name, entry in EXPORTS["examples"].items()
        if "mitsuba" in entry.get("languages", ())}
with open(OUTPUT, "w") as file:
    json.dump(made, file)
