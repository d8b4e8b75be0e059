# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""A cube whose six faces glow in colours of their own: what a ray sees of it is known."""

import numpy as np

CENTER = np.array([0.3, 0.2, -0.1])  # In axes with y up, as the file has it.
# The outer normals of the faces and their colours.
FACES = [((1, 0, 0), (1, 0, 0)), ((-1, 0, 0), (0, 1, 1)), ((0, 1, 0), (0, 1, 0)),
         ((0, -1, 0), (1, 0, 1)), ((0, 0, 1), (0, 0, 1)), ((0, 0, -1), (1, 1, 0))]
NOTHING = 6


def write(folder):
    """cube.obj and its materials."""
    lines, materials = ["mtllib cube.mtl"], []
    for i, (normal, colour) in enumerate(FACES):
        n = np.array(normal, float)
        u = np.roll(np.abs(n), 1)
        v = np.cross(n, u)
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            lines.append("v {} {} {}".format(*(CENTER + n + a * u + b * v)))
        first = 4 * i + 1
        lines += [f"o face{i}", f"usemtl glow{i}",
                  f"f {first} {first + 1} {first + 2} {first + 3}"]
        materials += [f"newmtl glow{i}", "Kd 0 0 0", "Ks 0 0 0", "Ke {} {} {}".format(*colour)]
    (folder / "cube.obj").write_text("\n".join(lines) + "\n")
    (folder / "cube.mtl").write_text("\n".join(materials) + "\n")


def z_up(points):
    """From axes with y up."""
    x, y, z = np.moveaxis(np.asarray(points, float), -1, 0)
    return np.stack([x, -z, y], axis=-1)


def y_up(points):
    x, y, z = np.moveaxis(np.asarray(points, float), -1, 0)
    return np.stack([x, z, -y], axis=-1)


def seen(origins, directions):
    """The numbers of the faces that rays with y up meet, NOTHING for none, and how far away."""
    with np.errstate(divide="ignore", invalid="ignore"):
        near = (CENTER - np.sign(directions) - origins) / directions
        far = (CENTER + np.sign(directions) - origins) / directions
    beside = np.abs(np.broadcast_to(origins, directions.shape) - CENTER) > 1
    near = np.where(directions == 0, np.where(beside, np.inf, -np.inf), near)
    far = np.where(directions == 0, np.inf, far)
    entry = near.max(axis=-1)
    hits = (entry < far.min(axis=-1)) & (entry > 0)
    axis = near.argmax(axis=-1)
    sign = np.take_along_axis(np.sign(directions), axis[..., None], axis=-1)[..., 0]
    face = 2 * axis + (sign > 0)
    return np.where(hits, face, NOTHING), np.where(hits, entry, np.inf)


def faces_in(picture):
    """The same of a picture with alpha, as bytes."""
    bright = picture[..., :3] > 127
    made = np.full(picture.shape[:2], NOTHING)
    for i, (_, colour) in enumerate(FACES):
        made[(bright == np.array(colour, bool)).all(axis=-1) & (picture[..., 3] > 127)] = i
    return made


def inner(faces):
    """Where all eight neighbours show the same face, so that no filter mixes colours."""
    same = np.zeros(faces.shape, bool)
    middle = faces[1:-1, 1:-1]
    same[1:-1, 1:-1] = np.logical_and.reduce(
        [faces[1 + i:faces.shape[0] - 1 + i, 1 + j:faces.shape[1] - 1 + j] == middle
         for i in (-1, 0, 1) for j in (-1, 0, 1)])
    return same
