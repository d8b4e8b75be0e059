# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Cameras of rays that a function of NumPy computes, or that were measured."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from . import _texts
from ._cameras import Camera

if TYPE_CHECKING:
    import numpy as np

_LARGEST = 2048


class Sampled(NamedTuple):
    """A camera of sampled rays, and how far it is from what was sampled."""

    camera: Camera
    size: tuple[int, int]
    """Columns and rows of the samples."""
    angle_error: float
    """The largest angle between a ray of the camera and that of the function midway between the samples, in
    radians; NaN for arrays, between whose rays nothing is known, and where both have no ray midway."""
    origin_error: float
    """The same for the distance of their origins, in scene units."""


def from_rays(rays: Callable | tuple[np.ndarray, ...], file: str | os.PathLike, *,
              size: tuple[int, int] = (256, 256), tolerance: float | None = None,
              aspect: float | None = None, axes: str = "z_up", name: str = "sampled") -> Sampled:
    """A camera of the rays that a function computes, or of arrays of rays.

        def spiral(x, y):
            angle = 2 * np.pi * x
            out = np.stack([np.cos(angle), -np.sin(angle), 0 * x], axis=-1)
            return out * (1 + y)[..., None], out

        made = balcony.from_rays(spiral, "spiral.npy", size=(512, 256))
        picture = balcony.render("room.glb", made.camera)

    The function receives two arrays (height, width) of places in the picture, as fractions from its top left
    corner, and returns origins and directions, arrays (height, width, 3), and, where there are not rays
    everywhere, a third array of bool. Directions may have any length, and a direction of 0 is no ray. It is
    called when the camera is made, and never during a render.

    Its rays at the middles of `size` columns and rows are written to a ray map, `file` (.npy), and the camera
    interpolates them by cubic convolution. The error is measured midway between samples, where it is largest.
    With `tolerance`, an angle in radians, the samples are doubled until it is kept; if 2048 are not enough,
    that is a ValueError. Such a camera has no parameters; all else, derivatives, inverse, checks and exports,
    is that of any camera. A stage of formulas (balcony.formulas) has no such error: prefer it where the
    function can be written with its operations.
    """
    import numpy as np

    file = os.fspath(file)
    if not file.endswith(".npy"):
        raise ValueError(f"'{file}' is no name of an array: use one that ends in .npy")
    if not callable(rays):
        table = _table_of(rays, None)
        np.save(file, table)
        shape = table.shape[1::-1]
        return Sampled(_camera(name, file, aspect or shape[0] / shape[1], axes), shape, np.nan, np.nan)
    columns, rows = size
    if not (1 < columns <= _LARGEST and 1 < rows <= _LARGEST):
        raise ValueError(f"'size' is {size}, but 2 to {_LARGEST} columns and rows are needed")
    while True:
        np.save(file, _samples(rays, columns, rows))
        camera = _camera(name, file, aspect or size[0] / size[1], axes)
        angle, distance = _errors(rays, camera, columns, rows)
        if tolerance is None or angle <= tolerance:
            return Sampled(camera, (columns, rows), angle, distance)
        if 2 * max(columns, rows) > _LARGEST:
            if math.isnan(angle):
                raise ValueError(f"the error of {columns} x {rows} rays cannot be measured: nowhere midway between "
                                 "them have both the function and the camera a ray; close the gaps between its "
                                 "rays, or leave out 'tolerance'")
            raise ValueError(f"{columns} x {rows} rays are off by up to {angle:.2g} radians midway between "
                             "them, more than the tolerance: perhaps they change abruptly somewhere")
        columns, rows = 2 * columns, 2 * rows


def _camera(name: str, file: str, aspect: float, axes: str) -> Camera:
    map_file = _texts.quoted(file)
    return Camera(f"camera {name} {{\n    aspect {aspect!r}\n    axes   {axes}\n    map    u = 0 .. 1, v = 0 .. 1\n"
                  f"    eye    ray_map({map_file})\n    toward ray_map({map_file}, targets)\n}}\n", name)


def _samples(function: Callable, columns: int, rows: int) -> np.ndarray:
    import numpy as np

    x, y = np.meshgrid((np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows)
    return _table_of(function(x, y), (rows, columns))


def _table_of(rays, shape: tuple[int, int] | None) -> np.ndarray:
    """An array (height, width, 7): origins, unit directions, and whether there is a ray."""
    import numpy as np

    if not isinstance(rays, tuple) or len(rays) not in (2, 3):
        raise TypeError("rays are a tuple of origins and directions, and perhaps of where there are rays")
    origins, directions = (np.asarray(one, float) for one in rays[:2])
    shape = shape or directions.shape[:2]
    for what, one in (("origins", origins), ("directions", directions)):
        if one.ndim not in (1, 3) or one.shape[-1] != 3 or one.ndim == 3 and one.shape[:2] != shape:
            raise ValueError(f"the {what} have the shape {one.shape}, but {(*shape, 3)} is needed")
    if len(shape) != 2 or 0 in shape:
        raise ValueError(f"the directions have the shape {directions.shape}, but (height, width, 3) is needed")
    valid = np.asarray(rays[2], bool) if len(rays) == 3 else np.ones(shape, bool)
    if valid.shape != shape:
        raise ValueError(f"where there are rays has the shape {valid.shape}, but {shape} is needed")
    table = np.empty((*shape, 7))
    table[..., :3], table[..., 3:6] = origins, directions
    largest = np.abs(table[..., 3:6]).max(axis=-1)
    valid = valid & (largest != 0)
    if not np.isfinite(table[..., :6][valid]).all():
        row, column = np.argwhere(valid & ~np.isfinite(table[..., :6]).all(axis=-1))[0]
        raise ValueError(f"the ray in column {column} of row {row} has a number that is not finite, but it is "
                         "not said that there is no ray")
    if not valid.any():
        raise ValueError(f"there is no ray at any of {shape[1]} x {shape[0]} places")
    table[~valid] = 0
    # In two steps, as the square of a length may be beyond all numbers.
    table[valid, 3:6] /= largest[valid, None]
    table[valid, 3:6] /= np.linalg.norm(table[valid, 3:6], axis=-1)[:, None]
    table[..., 6] = valid
    return table


def _errors(function: Callable, camera: Camera, columns: int, rows: int) -> tuple[float, float]:
    import numpy as np

    x, y = np.meshgrid(np.arange(1, columns) / columns, np.arange(1, rows) / rows)
    wanted = _table_of(function(x, y), (rows - 1, columns - 1)).reshape(-1, 7)
    found = camera.rays_at(np.stack([x.ravel() * columns, y.ravel() * rows], axis=-1), size=(columns, rows))
    both = found.valid & (wanted[:, 6] != 0)
    if not both.any():
        return np.nan, np.nan
    chord = np.linalg.norm(found.directions[both] - wanted[both, 3:6], axis=-1)
    distance = np.linalg.norm(found.origins[both] - wanted[both, :3], axis=-1)
    return float(2 * np.arcsin(min(chord.max() / 2, 1))), float(distance.max())
