# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Makes a plane that emits light of each area light of the scene, as glTF has no area lights.

    blender room.blend --background --python area_lights.py --python export.py
"""

from math import cos, pi, sin

import bpy


def outline(light):
    """The corners of a light around its middle, and the area that they stand for."""
    width = light.size
    height = light.size_y if light.shape in ("RECTANGLE", "ELLIPSE") else width
    if light.shape in ("DISK", "ELLIPSE"):
        angles = [2 * pi * i / 64 for i in range(64)]
        return [(cos(a) * width / 2, sin(a) * height / 2) for a in angles], pi / 4 * width * height
    return [(x * width / 2, y * height / 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], width * height


def radiance(light, area, scale):
    """As Cycles: a quarter of the power per area. A light scales with its object, its power does not."""
    if not getattr(light, "normalize", True):
        return light.energy * 2 ** getattr(light, "exposure", 0) / 4
    return light.energy * 2 ** getattr(light, "exposure", 0) / (4 * area * abs(scale.x * scale.y))


def material(name, color, strength):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    inputs = made.node_tree.nodes["Principled BSDF"].inputs
    inputs["Base Color"].default_value = (0, 0, 0, 1)
    inputs["Emission Color" if "Emission Color" in inputs else "Emission"].default_value = (*color, 1)
    inputs["Emission Strength"].default_value = strength
    return made


def plane(lamp):
    """A light shines along -z only, and so does the plane: its back is black."""
    light = lamp.data
    corners, area = outline(light)
    count, behind = len(corners), 1e-3 * min(light.size, light.size_y)
    mesh = bpy.data.meshes.new(lamp.name)
    mesh.from_pydata([(x, y, z) for z in (0, behind) for x, y in corners], [],
                     [tuple(reversed(range(count))), tuple(range(count, 2 * count))])
    mesh.materials.append(material(lamp.name, light.color, radiance(light, area, lamp.matrix_world.to_scale())))
    mesh.materials.append(material(lamp.name + " back", (0, 0, 0), 0))
    mesh.polygons[1].material_index = 1
    made = bpy.data.objects.new(lamp.name, mesh)
    made.matrix_world = lamp.matrix_world
    return made


bpy.context.view_layer.update()
for lamp in [one for one in bpy.context.scene.objects if one.type == "LIGHT" and one.data.type == "AREA"]:
    bpy.context.scene.collection.objects.link(plane(lamp))
    bpy.data.objects.remove(lamp)
