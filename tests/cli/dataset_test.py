# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony dataset: recipes, shards, interruptions. tests/dataset/layouts_test.py reads the files."""

import json
import os
import resource
import signal
import time

import support

RECIPE = """
layers = ["rgb", "depth"]
scenes = ["scene.obj"]
cameras = ["slit.cam:slit", "pinhole"]

[render]
size = "64x48"
samples = 2

[[poses]]
path = 4
keys = [{at = [0, 0, 4], look_at = [0.5, 0, 0]}, {at = [1, 0, 3], look_at = [0, 0, 0]}]
"""


CAMERA = """camera slit {
    map u = 1 .. -1, v = square
    eye line((0, 0, 0), (0, 1, 0))
    toward surface(u, v) = [1, u, v]
}
"""


class DatasetCommand(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "slit.cam").write_text(CAMERA)
        self.write()

    def write(self, *changes):
        text = RECIPE
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        (self.folder / "a.toml").write_text(text)

    def contents(self, name):
        return {str(file.relative_to(self.folder / name)): file.read_bytes()
                for file in (self.folder / name).rglob("*") if file.is_file()}

    def test_it_makes_frames_and_says_so(self):
        out, err = self.run_command("dataset", "a.toml", "-o", "set")
        self.assertIn("set: 8 frames, 8 frames rendered in", out)
        self.assertIn("pinhole: 64 x 48 pixels, pinhole", out)
        self.assertIn("slit: 64 x 48 pixels, several viewpoints", out)
        self.assertNotIn("warning", err)
        self.assertEqual(len(self.contents("set")), 17)
        facts = self.json_of("dataset", "a.toml", "-o", "set")
        self.assertEqual((facts["frames"], facts["rendered"], facts["skipped"]), (8, 0, 8))

    def test_a_dry_run_writes_nothing(self):
        facts = self.json_of("dataset", "a.toml", "-o", "set", "--dry-run", "--shard", "1/3")
        self.assertEqual((facts["frames"], facts["selected"], facts["rendered"]), (8, 3, 0))
        self.assertFalse((self.folder / "set").exists())

    def test_shards_make_the_whole(self):
        self.run_command("dataset", "a.toml", "-o", "whole", "-q")
        for shard in ("2/3", "1/3", "3/3"):
            self.run_command("dataset", "a.toml", "-o", "parts", "-q", "--shard", shard,
                             "--threads", shard[0])
        self.assertEqual(self.contents("whole"), self.contents("parts"))

    def test_it_continues_after_it_was_killed(self):
        self.write(("samples = 2", "samples = 64"), ("path = 4", "path = 12"))
        self.run_command("dataset", "a.toml", "-o", "whole", "-q")
        process = self.start("dataset", "a.toml", "-o", "set", "-q")
        depth = self.folder / "set/scene/depth"
        while not depth.exists() or len(list(depth.glob("*.npy"))) < 3:
            self.assertIsNone(process.poll())
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.communicate(timeout=120)
        # Each file is whole or not there under its name.
        whole = self.contents("whole")
        killed = {name: data for name, data in self.contents("set").items() if name in whole}
        self.assertLess(len(killed), len(whole))
        for name, data in killed.items():
            self.assertEqual(data, whole[name], name)
        finished = sum(f"scene/rgb/{file.stem}.png" in killed for file in depth.glob("*.npy"))
        facts = self.json_of("dataset", "a.toml", "-o", "set")
        self.assertEqual(facts["skipped"], finished)
        self.assertGreaterEqual(finished, 3)
        self.assertEqual(self.contents("set"), whole)

    def test_an_interruption_keeps_the_frames(self):
        self.write(("samples = 2", "samples = 256"), ("path = 4", "path = 40"))
        process = self.start("dataset", "a.toml", "-o", "set")
        depth = self.folder / "set/scene/depth"
        while not depth.exists() or len(list(depth.glob("*.npy"))) < 2:
            self.assertIsNone(process.poll())
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130, err)
        self.assertIn(b"interrupted: ", out + err)

    def test_frames_that_say_the_same_say_it_once(self):
        self.write(("look_at = [0.5, 0, 0]", "look_at = [0, 0.1, 9]"),
                   ("look_at = [0, 0, 0]", "look_at = [0.1, 0, 9]"))
        diagnostics = self.json_of("dataset", "a.toml", "-o", "set")["diagnostics"]
        self.assertEqual(len(diagnostics), 2, diagnostics)
        for said, name in zip(diagnostics, ("slit", "pinhole")):
            self.assertTrue(said["message"].startswith(f"frame '{name}-00000': no ray of "))
            self.assertTrue(said["message"].endswith(" (and 3 frames more)"))

    def test_another_recipe_is_refused(self):
        self.run_command("dataset", "a.toml", "-o", "set", "-q")
        self.write(("samples = 2", "samples = 3"))
        self.refused("dataset", "a.toml", "-o", "set", code=2,
                     says='facts/render/samples: "2" there, "3" now', helps="--overwrite")
        facts = self.json_of("dataset", "a.toml", "-o", "set", "--overwrite")
        self.assertEqual((facts["rendered"], facts["skipped"]), (8, 0))
        facts = self.json_of("dataset", "a.toml", "-o", "set")
        self.assertEqual((facts["rendered"], facts["skipped"]), (0, 8))
        with open(self.folder / "scene.obj", "a", encoding="utf-8") as scene:
            scene.write("# changed\n")
        self.refused("dataset", "a.toml", "-o", "set", code=2, says="another recipe (facts/files")

    def test_mistakes_have_a_place(self):
        for change, says, helps in (
                (("path = 4", "path = 4\nclosd = true"), "a.toml:12:1", "did you mean 'closed'"),
                (("size =", "sise ="), "a.toml:7:1", "did you mean 'size'"),
                (("scene.obj", "none.obj"), "none.obj", ""),
                (("slit.cam:slit", "slit.cam:slip"), "a.toml:4:12", "did you mean 'slit'"),
                (("\"pinhole\"", "\"pinhle\""), "pinhle", "did you mean 'pinhole'"),
                (("[[poses]]", "[[poses]"), "a.toml:10:", ""),
                (("look_at = [0.5, 0, 0]", "look_at = [0, 0]"), "a.toml:12:", "[x, y, z]")):
            with self.subTest(change):
                self.write(change)
                self.refused("dataset", "a.toml", "-o", "set", code=1, says=says, helps=helps)
                self.assertFalse((self.folder / "set").exists())
        self.refused("dataset", "b.toml", "-o", "set", code=1, says="b.toml")

    def test_files_that_cannot_be_written_are_errors(self):
        (self.folder / "set").write_text("a file")
        self.refused("dataset", "a.toml", "-o", "set", code=3, says="the folder 'set")
        (self.folder / "set").unlink()
        os.mkdir(self.folder / "set")
        (self.folder / "set/manifest.json").write_text("{}")
        self.refused("dataset", "a.toml", "-o", "set", code=2, says="is no manifest")

    def test_a_full_disk_is_an_error(self):
        self.run_command("dataset", "a.toml", "-o", "set", "-q")
        manifest = json.loads((self.folder / "set/manifest.json").read_text())
        (self.folder / "set" / manifest["frames"][1]["files"]["depth"]).unlink()

        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

        out, err = self.run_command("dataset", "a.toml", "-o", "set", code=3, preexec_fn=limit)
        self.assertIn("error: ", err)
        facts = self.json_of("dataset", "a.toml", "-o", "set")
        self.assertEqual((facts["rendered"], facts["skipped"]), (1, 7))


if __name__ == "__main__":
    support.main()
