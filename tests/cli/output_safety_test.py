# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Output files are complete or not written, and never replace an input."""

import os
import resource
import shutil
import subprocess
import unittest

import support

SMALL = ("--size", "8x8", "-s", "1")


class Output(support.CommandTest):
    def test_names_that_cannot_be(self):
        def refuses(output, code, says, helps=""):
            self.refused("render", "scene.obj", *SMALL, "-o", output, code=code, says=says,
                         helps=helps)

        (self.folder / "folder.png").mkdir()
        before = self.files()
        refuses(".", 2, "'.' is a folder", "{scene}.png")
        refuses("folder.png", 2, "'folder.png' is a folder")
        refuses("picture", 2, "'picture'", ".png, .jpg")
        refuses("picture.gif", 2, "'picture.gif' is a film", "balcony animate makes films")
        refuses("picture.bmp", 2, "'picture.bmp'", ".png, .jpg")
        refuses("", 2, "''")
        refuses("no/picture.png", 3, "no folder")
        refuses("scene.obj/picture.png", 3, "no folder")
        refuses("/proc/picture.png", 3, "'/proc/picture.png'")
        refuses(250 * "x" + ".png", 3, "cannot be written: File name too long", "another name")
        self.assertEqual(self.files(), before)

    def test_default_is_the_scene_s_name_here(self):
        (self.folder / "scenes").mkdir()
        shutil.move(self.folder / "room.glb", self.folder / "scenes")
        self.run_command("render", "scenes/room.glb", *SMALL)
        self.assertIn("room.png", self.files())
        self.assertEqual(os.listdir(self.folder / "scenes"), ["room.glb"])

    def test_a_link_stays_a_link(self):
        (self.folder / "real.png").write_bytes(b"old")
        (self.folder / "link.png").symlink_to("real.png")
        self.run_command("render", "scene.obj", *SMALL, "-o", "link.png")
        self.assertTrue((self.folder / "link.png").is_symlink())
        self.assertEqual(support.png_pixels(self.folder / "real.png")[:2], (8, 8))

    def test_inputs_are_not_overwritten(self):
        def refuses(*words):
            before = {name: (self.folder / name).read_bytes() for name in self.files()}
            self.refused("render", *words, *SMALL, code=2, says="would be overwritten",
                         helps="--output")
            after = {name: (self.folder / name).read_bytes() for name in self.files()}
            self.assertEqual(before, after)

        for name, input_file in (("s.png", "scene.obj"), ("c.png", "my.cam")):
            (self.folder / name).symlink_to(input_file)
        os.link(self.folder / "scene.obj", self.folder / "hard.png")
        refuses("scene.obj", "-o", "s.png")
        refuses("scene.obj", "-o", "hard.png")
        refuses("scene.obj", "-o", "c.png", "-c", "my.cam:above")

    def test_a_texture_named_as_the_scene_is_not_overwritten(self):
        self.run_command("render", "scene.obj", *SMALL, "-o", "paint.png")
        before = (self.folder / "paint.png").read_bytes()
        (self.folder / "paint.mtl").write_text("newmtl m\nmap_Kd paint.png\n")
        (self.folder / "paint.obj").write_text(
            "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\n"
            "f 1/1 2/2 3/3\n")
        self.refused("render", "paint.obj", *SMALL, code=2, says="would be overwritten")
        self.assertEqual((self.folder / "paint.png").read_bytes(), before)
        self.run_command("render", "paint.obj", *SMALL, "-o", "other.png")


# What the command reads, and then its words with the output, which is one of the files read.
INPUTS = (
    ("the camera file", "export my.cam:above --to c -o", "my.cam"),
    ("an imported file", "export imports.cam --to c -o", "my.cam"),
    ("a table", "export table.cam --to c -o", "table.csv"),
    ("a link to a table", "draw table.cam -o", "table.svg"),
    ("a ray map", "rays rays.cam --size 8x4 -o", "rays.npy"),
    ("a link to a ray map", "rays rays.cam --size 8x4 -o", "link.npy"),
    ("a ray map", "locate rays.cam --point 1,0,0 --axes z_up -o", "rays.npy"),
    ("an STMap", "stmap st.cam --from panorama --size 8 --allow-parallax -o", "st.exr"),
    ("the photo's map", "stmap panorama --from st.cam --size 8 --allow-parallax -o", "st.exr"),
    ("a mask", "draw mask.cam -o", "mask.png"),
    ("a hard link to a mask", "draw mask.cam -o", "hard.png"),
    ("a mask", "check mask.cam --size 8x8 --map seams", "mask.png"),
    ("a scene", "check my.cam:above --size 8x8 --scene paint.obj --map seams", "paint.png"),
    ("the photo", "warp mask.png --from panorama -c pinhole --size 8 -o", "mask.png"),
    ("a mask", "warp photo.png --from panorama -c mask.cam --size 8 -o", "mask.png"),
)


