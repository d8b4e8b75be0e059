# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""A picture with one member of every class of stages at once renders without a warning."""

import support

CAMERA = """
// Rays start on a tube swept along a spline and lean from its normals to a fractal planet.
camera everything {
    aspect  16/9
    arrange mirror(x)
    map     u = 0.05 .. 0.95, v = 160deg .. -160deg
    warp    grid([(0, 0), (0, 0), (0, 0), (0, 0), (0.02, 4deg), (0, 0), (0, 0), (0, 0), (0, 0)],
                 columns = 3, from = (0, -180deg), to = (1, 180deg)),
            thin_plate([(0.2, 0deg, 0.22, 2deg), (0.5, 40deg, 0.5, 41deg), (0.8, 0deg, 0.79, 0deg)]),
            zoom(at = (0.5, 0deg), radius = (0.2, 40deg), strength = 1.5)
    eye {
        object sweep(superellipse(1, 1, 1/2), natural_spline([(0, -4, 0), (1, 0, 1), (0, 4, 0)]))
    }
    toward {
        map    u = 180deg .. -180deg, v = -70deg .. 70deg
        object fractal_sphere(20, height = 0.5, seed = 3)
    }
    move coin((2, 0, 0), strength = 0.3, radius = 2), twist(z, 2deg)
    look blend(normal(outward), relative, weight(u, v) = [0.1 + 0.05*u])
}

picture all 64 x 36 {
    layer panorama
    layer everything {
        place   (0.1, 0.1) .. (0.9, 0.9)
        arrange rotate(5deg)
        clip    rounded(0.3)
        soft    0.05
        alpha   0.9
        blend   screen
        frame(width = 0.02, color = (1, 0.5, 0))
        leader  (0.4, 0.4) .. (0.6, 0.6)
    }
}
"""


class EveryClass(support.CommandTest):
    def test_renders_without_a_warning(self):
        (self.folder / "all.cam").write_text(CAMERA)
        for name in ("everything", "all"):
            document = self.json_of("render", "room.glb", "--camera", f"all.cam:{name}", "--size",
                                    "64x36", "--samples", "2", "-o", f"{name}.exr")
            self.assertEqual(document["diagnostics"], [], name)
            self.assertGreater(document["rays"], 0)
            self.assertEqual(document["repaired"], 0)
        self.assertIn("all.exr", self.files())


if __name__ == "__main__":
    support.main()
