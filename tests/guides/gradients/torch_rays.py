# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The rays of exported PyTorch functions with their gradients, as JSON on standard output.

Usage: torch_rays.py FOLDER OUTPUT
"""

import importlib
import json
import sys

import torch

FOLDER, OUTPUT = sys.argv[1:]
sys.path.insert(0, FOLDER + "/torch")
EXPORTS = json.load(open(FOLDER + "/exports.json"))
SIZE = EXPORTS["width"], EXPORTS["height"]
POSITIONS = torch.tensor(EXPORTS["points"], dtype=torch.float64)


def rays_of(origin, direction, valid):
    return [[*o, *d] if v else None for o, d, v in
            zip(origin.tolist(), direction.tolist(), valid.tolist())]


def slopes_of(outputs, inputs):
    """The derivatives of the 6 coordinates of rays by inputs of one number for each ray."""
    found = []
    for output in outputs:
        for axis in range(3):
            for one in inputs:
                one.grad = None
            if output.requires_grad:
                output[..., axis].sum().backward(retain_graph=True)
            found.append([[0.0] * len(output) if one.grad is None else one.grad.tolist()
                          for one in inputs])
    return found


def check_kinds(ray, x, y, double):
    """A point, a grid and single precision give the same rays, in the dtype of what is given."""
    one = ray(float(x[7]), float(y[7]), *SIZE)
    assert one[0].shape == (3,) and one[0].dtype == torch.get_default_dtype()
    assert bool(one[2]) == bool(double[2][7])
    grid = ray(x.reshape(9, 16), y.reshape(9, 16), *SIZE)
    assert grid[0].shape == (9, 16, 3) and grid[2].shape == (9, 16)
    assert str(grid[1].reshape(-1, 3).tolist()) == str(double[1].tolist())
    single = ray(x.to(torch.float32), y.to(torch.float32), *SIZE, torch.tensor(0.0, dtype=torch.float64))
    assert single[0].dtype == single[1].dtype == torch.float32
    return rays_of(*single)


def differences(find_from, points, positions):
    """The derivatives of the positions of points, by x, y and z of these: central differences."""
    steps = torch.tensor([[[side * (k == axis) for k in range(3)]] for axis in range(3)
                          for side in (1e-5, -1e-5)], dtype=torch.float64)
    moved = find_from((points + steps).reshape(-1, 3), torch.stack([positions] * 6).reshape(-1, 2), *SIZE)[0]
    sides = moved.reshape(6, len(points), 2)
    return [((sides[2 * axis] - sides[2 * axis + 1]) / 2e-5).tolist() for axis in range(3)]


def of_example(name, entry):
    module = importlib.import_module(name)
    ray = getattr(module, name + "_ray")
    x, y = (POSITIONS[:, i].clone().requires_grad_() for i in (0, 1))
    made = ray(x, y, *SIZE)
    slopes = slopes_of(made[:2], (x, y))
    with torch.no_grad():
        single = check_kinds(ray, x.detach(), y.detach(), made)
    found = None
    if entry["located"]:
        points = torch.tensor([one["point"] for one in entry["located"]], dtype=torch.float64,
                              requires_grad=True)
        positions, distances = getattr(module, name + "_find")(points, *SIZE)
        found = {"positions": positions.tolist(), "distances": distances.tolist()}
        for i in (0, 1):
            points.grad = None
            column = positions[:, i]
            column[torch.isfinite(distances)].sum().backward(retain_graph=True)
            found["xy"[i]] = points.grad.tolist()
        found["differences"] = differences(getattr(module, name + "_find_from"), points.detach(),
                                           positions.detach())
    return {"rays": rays_of(*made), "slopes": slopes, "single": single, "found": found}


if __name__ == "__main__":
    made = {name: of_example(name, entry) for name, entry in EXPORTS["examples"].items()
            if "torch" in entry.get("languages", ())}
    with open(OUTPUT, "w") as file:
        json.dump({"torch": getattr(torch, "__version__", "a stand-in"),
                   "examples": made}, file)
