# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs docs/blender.md, and compares Blender's camera with Balcony's."""

import json
import re
import shutil
import struct

import guide

if shutil.which("blender") is None:
    guide.skip("Blender is not installed")

# Prints the camera, and where Blender sees some points with it, in pixels from the top left.
SIGHTINGS = """
import bpy
bpy.context.scene.camera.rotation_euler.rotate_axis("Z", {roll})
bpy.context.view_layer.update()
exec(open("camera.py").read())
from bpy_extras.object_utils import world_to_camera_view
for x in (0, 0.6):
    for y in (0.8, 1.2):
        seen = world_to_camera_view(bpy.context.scene, camera, Vector((x, y, 1.05)))
        print("seen", f"{{x}},{{y}},1.05", 1920 * seen.x, 1080 * (1 - seen.y))
"""
NUMBER = r"-?\d+\.?\d*(?:e-?\d+)?"


class BlenderGuide(guide.GuideTest):
    PAGE = "blender.md"
    # Blender takes its modules from beside the first Python of the PATH: Debian's.
    PATH = f"/usr/bin:{guide.GuideTest.PATH}"

    def test_the_export_is_complete(self):
        info = self.output_of("balcony info room.glb")
        self.assertIn("16 objects", info)
        self.assertRegex(info, r"lights +1")
        self.assertIn("through 'Camera'", self.output_of("balcony render room.glb -o first.png"))
        self.assertEqual((self.folder / "first.png").read_bytes(),
                         (self.folder / "through-blenders-camera.png").read_bytes())
        for name in ("first.png", "walls.png", "statue.png", "hazy.png"):
            self.assertGreater((self.folder / name).stat().st_size, 2000, name)

    def test_the_cameras_are_as_described(self):
        report = self.output_of("balcony check room.cam")
        self.assertIn("2 cameras, no errors", report)
        self.assertIn("no defects", report)

    def test_the_statue_is_where_blender_has_it(self):
        self.assertIn("Statue", self.output_of("balcony locate room.cam:walls"))

    def test_blenders_coordinates_are_those_of_a_camera(self):
        for roll in (0, 0.3):
            (self.folder / "sightings.py").write_text(SIGHTINGS.format(roll=roll))
            said = self.run_line("blender --background room.blend --python-exit-code 1 "
                                 "--python sightings.py")
            camera = re.search("^pinhole .*$", said, re.MULTILINE)[0]
            seen = re.findall(rf"^seen (\S+) ({NUMBER}) ({NUMBER})$", said, re.MULTILINE)
            self.assertEqual(len(seen), 4)
            for point, *pixel in seen:
                found = self.run_line(f"balcony locate {camera} --size 1920x1080 --point {point}")
                here = re.search(rf"x +({NUMBER}) +y +({NUMBER})", found)
                # The camera's angles have six digits, 1e-4 degrees; a pixel is 0.02 degrees wide.
                for ours, blenders in zip(here.groups(), pixel):
                    self.assertAlmostEqual(float(ours), float(blenders), delta=0.02)

    def test_lights_have_the_stated_units(self):
        contents = (self.folder / "room.glb").read_bytes()
        (length,) = struct.unpack("<I", contents[12:16])
        scene = json.loads(contents[20:20 + length])
        (lamp,) = scene["extensions"]["KHR_lights_punctual"]["lights"]
        self.assertAlmostEqual(lamp["intensity"], 100 * 54.35, delta=1)


if __name__ == "__main__":
    guide.main()
