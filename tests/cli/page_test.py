# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony page: a scene and a camera in one file. tests/studio/viewer.test.mjs opens such files."""

import base64
import json
import math
import os
import re
import shlex
import struct

import support

CAMERAS = """
camera seen(width = 60deg above 0deg, count = 2) {
    axes y_up
    map u = tan(width/2) .. -tan(width/2), v = square
    eye point(0, 0, 5)
    toward surface(u, v) = [-u, v, -1]
    move repeat(count, translate(0, 0, 0.1))
}

camera bent {
    axes y_up
    map u = -1 .. 1, v = square
    eye point(0, 0, 5)
    toward surface(u, v) = [-u, v, -1]
    bend pinholes([(0, 0, 4), (0, 0, 2)], distance = 0.5)
}

picture blended { layer seen  layer seen { blend multiply } }
picture deep { layer seen  layer seen { blend by depth } }
picture some { layer seen  layer seen { hide objects("tip") } }
"""


def data_of(html):
    """What the viewer reads."""
    return json.loads(re.search(r'id="data">(.*?)</script>', html, re.DOTALL)[1])


class Page(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "my.cam").write_text(CAMERAS)
        with self.start("page", "scene.obj", "-q", "-o", "page.html") as process:
            _, err = process.communicate(timeout=120)
        if b"built without the viewer" in err and not os.environ.get("BALCONY_STUDIO"):
            self.assertEqual(process.returncode, 3)
            self.skipTest("this build has no viewer; scripts/studio --setup gets its packages")
        (self.folder / "page.html").unlink()

    def page(self, *words):
        self.run_command("page", *words, "-q", "-o", "page.html")
        return (self.folder / "page.html").read_text()

    def test_it_says_what_it_has(self):
        facts = self.json_of("page", "scene.obj", "--camera", "my.cam:seen", "-o", "page.html",
                             "--size", "320x200")
        self.assertEqual(facts["parameters"], {"open": ["width"], "closed": ["count"]})
        self.assertEqual((facts["width"], facts["height"], facts["triangles"]), (320, 200, 3))
        self.assertEqual(facts["bytes"], (self.folder / "page.html").stat().st_size)

    def test_the_same_words_make_the_same_bytes(self):
        words = ("scene.obj", "--camera", "my.cam:seen", "--background", "0.2")
        self.assertEqual(self.page(*words), self.page(*words))

    def test_parameters_have_their_limits_and_values(self):
        words = ("scene.obj", "--camera", "my.cam:seen")
        found = data_of(self.page(*words, "--set", "width=90deg"))["parameters"]
        self.assertEqual([row["name"] for row in found], ["width"])
        self.assertAlmostEqual(found[0]["value"], 1.5707963, 6)
        self.assertEqual((found[0]["min"], found[0]["minExcluded"], found[0]["unit"]),
                         (0, True, "angle"))
        self.assertEqual(data_of(self.page(*words, "--parameters", "none"))["parameters"], [])

    def test_a_camera_is_placed_as_in_a_render(self):
        # The rays of the camera that the bounds suggest start in an object, so that it is moved.
        corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        faces = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
        text = ""
        boxes = [(0, 0, 0, 20, 20, 1), (7, 1, 1, 2, 18, 9), (12, 1, 1, 2, 18, 5)]
        for number, (x, y, z, a, b, c) in enumerate(boxes):
            text += f"o box{number}\n"
            text += "".join(f"v {x + a * i} {y + b * j} {z + c * k}\n" for i, j, k in corners)
            text += "".join("f " + " ".join(str(8 * number + i) for i in face) + "\n" for face in faces)
        (self.folder / "boxes.obj").write_text(text)
        for camera in ("crossed_slits", "pinhole"):
            words = ("boxes.obj", "--camera", camera, "--fit")
            fitted = self.json_of("render", *words, "--integrator", "preview", "--samples", "1",
                                  "--size", "16x9", "-o", "picture.png")["fitted"]
            page = {row["name"]: row["value"] for row in data_of(self.page(*words))["parameters"]}
            self.assertGreater(len(fitted), 2)
            for row in fitted:
                degree = math.pi / 180 if row["unit"] == "deg" else 1
                self.assertAlmostEqual(page[row["name"]], row["value"] * degree, 4, f"{camera}: {row}")

    def test_what_cannot_be_shown_says_why(self):
        for camera, says, helps in (
                ("my.cam:bent", "its rays are bent", "remove its bend"),
                ("my.cam:blended", "it has a blend mode", "take this layer out"),
                ("my.cam:deep", "it is blended by depth", "take this layer out"),
                ("my.cam:some", "it shows some objects of the scene only", "take this layer out"),
                ("slide_mesh", "'move project(projector, onto = mesh(\"backdrop.obj\"))'",
                 "a surface with a formula")):
            self.refused("page", "scene.obj", "--camera", camera, "-o", "page.html", code=1, says=says,
                         helps=helps)
            self.assertFalse((self.folder / "page.html").exists())

    def test_a_scene_with_too_many_triangles_is_refused(self):
        def write(copies):
            corners = b"".join(struct.pack("<9f", i, 0, 0, i + 1, 0, 0, i, 1, 0) for i in range(2000))
            document = support.triangle()
            document["buffers"] = [{"byteLength": len(corners),
                                    "uri": "data:application/octet-stream;base64,"
                                           + base64.b64encode(corners).decode()}]
            document["bufferViews"][0]["byteLength"] = len(corners)
            document["accessors"][0].update(count=6000, min=[0, 0, 0], max=[2000, 1, 0])
            document["nodes"] = [{"mesh": 0, "name": f"copy {i}", "translation": [0, 2 * i, 0]}
                                 for i in range(copies)]
            document["scenes"][0]["nodes"] = list(range(copies))
            (self.folder / "copies.gltf").write_text(json.dumps(document))
        words = ("copies.gltf", "--camera", "my.cam:seen")
        write(2000)
        # All copies share their bytes.
        self.assertLess(len(self.page(*words)), 1_200_000)
        write(2001)
        self.refused("page", *words, "-o", "page.html", code=1,
                     says="has 4002000 triangles, and a page at most 4000000", helps="leave objects out")

    def test_names_of_parameters_are_checked(self):
        self.refused("page", "scene.obj", "--camera", "my.cam:seen", "--parameters", "with", "-o",
                     "page.html", code=1, says="no parameter 'with'", helps="did you mean 'width'")

    def test_the_lines_of_the_guide_run(self):
        guide = (support.REPOSITORY / "docs/page.md").read_text()
        lines = re.search(r"```sh\n(.*?)```", guide, re.DOTALL)[1].splitlines()
        self.assertEqual(len(lines), 2)
        self.run_command("draw", "superelliptic", "-o", "room.glb")
        for line in lines:
            words = shlex.split(line)
            self.assertEqual(words[0], "balcony")
            (self.folder / "my.cam").write_text(CAMERAS.split("camera bent")[0])
            self.run_command(*words[1:])
            self.assertGreater((self.folder / words[-1]).stat().st_size, 600_000)


if __name__ == "__main__":
    support.main()
