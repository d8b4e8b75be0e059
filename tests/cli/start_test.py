# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""What the command loads: OpenImageIO with the first image that is no PNG or JPEG file, or EXR file to
be written, and not before; PROJ with the first camera that is a map."""

import os
import shutil
import subprocess
from pathlib import Path

import support

MASKED = """// Shows what the mask shows.
picture masked {
    layer panorama {
        fill
        clip image("mask.tif")
    }
}
"""


PAINTED = """mtllib paint.mtl
v 0 0 0
v 1 0 0
v 0 1 0
vt 0 0
vt 1 0
vt 0 1
usemtl paint
f 1/1 2/2 3/3
"""


class Start(support.CommandTest):
    def libraries(self, *words):
        """What the dynamic linker says of the libraries that it loads."""
        _, err = self.run_command(*words, env=os.environ | {"LD_DEBUG": "files"})
        self.assertIn("libstdc++", err)
        return err

    def test_commands_without_other_images_do_not_load_it(self):
        self.run_command("render", "scene.obj", "-W", "8", "-s", "1", "-o", "paint.png")
        self.run_command("render", "scene.obj", "-W", "8", "-s", "1", "-o", "mask.jpg")
        (self.folder / "masked.cam").write_text(MASKED.replace("mask.tif", "mask.jpg"))
        (self.folder / "painted.obj").write_text(PAINTED)
        (self.folder / "paint.mtl").write_text("newmtl paint\nmap_Kd paint.png\n")
        for words in (("--version",), ("render", "--help"), ("list", "cameras"),
                      ("complete", "render", "scene.obj", "--camera", "p"),
                      ("fmt", "my.cam"), ("check", "my.cam:above"), ("explain", "panorama"),
                      ("export", "panorama", "--to", "c"), ("info", "scene.obj"),
                      ("locate", "panorama", "--point", "1,2,3"), ("draw", "panorama", "-o", "rays.svg"),
                      ("rays", "panorama", "-W", "8", "-o", "rays.npy"),
                      ("render", "scene.obj", "-W", "8", "-s", "1", "-o", "picture.exr"),
                      ("render", "scene.obj", "-W", "8", "-s", "1", "-o", "picture.png"),
                      ("render", "scene.obj", "-W", "8", "-s", "1", "-o", "picture.jpg"),
                      ("render", "painted.obj", "-W", "8", "-s", "1", "-o", "painted.png"),
                      ("check", "masked.cam")):
            with self.subTest(words):
                said = self.libraries(*words)
                self.assertNotIn("libOpenImageIO", said)
                self.assertNotIn("libproj", said)

    def test_maps_load_proj(self):
        for words in (("check", "robin"), ("rays", "robin", "-W", "8", "-o", "rays.npy")):
            with self.subTest(words):
                said = self.libraries(*words)
                self.assertIn("libproj", said)
                self.assertNotIn("libOpenImageIO", said)

    def test_images_load_it(self):
        for words in (("render", "scene.obj", "-W", "8", "-s", "1", "-o", "picture.webp"),
                      ("warp", "picture.webp", "--from", "pinhole", "-c", "pinhole", "-W", "8",
                       "-o", "warped.png")):
            with self.subTest(words):
                self.assertIn("libOpenImageIO", self.libraries(*words))


class Installation(support.CommandTest):
    """The executable finds its module by its own place."""

    def setUp(self):
        super().setUp()
        self.balcony = self.folder / "bin" / "balcony"
        self.balcony.parent.mkdir()
        (self.folder / "masked.cam").write_text(MASKED)
        (self.folder / "painted.obj").write_text(PAINTED)
        (self.folder / "paint.mtl").write_text("newmtl paint\nmap_Kd paint.tif\n")
        for name in ("paint.tif", "mask.tif"):
            (self.folder / name).write_bytes(b"an image")

    def run_copy(self, *words):
        run = subprocess.run([self.balcony, *words], cwd=self.folder, stdin=subprocess.DEVNULL,
                             capture_output=True, text=True, timeout=120)
        return run.returncode, run.stderr

    def assert_incomplete(self, *reasons):
        for words in (("render", "scene.obj", "-o", "picture.webp"), ("check", "masked.cam"),
                      ("render", "painted.obj", "-W", "8", "-o", "painted.exr"),
                      ("warp", "paint.tif", "--from", "pinhole", "-c", "pinhole", "-o", "w.exr")):
            code, said = self.run_copy(*words)
            self.assertEqual(code, 3, said)
            for reason in ("the installation is incomplete: ", *reasons):
                self.assertIn(reason, said)
        self.assertFalse({"picture.webp", "painted.exr", "w.exr"} & set(self.files()))
        self.assertEqual(self.run_copy("list", "cameras"), (0, ""))
        self.assertEqual(self.run_copy("render", "scene.obj", "-W", "8", "-s", "1", "-q",
                                       "-o", "picture.png"), (0, ""))

    def module(self, name="images"):
        return next(Path(support.BALCONY).parent.glob(f"balcony_{name}-*.so"))

    def test_without_the_module_of_maps(self):
        shutil.copy(support.BALCONY, self.balcony)
        name = self.module("proj").name
        for text in (None, "no library"):
            if text:
                (self.balcony.parent / name).write_text(text)
            code, said = self.run_copy("check", "robin")
            self.assertEqual(code, 3, said)
            self.assertIn("the installation is incomplete: ", said)
            self.assertIn(name, said)
            self.assertIn("PROJ" if text else "install Balcony again", said)
            self.assertEqual(self.run_copy("check", "panorama")[0], 0)

    def test_without_the_module(self):
        shutil.copy(support.BALCONY, self.balcony)
        self.assert_incomplete("there is no '", self.module().name, "install Balcony again")

    def test_a_module_that_cannot_be_loaded(self):
        shutil.copy(support.BALCONY, self.balcony)
        (self.balcony.parent / self.module().name).write_text("no library")
        self.assert_incomplete(str(self.balcony.parent / self.module().name), "OpenImageIO")

    def test_a_link_to_the_executable(self):
        self.balcony.symlink_to(support.BALCONY)
        self.assertEqual(self.run_copy("render", "scene.obj", "-W", "8", "-s", "1", "-q",
                                       "-o", "picture.webp"), (0, ""))


if __name__ == "__main__":
    support.main()
