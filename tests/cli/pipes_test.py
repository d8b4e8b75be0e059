# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""What is no file is refused wherever a file is read: a pipe would wait forever, and /dev/zero has
no end."""

import os

import support

SMALL = ("--size", "8x8", "-s", "1", "-o", "out.exr")


class NoFiles(support.CommandTest):
    def named(self, name):
        """A pipe, and links to a device and to a folder, with this name."""
        for make in (os.mkfifo, lambda path: os.symlink("/dev/zero", path),
                     lambda path: os.symlink(".", path)):
            make(self.folder / name)
            yield
            (self.folder / name).unlink()

    def test_scenes_and_cameras(self):
        for _ in self.named("x.glb"):
            for words in (("render", "x.glb"), ("render", "scene.obj", "--add", "x.glb")):
                self.refused(*words, *SMALL, code=1, says="not a file")
            self.refused("info", "x.glb", code=1, says="not a file")
        for _ in self.named("x.cam"):
            self.refused("check", "x.cam", code=1, says="'x.cam' is ")

    def test_parts_of_scenes_are_left_out(self):
        (self.folder / "x.obj").write_text("mtllib x.mtl\nusemtl m\n" + support.OBJ)
        for _ in self.named("x.mtl"):
            _, err = self.run_command("render", "x.obj", *SMALL)
            self.assertIn("material library skipped: 'x.mtl' is ", err)
        (self.folder / "x.mtl").write_text("newmtl m\nmap_Kd x.exr\n")
        for _ in self.named("x.exr"):
            _, err = self.run_command("render", "x.obj", *SMALL)
            self.assertIn("material 'm': its texture is skipped: 'x.exr' is ", err)

    def test_environments(self):
        for _ in self.named("x.exr"):
            self.refused("render", "scene.obj", "--environment", "x.exr", *SMALL, code=1,
                         says="'x.exr' is ")

    def test_records_of_renders(self):
        for _ in self.named("out.exr.checkpoint"):
            self.refused("render", "scene.obj", *SMALL, "--resume", code=1,
                         says="'out.exr.checkpoint' cannot be resumed")
        for _ in self.named("x.shard"):
            self.refused("merge", "x.shard", "-o", "out.exr", code=1, says="'x.shard' is ")
        for _ in self.named("f-###.png.animation"):
            self.refused("animate", "scene.obj", "--frames", "1-2", *SMALL[:4], "-o", "f-###.png",
                         code=1, says="'f-###.png.animation' is damaged")


if __name__ == "__main__":
    support.main()
