# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony studio: pictures in full quality."""

import shlex

import support
from studio_case import CAMERA, SMALL, StudioTest


class Render(StudioTest):
    # It is what the command renders of the text as it is, which no file has.
    def test_a_picture(self):
        self.open("--exposure", "0")
        page, other = self.shown(), self.page().begin()
        text = CAMERA.replace("size = 3", "size = 2")
        page.edit(text)
        change = page.result("view/change", values=[{"parameter": "height", "value": 7}])["change"]
        page.wait_for("view/camera", change=change)
        begun = page.result("render/start", width=40, height=30, samples=3, output="png")
        # What comes later is not in it.
        page.result("view/change", values=[{"parameter": "height", "value": 1}])
        self.assertEqual(begun["file"], "my.png")
        done = page.wait_for("render/done", id=begun["id"])
        self.assertEqual((done["file"], done["stopped"], done["samples"]), ("my.png", False, 3))
        self.assertFalse([one for one in done["diagnostics"] if one["severity"] == 1])
        other.wait_for("render/done", id=begun["id"])
        (self.folder / "same.cam").write_text(text)
        self.run_command("render", "scene.obj", "--camera", "same.cam", "--set", "height=7",
                         "--size", "40x30", "--samples", "3", "--exposure", "0", "-o", "same.png")
        self.assertEqual((self.folder / "my.png").read_bytes(),
                         (self.folder / "same.png").read_bytes())
        self.assertEqual((self.folder / "my.cam").read_text(), CAMERA)
        # No picture is replaced.
        again = page.result("render/start", width=40, height=30, samples=1, output="png")
        third = page.result("render/start", width=40, height=30, samples=1, output="exr")
        self.assertEqual((again["file"], third["file"]), ("my-2.png", "my.exr"))
        page.wait_for("render/done", id=again["id"])
        page.wait_for("render/done", id=third["id"], file="my.exr")
        self.assertTrue({"my-2.png", "my.exr"} <= set(self.files()))

    def test_progress_and_stop(self):
        self.open()
        page = self.shown()
        begun = page.result("render/start", width=320, height=240, samples=100_000)
        waiting = page.result("render/start", width=32, height=24, samples=100_000)
        told = page.wait_for("render/progress", id=begun["id"])
        self.assertTrue(0 < told["done"] < 1)
        self.assertGreater(told["seconds"], 0)
        for one in (waiting, begun):
            page.result("render/stop", id=one["id"])
        done = page.wait_for("render/done", id=begun["id"])
        self.assertEqual((done["file"], done["stopped"]), ("my.png", True))
        done = page.wait_for("render/done", id=waiting["id"])
        self.assertTrue(done["stopped"])
        self.assertIn("it may have ended", page.error("render/stop", id=begun["id"])["message"])

    def test_the_end_of_the_studio_ends_it(self):
        self.open()
        page = self.shown()
        begun = page.result("render/start", width=320, height=240, samples=1_000_000)
        page.wait_for("render/progress", id=begun["id"])
        self.process.terminate()
        self.process.wait(60)

    def test_what_cannot_be_rendered(self):
        self.open()
        page = self.shown()
        good = {"width": 4, "height": 3, "samples": 1, "output": "png"}
        for wrong in ({"width": 0}, {"width": 1_000_001}, {"height": -1}, {"height": 1.5},
                      {"samples": 0}, {"samples": 1e9}, {"output": "jpg"}, {"output": "../a.png"},
                      {"output": 7}, {"denoise": "yes"}):
            self.assertEqual(page.error("render/start", **{**good, **wrong})["code"], -32602, wrong)
        self.assertEqual(page.error("render/start")["code"], -32602)
        self.assertEqual(page.error("render/stop")["code"], -32602)
        for number in (0, 77, -1, "one", 10**18):
            self.assertEqual(page.error("render/stop", id=number)["code"], -32803)
        self.assertEqual(self.files(), ["my.cam", "room.glb", "scene.obj"])

    # What the line renders is what the studio renders.
    def test_the_command_line(self):
        (self.folder / "my cam's.cam").write_text(CAMERA.replace("above(", "above(turn = 0deg, "))
        self.open("--exposure", "0", "--background", "0.1,0.2,0.3", "--no-dither",
                  camera="my cam's.cam:above")
        page = self.shown(values=[{"parameter": "height", "value": 7},
                                  {"parameter": "turn", "value": 0.5}])
        line = page.result("command")["line"]
        words = shlex.split(line)
        self.assertEqual(words[:5], ["balcony", "render", "scene.obj", "--camera",
                                     "my cam's.cam:above"])
        self.assertIn("turn=28.64788975654116deg", words)
        begun = page.result("render/start", width=SMALL[0], height=SMALL[1])
        self.assertEqual(begun["file"], "my cam's.png")
        page.wait_for("render/done", id=begun["id"])
        rendered = (self.folder / "my cam's.png").read_bytes()
        (self.folder / "my cam's.png").unlink()
        self.run_command(*words[1:])
        self.assertEqual((self.folder / "my cam's.png").read_bytes(), rendered)

    def test_read_only(self):
        self.open("--read-only")
        page = self.shown()
        self.assertIn("--read-only", page.error("render/start", width=4, height=3)["message"])


if __name__ == "__main__":
    support.main()
