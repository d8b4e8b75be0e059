# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Names in files and names of files cannot control a terminal."""

import json
import os
import pty
import re
import urllib.parse

import support

HOSTILE = "\x1b]0;title\x07\u009b31m\u202egpj.exe\u2066\u200b\u2028"
SHOWN = "?]0;title??31m?gpj.exe???"
UNSAFE = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f]")

BOX = """v -9 -9 -9
v 9 -9 -9
v 9 9 -9
v -9 9 -9
v -9 -9 9
v 9 -9 9
v 9 9 9
v -9 9 9
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""


class Terminal(support.CommandTest):
    def says(self, *words, code=0, **how):
        """What a run writes to both streams, which must show the name and be safe."""
        out, err = self.run_command(*words, code=code, **how)
        self.assertIsNone(UNSAFE.search(out + err), ascii(out + err))
        self.assertIn(SHOWN, out + err)

    def test_names_of_objects(self):
        (self.folder / "sly.obj").write_text(f"o {HOSTILE}\n{BOX}usemtl {HOSTILE}\nf 1 2 3\n")
        (self.folder / "sly.gltf").write_text(support.gltf_text_with_light(HOSTILE))
        self.says("info", "sly.gltf", "--objects")
        self.says("check", "my.cam:above", "--scene", "sly.obj")
        self.says("locate", "my.cam:above", "--scene", "sly.gltf", "--axes", "y_up", "--point",
                  "0,0,-1")

    def test_names_in_warnings_of_a_render(self):
        document = json.loads(support.gltf_text_with_light())
        document["materials"] = [{"name": HOSTILE, "pbrMetallicRoughness": {
            "baseColorTexture": {"index": 0}}}]
        document["textures"] = [{"source": 0}]
        document["images"] = [{"uri": urllib.parse.quote(HOSTILE) + ".png"}]
        document["meshes"][0]["primitives"][0]["material"] = 0
        (self.folder / "sly.gltf").write_text(json.dumps(document))
        self.says("render", "sly.gltf", "--size", "8x8", "-s", "1", "-o", "p.png")

    def test_words_of_the_command_line(self):
        self.says(HOSTILE, code=2)
        self.says("--" + HOSTILE, code=2)
        self.says("render", HOSTILE, code=1)
        self.says("render", "scene.obj", "--size", HOSTILE, code=2)
        self.says("render", "scene.obj", HOSTILE, code=1)
        self.says("check", HOSTILE, code=1)
        self.says("explain", "my.cam:" + HOSTILE, code=1)
        self.says("explain", "my.cam:above", "--set", HOSTILE, code=1)
        self.says("list", HOSTILE, code=2)
        self.says("locate", "my.cam", "--point", HOSTILE, code=2)
        self.says("draw", "my.cam", "-o", HOSTILE, code=2)
        self.says("info", HOSTILE, code=1)
        self.says("fmt", HOSTILE, code=1)

    def test_names_of_files(self):
        (self.folder / (HOSTILE + ".cam")).write_text(support.CAMERAS)
        (self.folder / (HOSTILE + ".obj")).write_text(support.OBJ)
        self.says("info", HOSTILE + ".obj")
        self.says("check", HOSTILE + ".cam:above")
        self.says("fmt", HOSTILE + ".cam")
        self.says("draw", "my.cam:above", "-o", HOSTILE + ".svg")
        self.says("render", "scene.obj", "--size", "8x8", "-s", "1", "-o", HOSTILE + ".png")

    def test_text_of_camera_files(self):
        text = f"// {HOSTILE}\n{support.CAMERAS}"
        (self.folder / "sly.cam").write_text(text + f"camera b {{ eye /* {HOSTILE} */ sphre() }}")
        self.says("check", "sly.cam", code=1)
        (self.folder / "sly.cam").write_text(text)
        with open(self.folder / "sly.cam") as source:
            self.assertIn(HOSTILE, self.run_command("fmt", "-", stdin=source)[0])
        screen, terminal = pty.openpty()
        with open(self.folder / "sly.cam") as source:
            self.run_command("fmt", "-", stdin=source, stdout=terminal)
        os.close(terminal)
        shown = os.read(screen, 65536).decode().replace("\r\n", "\n")
        os.close(screen)
        self.assertIsNone(UNSAFE.search(shown), ascii(shown))
        self.assertIn(SHOWN, shown)

    def test_json_is_ascii_and_keeps_the_names(self):
        (self.folder / "sly.gltf").write_text(support.gltf_text_with_light(HOSTILE))
        out, _ = self.run_command("info", "sly.gltf", "--json")
        self.assertTrue(out.isascii() and "\x1b" not in out and "\x7f" not in out)
        self.assertEqual(json.loads(out)["scene"]["objects"], [HOSTILE])


if __name__ == "__main__":
    support.main()
