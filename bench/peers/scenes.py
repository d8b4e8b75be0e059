# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The scenes in which compare.py compares renderers, by name."""
import math
import pathlib
import sys
from typing import Callable, NamedTuple, Tuple

BENCH = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(BENCH))
from ordinary import Place  # noqa: E402
from room import Glb, make_room, quad, sphere  # noqa: E402


class Scene(NamedTuple):
    """How a scene is made, where the camera stands, with z up, and the radiance of the sky."""
    make: Callable
    position: Tuple[float, float, float]
    sky: float = 0.0


def make_heads(_options):
    """A closed room of 24 dense heads, half of them of metal, under a lamp: half a million
    triangles."""
    glb = Glb()
    white = glb.material("white", (0.75, 0.75, 0.75))
    metals = [glb.material(f"metal {i}", color, roughness=0.15 + 0.1 * i, metallic=1.0)
              for i, color in enumerate(((0.95, 0.9, 0.85), (0.9, 0.7, 0.35), (0.8, 0.5, 0.4)))]
    light = glb.material("light", (0, 0, 0), emissiveFactor=[1.0, 1.0, 1.0], extensions={
        "KHR_materials_emissive_strength": {"emissiveStrength": 12.0}})
    for name, *shape in (("floor", (-3, 0, 3), (6, 0, 0), (0, 0, -6)),
                         ("ceiling", (-3, 3, -3), (6, 0, 0), (0, 0, 6)),
                         ("back wall", (-3, 0, -3), (6, 0, 0), (0, 3, 0)),
                         ("front wall", (3, 0, 3), (-6, 0, 0), (0, 3, 0)),
                         ("left wall", (-3, 0, 3), (0, 0, -6), (0, 3, 0)),
                         ("right wall", (3, 0, -3), (0, 0, 6), (0, 3, 0))):
        glb.mesh(name, quad(*shape), white)
    glb.mesh("lamp", quad((-0.5, 2.9, -0.5), (1, 0, 0), (0, 0, 1)), light)
    for i in range(24):
        x, z = -2.25 + 0.9 * (i % 6), (-2.2, -1.3, 1.3, 2.2)[i // 6]
        centre = (x, 0.4 + 0.25 * (i % 3), z)
        glb.mesh(f"head {i + 1}", sphere(centre, 0.36, 72, 0.05),
                 metals[i // 2 % 3] if i % 2 else white)
    return glb


def make_kitchen(_options):
    """A room that sun and sky light through a window, with a table, a mirror, a ball of solid glass, a
    bowl of brass and a lamp."""
    place = Place()
    place.room(window=True)
    place.mesh("mirror", quad((-1.99, 0.8, 0.6), (0, 0, -1.2), (0, 1.4, 0)), place.mirror)
    place.box("table", (-0.7, 0.7, -0.9), (0.7, 0.75, 0.1), place.wood)
    place.box("cupboard", (1.3, 0.0, -1.6), (1.95, 0.9, 1.0), place.tiles)
    place.mesh("ball", sphere((-0.25, 0.93, -0.4), 0.18, 48), place.solid)
    place.mesh("bowl", sphere((0.35, 0.9, -0.5), 0.15, 48), place.brass)
    place.bulb((0.9, 2.3, 0.9), strength=300.0)
    place.sun()
    return place


def make_temple(_options):
    """Columns with capitals on a polished floor, under a roof, in the sun."""
    place = Place()
    ground = place.material("ground", (0.45, 0.38, 0.28))
    place.mesh("ground", quad((-60, 0, 60), (120, 0, 0), (0, 0, -120)), ground)
    place.box("floor", (-5, 0.02, -8), (5, 0.3, 8), place.tiles)
    for x in (-4.2, 4.2):
        for i in range(7):
            z = -7.2 + 2.4 * i
            place.mesh("column", pillar((x, 0.3, z), 0.45, 4.0), place.white)
            place.box("capital", (x - 0.6, 4.3, z - 0.6), (x + 0.6, 4.6, z + 0.6), place.white)
    place.box("roof", (-5.2, 4.6, -8.2), (5.2, 5.2, 8.2), place.white)
    place.sun(20.0)
    return place


def pillar(foot, radius, height, sides=24):
    """The wall of a cylinder."""
    angles = [2 * math.pi * i / sides for i in range(sides + 1)]
    x, y, z = foot
    positions = [(x + radius * math.cos(a), y + h, z - radius * math.sin(a))
                 for h in (0, height) for a in angles]
    normals = [(math.cos(a), 0.0, -math.sin(a)) for a in angles] * 2
    points = [(i / sides, v) for v in (0, 1) for i in range(sides + 1)]
    triangles = [t for i in range(sides)
                 for t in ((i, i + 1, sides + 2 + i), (i, sides + 2 + i, sides + 1 + i))]
    return positions, normals, points, triangles


SCENES = {
    "room": Scene(lambda options: make_room(options.triangles), (0.1, 0.2, 1.5)),
    "heads": Scene(make_heads, (0.0, 0.0, 1.4)),
    "kitchen": Scene(make_kitchen, (0.2, -0.7, 1.4), sky=10.0),
    "temple": Scene(make_temple, (1.5, 3.0, 1.7), sky=1.0),
}


def write(name, file, options):
    glb = SCENES[name].make(options)
    if options.matt:
        glb.make_matt()
    glb.write(file)
