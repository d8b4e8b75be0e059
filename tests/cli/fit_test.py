# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""--fit and --fit-to: cameras that are placed by the size of the scene."""

import support

CAMERA = """// Looks down, and shows the whole scene.
camera plan(width = 1, px = 0, py = 0) {
    fit    width = 2*scene_radius, (px, py) = (scene_center[0], scene_center[1])
    aspect 1
    map    u = -width/2 .. width/2, v = square
    eye    surface(u, v) = [px + u, py + v, 100]
    look   along(-z)
}

// Cannot be fitted.
camera fixed {
    map  u = -1 .. 1, v = square
    eye  surface(u, v) = [u, v, 100]
    look along(-z)
}
"""

# With y up, the plan of this scene is from -2 to 2 and from -1 to 0 (x and -z).
SCENE = """o slab
v -2 0 0
v -1 0 0
v -1 0 1
v -2 0 1
f 1 4 3 2
o tile
v 1 0.1 0
v 2 0.1 0
v 2 0.1 1
v 1 0.1 1
f 5 8 7 6
"""


class Fit(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plan.cam").write_text(CAMERA)
        (self.folder / "tiles.obj").write_text(SCENE)

    def fitted(self, *words):
        out, _ = self.run_command("render", "tiles.obj", "--camera", "plan.cam:plan", "--size", "16",
                                  "-s", "1", "-o", "out.png", *words)
        lines = [line for line in out.splitlines() if line.startswith("  fitted: ")]
        return dict(word.split("=") for word in lines[0].split()[1:]) if lines else {}

    def test_the_whole_scene(self):
        self.assertEqual(self.fitted(), {})
        self.assertEqual(self.fitted("--fit"), {"width": "4.123", "px": "0", "py": "-0.5"})

    def test_an_object(self):
        self.assertEqual(self.fitted("--fit-to", "tile"),
                         {"width": "1.414", "px": "1.5", "py": "-0.5"})

    def test_set_has_the_last_word(self):
        hits = {}
        for words in ((), ("--fit",), ("--fit", "--set", "width=100")):
            facts = self.json_of("render", "tiles.obj", "--camera", "plan.cam:plan", "--size", "64",
                                 "-s", "1", "-o", "out.png", *words)
            hits[words] = facts["layers"][0]["hits"]
        self.assertGreater(hits[("--fit",)], 64 * 64 * 0.1)
        self.assertLess(hits[("--fit", "--set", "width=100")], 64 * 64 * 0.01)

    def test_mistakes(self):
        render = ("render", "tiles.obj", "-o", "out.png", "--camera")
        self.refused(*render, "plan.cam:fixed", "--fit", code=1, says="no fit statement",
                     helps="fit (px, py, pz) = scene_inside")
        self.refused(*render, "plan.cam:plan", "--fit-to", "tyle", code=1,
                     says="no object 'tyle'", helps="did you mean 'tile'?")
        self.refused("render", "tiles.obj", "-o", "out.png", "--fit", code=2,
                     says="--fit needs a camera", helps="--camera")
        self.refused(*render, "scene:", "--fit", code=2, says="--fit needs a camera",
                     helps="--camera")


if __name__ == "__main__":
    support.main()
