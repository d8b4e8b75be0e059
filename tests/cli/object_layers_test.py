# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Layers of some objects in shards, crops, films and pairs: with the camera of the master in all layers,
each is what a single layer gives."""

import support

# A wall, and a square that cuts through a ledge before it; all are seen along x.
SCENE = """
o wall
v 5 -4 -4
v 5 4 -4
v 5 4 4
v 5 -4 4
f 1 4 3 2
o square
v 3 -1 -1
v 3.4 1 -1
v 3.4 1 1
v 3 -1 1
f 5 8 7 6
o ledge
v 3.2 -2 -0.3
v 3.2 2 -0.3
v 3.2 2 0.4
v 3.2 -2 0.4
f 9 12 11 10
"""

CAMERAS = """
camera plain(side = 0) {
    map    u = 0.8 .. -0.8, v = square
    eye    point(0, 0.2*t, 0.1*t)
    toward plane((1, 0, 0))
    move   translate(0, side, 0)
}
picture parts {
    layer plain { hide objects("square", "ledge") }
    layer plain { show objects("square")  blend by depth }
    layer plain { show objects("ledge")  blend by depth }
}
picture askew {
    layer plain { hide objects("square", "ledge") }
    layer plain(side = 0.5) { show objects("square")  blend by depth }
    layer plain(side = -0.5) { show objects("ledge")  blend by depth }
}
"""

WORDS = ("--integrator", "direct", "--samples", "4", "--size", "150x70", "--exposure", "0",
         "--environment", "0.4,0.5,0.6")


class ObjectLayers(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "things.obj").write_text(SCENE)
        (self.folder / "parts.cam").write_text(CAMERAS)

    def rendered(self, camera, *words, files=("p.png",), output="p.png", verb="render"):
        self.run_command(verb, "things.obj", "-c", f"parts.cam:{camera}", *WORDS, *words, "-o",
                         output)
        return [support.png_pixels(self.folder / name) for name in files]

    def test_parts_are_the_plain_picture(self):
        for words, more in (((), {}),
                            (("--crop", "90x50+20+15"), {}),
                            (("--stereo", "side_by_side", "--separation", "0.3"), {}),
                            (("--shutter", "1/10"), {}),
                            (("--frames", "2-3", "--overwrite"),
                             {"verb": "animate", "output": "f.#.png",
                              "files": ["f.2.png", "f.3.png"]})):
            with self.subTest(words=words):
                plain = self.rendered("plain", *words, **more)
                self.assertTrue(plain == self.rendered("parts", *words, **more))
                self.assertTrue(plain != self.rendered("askew", *words, **more))

    def test_shards_merge_to_the_whole(self):
        whole = self.rendered("askew")
        for i in (1, 2, 3):
            self.rendered("askew", "--shard", f"{i}/3", output="q.png", files=())
        self.run_command("merge", *[f"q.png.shard-{i}-of-3" for i in (1, 2, 3)])
        self.assertTrue([support.png_pixels(self.folder / "q.png")] == whole)

    def test_a_check_tells_of_what_a_layer_shows(self):
        def never_seen(layer):
            (file,) = self.json_of("check", "parts.cam:askew", "--scene", "things.obj", "--layer",
                                   layer)["files"]
            return file["reports"][0]["in_scene"]["never_seen"]

        (self.folder / "parts.cam").write_text(CAMERAS.replace("side = 0.5", "side = 50"))
        self.assertEqual(never_seen("1"), [])
        self.assertEqual(never_seen("2"), ["square"])
        self.assertEqual(never_seen("3"), [])


if __name__ == "__main__":
    support.main()
