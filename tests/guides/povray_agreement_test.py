# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Renders one scene, written for POV-Ray and as glTF, through the same cameras by both programs, and
compares which object each pixel shows."""

import json
import math
import shutil
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

import guide
import png

if shutil.which("povray") is None:
    guide.skip("POV-Ray is not installed")

WIDTH, HEIGHT = 200, 120
# Boxes by two corners and spheres by centre and radius, in Balcony's axes with z up, with unlit
# colours. The floor and the walls are boxes as well, so that every ray meets something, and nothing
# is symmetrical.
BOXES = {
    "floor": ((-20, -20, -3), (20, 20, -2), (255, 255, 0)),
    "ceiling": ((-20, -20, 8), (20, 20, 9), (128, 128, 128)),
    "front": ((19, -20, -3), (20, 20, 9), (255, 128, 0)),
    "back": ((-20, -20, -3), (-19, 20, 9), (128, 255, 0)),
    "left": ((-20, 19, -3), (20, 20, 9), (0, 255, 128)),
    "right": ((-20, -20, -3), (20, -19, 9), (128, 0, 255)),
    "chest": ((5, -4, -2), (7, -2, 0.5), (0, 0, 255)),
    "shelf": ((6, 2, 1), (9, 5, 1.4), (0, 255, 255)),
    "post": ((-6, 1, -2), (-5.5, 1.5, 3), (255, 0, 255)),
}
SPHERES = {
    "ball": ((6, 0.5, 0), 1.2, (255, 0, 0)),
    "moon": ((7, 3, 3), 0.7, (0, 255, 0)),
    "side ball": ((0.5, 6, 0.5), 1.5, (128, 0, 0)),
    "rear ball": ((-7, -2, 1), 1.3, (0, 0, 128)),
}
CAMERAS = {
    "pinhole": "camera c { map u = 0.8 .. -0.8, v = square  eye point(0.2, -0.1, 0.1)\n"
               "  toward surface(u, v) = [1.2, u - 0.1, v + 0.1] }",
    "orthographic": "camera c { map u = 4 .. -4, v = square  eye plane((-2, 0, 1))  look normal\n"
                    "  move rotate(z, 7deg) }",
    "superelliptic": "camera c { map u = 180deg .. -180deg, v = -36deg .. 36deg\n"
                     "  eye product(superellipse(1, 2/3, 1/2), superellipse(2, 1, 1/2))\n"
                     "  look normal }",
    "circle and torus": "camera c { map u = 140deg .. -140deg, v = -70deg .. 70deg\n"
                        "  eye circle(1.5)  toward torus(3.5, 1) look relative }",
    "local zoom": "camera c { map u = 1 .. -1, v = square\n"
                  "  warp zoom(at = (0, 0), radius = 0.5, strength = 2.5)\n"
                  "  eye point(0, 0, 0)  toward surface(u, v) = [1, u, v] }",
    # The angle from the axis is proportional to the distance from the middle, up to a rim.
    "fisheye with a rim": "camera c { map u = 1.6 .. -1.6, v = square  eye point(0, 0, 1)\n"
                          "  toward surface(u, v) = [cos(2*sqrt(u^2 + v^2)) + sqrt(1 - u^2 - v^2)/1e9,\n"
                          "    u*sin(2*sqrt(u^2 + v^2 + 1e-9))/sqrt(u^2 + v^2 + 1e-9),\n"
                          "    1 + v*sin(2*sqrt(u^2 + v^2 + 1e-9))/sqrt(u^2 + v^2 + 1e-9)] }",
}


AXES = {
    "y_up": lambda x, y, z: f"<{x},{z},{y}>",
    "z_up": lambda x, y, z: f"<{x},{-y},{z}>",
    "y_up_right": lambda x, y, z: f"<{x},{z},{-y}>",
    "z_up_right": lambda x, y, z: f"<{x},{y},{z}>",
}


def write_povray_scene(file, axes="y_up"):
    def in_povray(point):
        return AXES[axes](*point)

    lines = ["#version 3.7;", "global_settings { assumed_gamma 1 }",
             "#default { finish { ambient 0 diffuse 0 emission 1 } }",
             "camera { location <3,4,5> look_at 0 }"]
    for low, high, color in BOXES.values():
        lines.append(f"box {{ {in_povray(low)}, {in_povray(high)} {pigment(color)} }}")
    for center, radius, color in SPHERES.values():
        lines.append(f"sphere {{ {in_povray(center)}, {radius} {pigment(color)} }}")
    file.write_text("\n".join(lines) + "\n")


def linear(byte):
    value = byte / 255
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def pigment(color):
    return "pigment { rgb <" + ",".join(f"{linear(c):.6f}" for c in color) + "> }"


def box_mesh(low, high):
    points = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1])
              for z in (low[2], high[2])]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def sphere_mesh(center, radius, rings=96, sectors=192):
    """Between the sphere and the polyhedron around it: wrong by at most 2e-4 of the radius."""
    radius *= 1 + (1 - math.cos(math.pi / sectors)) / 2
    points = []
    for i in range(rings + 1):
        polar = math.pi * i / rings
        for j in range(sectors):
            around = 2 * math.pi * j / sectors
            unit = (math.sin(polar) * math.cos(around), math.sin(polar) * math.sin(around),
                    math.cos(polar))
            points.append(tuple(c + radius * u for c, u in zip(center, unit)))
    triangles = []
    for i in range(rings):
        for j in range(sectors):
            a, b = i * sectors + j, i * sectors + (j + 1) % sectors
            # At the poles, one of the two has no area.
            triangles += [(a, a + sectors, b)] if i > 0 else []
            triangles += [(b, a + sectors, b + sectors)] if i < rings - 1 else []
    return points, triangles


def write_glb(file):
    meshes = [(name, *box_mesh(low, high), color) for name, (low, high, color) in BOXES.items()]
    meshes += [(name, *sphere_mesh(center, radius), color)
               for name, (center, radius, color) in SPHERES.items()]
    document = {"asset": {"version": "2.0"}, "scene": 0,
                "scenes": [{"nodes": list(range(len(meshes)))}],
                "extensionsUsed": ["KHR_materials_unlit"], "nodes": [], "meshes": [],
                "materials": [], "accessors": [], "bufferViews": []}
    data = b""
    for index, (name, points, triangles, color) in enumerate(meshes):
        # glTF has y up: z up (x, y, z) is (x, z, -y).
        vertices = b"".join(struct.pack("<3f", x, z, -y) for x, y, z in points)
        indices = b"".join(struct.pack("<3I", *triangle) for triangle in triangles)
        axes = list(zip(*((x, z, -y) for x, y, z in points)))
        for part, kind, count, form in ((vertices, 5126, len(points), "VEC3"),
                                        (indices, 5125, 3 * len(triangles), "SCALAR")):
            document["bufferViews"].append({"buffer": 0, "byteOffset": len(data),
                                            "byteLength": len(part)})
            document["accessors"].append({"bufferView": len(document["bufferViews"]) - 1,
                                          "componentType": kind, "count": count, "type": form})
            data += part
        document["accessors"][2 * index] |= {"min": [min(a) for a in axes],
                                             "max": [max(a) for a in axes]}
        document["materials"].append({
            "doubleSided": True, "extensions": {"KHR_materials_unlit": {}},
            "pbrMetallicRoughness": {"baseColorFactor": [*map(linear, color), 1]}})
        document["meshes"].append({"primitives": [{"attributes": {"POSITION": 2 * index},
                                                   "indices": 2 * index + 1, "material": index}]})
        document["nodes"].append({"mesh": index, "name": name})
    document["buffers"] = [{"byteLength": len(data)}]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    parts = (struct.pack("<II", len(text), 0x4E4F534A) + text
             + struct.pack("<II", len(data), 0x004E4942) + data)
    file.write_bytes(struct.pack("<III", 0x46546C67, 2, 12 + len(parts)) + parts)


COLORS = {color: name for name, (*_, color) in (BOXES | SPHERES).items()}


def object_of(pixel):
    """The name of the object of a pixel: that of the nearest colour."""
    if pixel[3] == 0:
        return "no ray"
    return COLORS[min(COLORS, key=lambda c: sum(abs(a - b) for a, b in zip(c, pixel)))]


class Agreement(unittest.TestCase):
    AXES = tuple(AXES)

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="balcony-povray-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        write_povray_scene(cls.folder / "scene.pov")
        write_glb(cls.folder / "scene.glb")

    def picture(self, command, *options):
        subprocess.run([guide.BALCONY, *command, "--camera", "c.cam", "--size",
                        f"{WIDTH}x{HEIGHT}", "--aspect", "stretch", "--samples", "1", "--quiet", "-o",
                        "picture.png", *options], cwd=self.folder, check=True)
        return [[object_of(pixel) for pixel in row]
                for row in png.read(self.folder / "picture.png")]

    def objects(self, camera, *options, scene="scene.pov"):
        (self.folder / "c.cam").write_text(camera)
        return (self.picture(("render", "scene.glb"), "--integrator", "path", "--no-dither",
                             "--view-transform", "standard", "--exposure", "0"),
                self.picture(("pov", scene), *options))

    def share(self, name, ours, theirs):
        """Prints the share of equal pixels; fails if a pixel differs that is not at an edge."""
        different = [(x, y) for y in range(HEIGHT) for x in range(WIDTH)
                     if ours[y][x] != theirs[y][x]]
        share = 1 - len(different) / (WIDTH * HEIGHT)
        shown = {name for row in ours for name in row}
        print(f"{name}: the same object at {100 * share:.3f} % of the pixels, {len(shown)} objects")
        for x, y in different:
            around = {ours[j][i] for j in range(max(y - 1, 0), min(y + 2, HEIGHT))
                      for i in range(max(x - 1, 0), min(x + 2, WIDTH))}
            self.assertGreater(len(around), 1, f"{name}: {ours[y][x]} is {theirs[y][x]} at {x},{y}")
        self.assertGreater(share, 0.995, name)
        self.assertGreaterEqual(len(shown), 5, name)
        return share

    def test_every_pixel_shows_the_same_object(self):
        for name, camera in CAMERAS.items():
            with self.subTest(name):
                ours, theirs = self.objects(camera)
                self.share(name, ours, theirs)
                self.assertEqual(name == "fisheye with a rim", "no ray" in ours[0])

    def test_scenes_of_all_axes_look_the_same(self):
        for axes in self.AXES:
            with self.subTest(axes):
                write_povray_scene(self.folder / "turned.pov", axes)
                ours, theirs = self.objects(CAMERAS["pinhole"], "--axes", axes, scene="turned.pov")
                self.share(f"pinhole, {axes}", ours, theirs)

    def test_a_lens_takes_the_same_points(self):
        camera = CAMERAS["pinhole"].replace("}", "  lens(0.1, focus = 5) }")
        ours, theirs = self.objects(camera)
        self.assertGreater(self.share("lens", ours, theirs), 0.999)

    def test_a_mirrored_picture_would_be_noticed(self):
        ours, theirs = self.objects(CAMERAS["pinhole"])
        mirrored = [row[::-1] for row in theirs]
        equal = sum(a == b for p, q in zip(ours, mirrored) for a, b in zip(p, q))
        self.assertLess(equal / (WIDTH * HEIGHT), 0.9)


if __name__ == "__main__":
    guide.main()
