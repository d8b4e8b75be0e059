# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Pictures in parts: `render --shard` and `merge`.

Usage: shards_test.py BALCONY
"""

import os
import struct
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import support  # noqa: E402


class Shards(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "room.glb").write_bytes(support.glb_bytes())

    # Not a multiple of the tiles' size, with several of them in each direction.
    SIZE = ("--size", "150x70", "--samples", "4")

    def render(self, *words):
        self.run_command("render", "room.glb", *self.SIZE, *words)

    def render_shards(self, count, *words, leave_out=()):
        for number in range(1, count + 1):
            if number not in leave_out:
                self.render("--shard", f"{number}/{count}", *words)

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def shard_names(self, picture, count):
        return [f"{picture}.shard-{number}-of-{count}" for number in range(1, count + 1)]

    def test_merged_pictures_equal_the_whole(self):
        for picture, words in (("p.png", ()), ("p.exr", ("--layers", "all")),
                               ("p.png", ("--denoise", "--denoiser", "features")),
                               ("p.png", ("--crop", "90x50+20+15", "--background", "0.3")),
                               ("p.png", ("--noise", "0.05", "--no-dither", "--view-transform", "agx", "--samples", "64"))):
            with self.subTest(words=words):
                self.render("-o", f"whole-{picture}", *words)
                for count in (1, 2, 3):
                    self.render_shards(count, "-o", picture, *words)
                    names = self.shard_names(picture, count)
                    self.run_command("merge", *reversed(names))
                    self.assertEqual(self.bytes_of(picture), self.bytes_of(f"whole-{picture}"))
                    if count == 2:
                        self.run_command("merge", *names, "-o", "other.png")
                        self.assertTrue((self.folder / "other.png").exists())
                    for name in names:
                        (self.folder / name).unlink()

    def test_more_shards_than_tiles(self):
        self.render("-o", "whole.exr")
        self.render_shards(9, "-o", "p.exr")
        self.run_command("merge", *self.shard_names("p.exr", 9))
        self.assertEqual(self.bytes_of("p.exr"), self.bytes_of("whole.exr"))

    def test_a_missing_shard_is_named_and_can_be_rendered_alone(self):
        self.render_shards(3, "-o", "p.exr", leave_out=(2,))
        names = self.shard_names("p.exr", 3)
        self.refused("merge", names[0], names[2], code=1, says="1 of 3 shards missing: 2/3",
                     helps="render with --shard 2/3")
        self.assertFalse((self.folder / "p.exr").exists())
        self.render("--shard", "2/3", "-o", "p.exr")
        self.run_command("merge", *names)

    def test_damaged_shards(self):
        self.render_shards(2, "-o", "p.exr")
        first, second = self.shard_names("p.exr", 2)
        whole = self.bytes_of(second)
        for damaged in (b"", whole[:40], whole[:-1], whole + b"x",
                        whole[:-200] + bytes([whole[-200] ^ 1]) + whole[-199:],
                        whole.replace(struct.pack("<QQ", 150, 70),
                                      struct.pack("<QQ", 950, 70), 1), b"nothing"):
            with self.subTest(size=len(damaged)):
                (self.folder / second).write_bytes(damaged)
                err = self.refused("merge", first, second, code=1, says=f"'{second}'")
                self.assertRegex(err, "damaged or no shard|do not belong together")
        self.refused("merge", "room.glb", code=1,
                     says="'room.glb' cannot be merged: it is damaged or no shard")
        self.refused("merge", "nowhere", code=1, says="there is no file 'nowhere'")

    def test_shards_of_other_renders(self):
        self.render("--shard", "1/2", "-o", "p.exr")
        first = "p.exr.shard-1-of-2"
        for words, says in (((*self.SIZE[:3], "8"), "--samples was '4' and is '8'"),
                            (("--seed", "1"), "--seed was"),
                            (("--size", "150x71"), "--size was '150x70' and is '150x71'")):
            with self.subTest(words=words):
                self.render("--shard", "2/2", "-o", "q.exr", *words)
                self.refused("merge", first, "q.exr.shard-2-of-2", code=1, says=says,
                             helps="merge the shards of one render")
        self.render("--shard", "2/3", "-o", "q.exr")
        self.refused("merge", first, "q.exr.shard-2-of-3", code=1, says="one is 1/2, the other 2/3")
        self.refused("merge", first, first, code=1, says="both are shard 1/2")

    def test_files_that_change_between_shards(self):
        camera = self.folder / "my.cam"
        camera.write_text(support.CAMERAS)
        self.render("--shard", "1/2", "-o", "p.exr", "--camera", "my.cam")
        camera.write_text(support.CAMERAS + "// Another file.\n")
        self.render("--shard", "2/2", "-o", "p.exr", "--camera", "my.cam")
        self.refused("merge", *self.shard_names("p.exr", 2), code=1,
                     says="the file 'my.cam' has changed")

    def test_wrong_usage(self):
        for text in ("0/3", "4/3", "1", "1/", "/2", "a/b", "1/0", "1/1000000", "-1/2", "1.5/2"):
            self.refused("render", "room.glb", f"--shard={text}", code=2,
                         says=f"--shard cannot be '{text}'")
        self.refused("render", "room.glb", "--shard", "1/2", "--save-every", "1s", code=2,
                     says="exclude each other")
        self.refused("render", "room.glb", "--shard", "1/2", "--watch", code=2,
                     says="exclude each other")

    def test_an_unwritable_place(self):
        self.render_shards(1, "-o", "p.exr")
        self.refused("merge", *self.shard_names("p.exr", 1), "-o", "no/folder/p.exr", code=3,
                     says="no/folder")

    def test_facts(self):
        self.render_shards(2, "-o", "p.exr")
        facts = self.json_of("merge", *self.shard_names("p.exr", 2))
        self.assertEqual((facts["output"], facts["shards"], facts["width"]), ("p.exr", 2, 150))


if __name__ == "__main__":
    support.main()
