# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The gradients of exported PyTorch functions by the parameters of cameras, beside the differences of
exported NumPy functions. Prints the largest difference of each camera, as JSON by name.

Usage: torch_parameters.py FOLDER NAME...
"""

import importlib
import inspect
import json
import sys

import numpy as np
import torch

sys.path.insert(0, sys.argv[1])
SIZE = 160.0, 90.0
# A parameter whose value is the end of its range has no derivative.
INSIDE = {"panini": {"s": 0.2}}
X, Y = (a.ravel() for a in np.meshgrid(np.arange(5, 160, 10) + 0.3, np.arange(5, 90, 10) - 0.2))


def numbers(ray, values):
    o, d, valid = ray(X, Y, *SIZE, **values)
    return np.concatenate([o, d], -1), valid


def differences(ray, values, name):
    """Central ones of two steps, without the error of the order of their squares."""
    def central(step):
        (high, a), (low, b) = (numbers(ray, {**values, name: values[name] + one})
                               for one in (step, -step))
        return (high - low) / (2 * step), a & b
    step = 1e-4 * max(1.0, abs(values[name]))
    (wide, a), (narrow, b) = central(step), central(step / 2)
    return (4 * narrow - wide) / 3, a & b


def compared(name):
    functions = {language: getattr(importlib.import_module(f"{name}_{language}"), f"{name}_ray")
                 for language in ("numpy", "torch")}
    values = {one.name: one.default for one in
              list(inspect.signature(functions["numpy"]).parameters.values())[4:]
              if one.name not in ("t", "lens_x", "lens_y")} | INSIDE.get(name, {})
    worst = {}
    for parameter in values:
        expected, valid = differences(functions["numpy"], values, parameter)
        learnt = torch.tensor(values[parameter], dtype=torch.float64, requires_grad=True)
        made = functions["torch"](torch.tensor(X, dtype=torch.float64), torch.tensor(Y, dtype=torch.float64),
                                  *SIZE, **{**values, parameter: learnt})
        valid &= made[2].numpy()
        # Sums over rays: a learnt number has one gradient, of all rays together.
        for i in range(6):
            learnt.grad = None
            column = made[i // 3][:, i % 3]
            if not column.requires_grad:
                gradient = 0.0
            else:
                column[torch.tensor(valid)].sum().backward(retain_graph=True)
                gradient = 0.0 if learnt.grad is None else float(learnt.grad)
            total = expected[valid, i].sum()
            scale = 1.0 + np.abs(expected[valid, i]).sum()
            worst[parameter] = max(worst.get(parameter, 0.0), abs(gradient - total) / scale)
    return worst


print(json.dumps({name: compared(name) for name in sys.argv[2:]}))
