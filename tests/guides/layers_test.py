# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Reads the layers of an EXR file with Blender's compositor and with oiiotool."""

import re
import shutil
import tempfile
import unittest
from pathlib import Path

import guide

for program in ("blender", "oiiotool"):
    if shutil.which(program) is None:
        guide.skip(f"{program} is not installed")

# Two squares side by side; the right one is nearer.
SCENE = """
mtllib two.mtl
v -1 0 0
v 0 0 0
v 0 1 0
v -1 1 0
v 0 0 0.5
v 1 0 0.5
v 1 1 0.5
v 0 1 0.5
o left "one"
usemtl red
f 1 2 3 4
o right
usemtl blue
f 5 6 7 8
"""
MATERIALS = """
newmtl red
Kd 1 0 0
newmtl blue
Kd 0 0 1
"""
# Rays along -z, over the two squares at time 0; it moves to the right by 8 pixels a second.
CAMERA = """
camera flat {
    axes y_up
    aspect 2
    map  u = -1 .. 1, v = 0 .. 1
    eye  surface(u, v) = [ u + t/4, v, 2 ]
    toward surface(u, v) = [ u + t/4, v, 0 ]
    look relative
}
"""
# Prints the passes of the file, the names that a Cryptomatte node finds, and the values of a pass
# and of a matte in the middle of either half.
COMPOSITION = """
import bpy
scene = bpy.context.scene
scene.use_nodes = True
scene.render.resolution_x, scene.render.resolution_y = 64, 32
scene.render.resolution_percentage = 100
scene.view_settings.view_transform = "Standard"
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
image = bpy.data.images.load("//two.exr")
tree = scene.node_tree
tree.nodes.clear()
layers = tree.nodes.new("CompositorNodeImage")
layers.image = image
print("passes", *(output.name for output in layers.outputs if output.enabled))
output = tree.nodes.new("CompositorNodeComposite")


def show(name, socket):
    tree.links.new(socket, output.inputs["Image"])
    scene.render.filepath = f"//{name}.exr"
    bpy.ops.render.render(write_still=True)
    made = bpy.data.images.load(f"//{name}.exr")
    pixel = lambda x: list(made.pixels)[4 * (16 * 64 + x):][:3]
    print("shown", name, *pixel(16), *pixel(48))


for name in ("albedo", "direct", "position", "ray_length", "object", "parameters", "motion"):
    show(name, layers.outputs[name])
for layer, name in (("CryptoObject", "right"), ("CryptoMaterial", "red")):
    matte = tree.nodes.new("CompositorNodeCryptomatteV2")
    matte.source = "IMAGE"
    matte.image = image
    matte.layer_name = layer
    matte.matte_id = name
    show(f"{layer}-{name}", matte.outputs["Matte"])
"""


class Layers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="balcony-layers-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        for name, text in (("two.obj", SCENE), ("two.mtl", MATERIALS), ("flat.cam", CAMERA),
                           ("composition.py", COMPOSITION)):
            (cls.folder / name).write_text(text)
        cls.run_line("balcony render two.obj --camera flat.cam --size 64x32 --samples 4 "
                     "--integrator direct --layers all --fps 1 -o two.exr")

    @classmethod
    def run_line(cls, line):
        return guide.run_line(line, cls.folder, f"{guide.BALCONY.parent}:/usr/bin:"
                              + guide.GuideTest.PATH)

    def test_blender_shows_each_layer_as_a_pass(self):
        self.run_line("blender --background --python-exit-code 1 --python-expr "
                      "\"import bpy; bpy.ops.wm.save_as_mainfile(filepath=__import__('os').path.abspath('two.blend'))\"")
        said = self.run_line("blender --background two.blend --python-exit-code 1 "
                             "--python composition.py")
        self.assertNotIn("multilayer read", said)
        passes = re.search("^passes (.*)$", said, re.MULTILINE)[1].split()
        for name in ("Combined", "position", "object", "magnification", "indirect", "variance",
                     "CryptoObject00", "CryptoMaterial02"):
            self.assertIn(name, passes)
        shown = {name: [float(word) for word in values.split()] for name, values in
                 re.findall(r"^shown (\S+) (.*)$", said, re.MULTILINE)}
        expected = {"albedo": (1, 0, 0, 0, 0, 1), "ray_length": (2, 2, 2, 1.5, 1.5, 1.5),
                    "object": (1, 1, 1, 2, 2, 2), "motion": (8, 0, 8, 8, 0, 8),
                    "CryptoObject-right": (0, 0, 0, 1, 1, 1),
                    "CryptoMaterial-red": (1, 1, 1, 0, 0, 0)}
        for name, values in expected.items():
            for seen, wanted in zip(shown[name], values, strict=True):
                self.assertAlmostEqual(seen, wanted, delta=1e-3, msg=name)
        # The pixels' centres are at -0.484 and 0.516 from the middle, of one unit to either side.
        self.assertAlmostEqual(shown["position"][0], -0.484, delta=1e-3)
        self.assertAlmostEqual(shown["position"][3], 0.516, delta=1e-3)
        self.assertAlmostEqual(shown["position"][5], 0.5, delta=1e-3)
        self.assertAlmostEqual(shown["parameters"][0], -0.484, delta=1e-3)
        self.assertGreater(shown["direct"][0], 0.01)

    def test_oiiotool_finds_each_channel(self):
        said = self.run_line("oiiotool --info -v two.exr")
        for text in ("64 x   32", "position.X", "object.X", "CryptoObject02.A", "objects: ",
                     "cryptomatte/3ae39a5/name: \"CryptoObject\""):
            self.assertIn(text, said)
        extracted = self.run_line("oiiotool two.exr --ch object.X --printstats")
        self.assertRegex(extracted, r"Stats Min: 1\.0+")
        self.assertRegex(extracted, r"Stats Max: 2\.0+")


if __name__ == "__main__":
    guide.main()
