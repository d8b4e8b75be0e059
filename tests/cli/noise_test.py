# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""render --noise: as many samples as it takes."""

import time

import support


class Noise(support.CommandTest):
    WORDS = ("render", "scene.obj", "-c", "my.cam:above", "--size", "80x60", "--integrator",
             "preview")

    def test_samples_where_there_is_noise(self):
        facts = self.json_of(*self.WORDS, "--noise", "0.02", "-o", "p.png")
        self.assertGreater(facts["mean_samples"], 16)
        self.assertLess(facts["mean_samples"], 200)
        out, _ = self.run_command(*self.WORDS, "--noise", "0.02", "-s", "40", "-o", "p.png")
        self.assertIn("16 to 40 samples per pixel, on average", out)

    def test_it_is_relative_to_the_exposure(self):
        # A soft shadow under a dim sky.
        words = ("render", "scene.obj", "-c", "my.cam:above", "--set", "size=0.9", "--size", "24x18",
                 "--environment", "0.004", "--noise", "0.005", "-s", "256")
        alone = self.json_of(*words, "-o", "alone.png")
        self.assertGreater(alone["exposure"], 2)
        given = self.json_of(*words, "--exposure", repr(alone["exposure"]), "-o", "given.png")
        self.assertEqual((self.folder / "alone.png").read_bytes(),
                         (self.folder / "given.png").read_bytes())
        self.assertEqual(alone["mean_samples"], given["mean_samples"])
        dark = self.json_of(*words, "--exposure", "0", "-o", "dark.png")
        self.assertLess(dark["mean_samples"], 0.5 * alone["mean_samples"])
        # A shard and a frame of an animation have the white of the picture.
        for number in "12":
            self.run_command(*words, "--shard", f"{number}/2", "-o", "p.png")
        self.run_command("merge", "p.png.shard-1-of-2", "p.png.shard-2-of-2")
        self.run_command("animate", *words[1:], "--frames", "1", "--same-noise", "-o", "f.#.png")
        for name in ("p.png", "f.1.png"):
            self.assertEqual((self.folder / name).read_bytes(),
                             (self.folder / "alone.png").read_bytes())

    def test_resumed_it_is_the_same(self):
        words = ("render", "scene.obj", "-c", "my.cam:above", "--size", "200x150", "--integrator",
                 "preview", "--noise", "0.0001", "-s", "3000", "-q")
        self.run_command(*words, "-o", "whole.exr")
        process = self.start(*words, "--checkpoint-every", "0.05s", "-o", "p.exr")
        while not (self.folder / "p.exr.checkpoint").exists():
            self.assertIsNone(process.poll(), "it ended early")
            time.sleep(0.002)
        process.kill()
        process.communicate()
        self.run_command(*words, "--resume", "-o", "p.exr")
        self.assertEqual((self.folder / "p.exr").read_bytes(),
                         (self.folder / "whole.exr").read_bytes())

    def test_refused(self):
        for text in ("-1", "2", "nan", "low"):
            self.refused(*self.WORDS, f"--noise={text}", "-o", "p.png", code=2,
                         says="--noise cannot be")


if __name__ == "__main__":
    support.main()