class Inputs(support.CommandTest):
    def setUp(self):
        super().setUp()

        def write(name, text):
            (self.folder / name).write_text(text)

        self.run_command("render", "scene.obj", *SMALL, "-o", "mask.png")
        shutil.copy(self.folder / "mask.png", self.folder / "photo.png")
        shutil.copy(self.folder / "mask.png", self.folder / "paint.png")
        os.link(self.folder / "mask.png", self.folder / "hard.png")
        self.run_command("rays", "pinhole", "--size", "16x9", "-o", "rays.npy")
        (self.folder / "link.npy").symlink_to("rays.npy")
        self.run_command("stmap", "fisheye", "--from", "panorama", "--size", "16", "-o", "st.exr")
        write("imports.cam", 'import "my.cam"\ncamera n { morph above .. closeup, amount = x }')
        write("mask.cam", 'picture p { aspect 1 layer pinhole { clip image("mask.png") } }')
        write("rays.cam", 'camera r { map u = 0 .. 1, v = 1 .. 0 eye ray_map("rays.npy") '
              'toward ray_map("rays.npy", points = directions) look absolute }')
        write("table.csv", "-1,-1,-1,-1\n1,-1,1,-1\n1,1,1,1\n-1,1,-1,1\n")
        (self.folder / "table.svg").symlink_to("table.csv")
        write("table.cam", 'camera plate { map u = 1 .. -1, v = square '
              'warp thin_plate("table.csv") eye point toward plane((1, 0, 0)) }')
        write("st.cam", 'camera s { aspect 1 map u = 0 .. 1, v = 1 .. 0 warp stmap("st.exr") '
              'eye plane look normal }')
        write("paint.mtl", "newmtl m\nmap_Kd paint.png\n")
        write("paint.obj", "mtllib paint.mtl\nusemtl m\n" + support.OBJ)

    def test_no_command_replaces_a_file_that_it_reads(self):
        before = {name: (self.folder / name).read_bytes() for name in self.files()}
        for what, words, output in INPUTS:
            with self.subTest(what, words=words):
                words = words.split()
                self.refused(*words, output, code=2, helps=words[-2 if "--map" in words else -1],
                             says=f"'{output}' is read here and would be overwritten")
                after = {name: (self.folder / name).read_bytes() for name in self.files()}
                self.assertEqual(before, after)


class LittleMemory(support.CommandTest):
    def test_is_told_of(self):
        def little_memory():
            bytes_ = 700 * 2**20
            resource.setrlimit(resource.RLIMIT_AS, (bytes_, bytes_))

        before = self.files()
        for words in (("--size", "1000000x1", "-o", "p.exr"),
                      ("--size", "4000x3000", "-o", "p.exr"),
                      ("--size", "9000x9000", "-o", "p.png")):
            with self.subTest(words=words):
                _, err = self.run_command("render", "scene.obj", "-s", "1", "-q", *words, code=3,
                                          preexec_fn=little_memory)
                self.assertRegex(err, "(?m)^error: .*(out of|not enough) memory.*\n  help: ")
                self.assertNotIn("std::", err)
                self.assertEqual(self.files(), before)


class FullDisk(support.CommandTest):
    def setUp(self):
        super().setUp()
        self.disk = self.folder / "disk"
        self.disk.mkdir()
        if not shutil.which("mount"):
            raise unittest.SkipTest("not run: mount is not installed")
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "balcony", self.disk],
                                 capture_output=True, check=False)
        if mounted.returncode != 0:
            raise unittest.SkipTest("not run: no disk can be mounted here: "
                                    + mounted.stderr.decode().strip())
        self.addCleanup(subprocess.run, ["umount", self.disk], check=True)

    def test_keeps_the_old_file_and_leaves_nothing(self):
        (self.disk / "filling").write_bytes(bytes(60 * 1024))
        for name in ("picture.png", "picture.exr"):
            old = self.disk / name
            old.write_bytes(b"old")
            _, err = self.run_command("render", "scene.obj", "--size", "700x400", "-s", "2", "-o",
                                      str(old), code=3)
            self.assertIn(f"'{old}' cannot be written: No space left on device", err)
            self.assertEqual(old.read_bytes(), b"old")
            self.assertEqual(sorted(os.listdir(self.disk)), ["filling", name])
            old.unlink()


if __name__ == "__main__":
    support.main()
