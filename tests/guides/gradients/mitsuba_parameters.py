# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The gradients of exported sensors by the parameters that mi.traverse() shows, beside differences of their
rays at other values of these. Prints the largest difference of each camera, as JSON by name.

Usage: mitsuba_parameters.py FOLDER NAME...
"""

import importlib
import json
import sys

import drjit as dr
import mitsuba as mi
import numpy as np

sys.path.insert(0, sys.argv[1])
X, Y = (a.ravel() for a in np.meshgrid((np.arange(16) + 0.53) / 16, (np.arange(9) + 0.48) / 9))
PLACE = mi.ScalarTransform4f().look_at([1, 2, 3], [4, 4, 2], [0, 0, 1])


def sum_of_rays(sensor):
    """One number of all rays, with a weight of its own for each coordinate, and where there are rays."""
    position = mi.Point2f(mi.Float(X), mi.Float(Y))
    ray, weight = sensor.sample_ray(mi.Float(0.0), mi.Float(0.5), position,
                                    mi.Point2f(mi.Float(0.5), mi.Float(0.5)))
    coordinates = [*ray.o.all, *ray.d.all]
    return sum((c * mi.Float(np.cos(k + 3 * X + 7 * Y)) for k, c in enumerate(coordinates[1:], 1)),
               coordinates[0] * mi.Float(np.cos(3 * X + 7 * Y))), weight.r.value


def difference(sensor, parameters, name, step):
    old = float(parameters[name].value)
    sides = []
    for one in (old + step, old - step):
        parameters[name] = one
        parameters.update()
        sides.append(sum_of_rays(sensor))
    parameters[name] = old
    parameters.update()
    there = sides[0][1] * sides[1][1]
    return np.sum(np.where(there > 0, sides[0][0].value - sides[1][0].value, 0.0)) / (2 * step), there


def compared(name):
    importlib.import_module(f"{name}_mitsuba")
    sensor = mi.load_dict({"type": name, "film": {"width": 160, "height": 90}, "to_world": PLACE})
    parameters = mi.traverse(sensor)
    worst = {}
    for one in [key for key in parameters if key != "to_world"]:
        assert parameters.flags[one] == mi.ParamFlags.Differentiable
        step = 1e-4 * max(1.0, abs(float(parameters[one].value)))
        (wide, there), (narrow, _) = (difference(sensor, parameters, one, h) for h in (step, step / 2))
        dr.enable_grad(parameters[one])
        rays, weight = sum_of_rays(sensor)
        dr.backward(dr.select(mi.Bool(there * weight > 0), rays, mi.Float(0.0)))
        found = dr.grad(parameters[one])
        gradient = 0.0 if found is None else float(found.value)
        assert np.isfinite(gradient)
        worst[one] = abs(gradient - (4 * narrow - wide) / 3) / (len(X) + abs(gradient))
        dr.disable_grad(parameters[one])
    return worst


mi.set_variant("llvm_ad_rgb_double")
print(json.dumps({name: compared(name) for name in sys.argv[2:]}))
