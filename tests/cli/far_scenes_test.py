# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Scenes and cameras beyond the range in which rays can be traced: rendered without what cannot be
shown, or refused, but never a crash."""

import json

import support

TRIANGLE = "AACAvwAAgL8AAEDAAACAPwAAgL8AAEDAAAAAAAAAgD8AAEDA"  # (-1, -1, -3), (1, -1, -3), (0, 1, -3)
LIGHT = {"extensions": {"KHR_lights_punctual": {"light": 0}}}
WITHOUT_W = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 3, 0, 0]


def gltf_text(node):
    """A triangle in view, and another node."""
    return json.dumps({
        "asset": {"version": "2.0"},
        "nodes": [{"mesh": 0}, node],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36,
                     "uri": f"data:application/octet-stream;base64,{TRIANGLE}"}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}}})


class FarScenes(support.CommandTest):
    def survives(self, *words):
        """The command ends with a picture or with an error message."""
        with self.start(*words, "--size", "32x32", "-s", "2", "-o", "p.exr") as process:
            _, err = process.communicate(timeout=120)
        self.assertIn(process.returncode, (0, 1), err)
        self.assertEqual(process.returncode == 1, b"error: " in err, err)

    def test_nodes(self):
        for node in ({"mesh": 0, "translation": [2e18, 0, 0]}, {"mesh": 0, "scale": [1e-18] * 3},
                     {"mesh": 0, "scale": [1, 1, 1e-300]}, {"mesh": 0, "scale": [1e30, 1, 1]},
                     {"mesh": 0, "matrix": WITHOUT_W}, {"matrix": WITHOUT_W, **LIGHT},
                     {"translation": [1e308, 1e308, 0], **LIGHT}):
            with self.subTest(node=node):
                (self.folder / "far.gltf").write_text(gltf_text(node))
                self.survives("render", "far.gltf")
                self.survives("render", "far.gltf", "-c", "pinhole")

    def test_vertices(self):
        for size in ("1e18", "1e19", "1e38"):
            (self.folder / "far.obj").write_text(
                f"v -{size} 0 0\nv {size} 0 0\nv 0 {size} 0\nf 1 2 3\n")
            self.survives("render", "far.obj")

    def test_cameras(self):
        for distance in ("1e18", "2e18", "1e38", "1e300"):
            (self.folder / "far.cam").write_text(
                "camera far {\n    map  u = 1 .. -1, v = square\n    eye  sphere(1)\n"
                f"    move translate({distance}, 0, 0)\n}}\n")
            self.survives("render", "scene.obj", "-c", "far.cam")


if __name__ == "__main__":
    support.main()
