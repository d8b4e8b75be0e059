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
# A lamp of 100 W whose object is stretched.
AREA_LAMP = """
import bpy
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.object.light_add(type="AREA", location=(0, 0, 2))
lamp = bpy.context.object
lamp.scale.x = 2
lamp.data.energy, lamp.data.shape, lamp.data.size, lamp.data.size_y = 100, "RECTANGLE", 1, 1
"""
NUMBER = r"-?\d+\.?\d*(?:e-?\d+)?"


def document(file):
    """The JSON of a GLB file."""
    contents = file.read_bytes()
    (length,) = struct.unpack("<I", contents[12:16])
    return json.loads(contents[20:20 + length])


def quick(line):
    """The last option of a kind counts, and nothing here looks at noise."""
    return f"{line} --samples 2" if line.startswith("balcony render") else line


class BlenderGuide(guide.GuideTest):
    PAGE = "blender.md"
    # Blender takes its modules from beside the first Python of the PATH: Debian's.
    PATH = f"/usr/bin:{guide.GuideTest.PATH}"
    EDIT = staticmethod(quick)

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
        (lamp,) = document(self.folder / "room.glb")["extensions"]["KHR_lights_punctual"]["lights"]
        self.assertAlmostEqual(lamp["intensity"], 100 * 54.35, delta=1)

    def test_area_lights_become_planes(self):
        export = (self.folder / "export.py").read_text().replace("room.glb", "lamp.glb")
        (self.folder / "lamp.py").write_text(AREA_LAMP)
        (self.folder / "export_lamp.py").write_text(export)
        script = guide.REPOSITORY / "contrib/blender/area_lights.py"
        self.run_line("blender --background --python-exit-code 1 --python lamp.py "
                      f"--python {script} --python export_lamp.py")
        info = self.run_line("balcony info lamp.glb")
        self.assertRegex(info, r"lights +0")
        self.assertIn("(-1, 2, -0.5) .. (1, 2.001, 0.5)", info)
        (light,) = [material for material in document(self.folder / "lamp.glb")["materials"]
                    if "emissiveFactor" in material]
        strength = light["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"]
        self.assertAlmostEqual(strength, 100 / (4 * 2), delta=1e-4)


if __name__ == "__main__":
    guide.main()
