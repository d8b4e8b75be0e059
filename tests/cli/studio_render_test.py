# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony studio: pictures and films in full quality."""

import os
import shlex
import unittest

import support
from animate_test import has_ffmpeg, moving_triangle
from studio_case import CAMERA, SMALL, StudioTest

STRAIGHT = """camera straight {
    axes y_up
    map  u = -0.5 .. 0.5, v = square
    eye  point(0, 0, 2)
    toward surface(u, v) = [u, v, 1]
}
"""


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

    @unittest.skipUnless(has_ffmpeg, "ffmpeg is not installed")
    def test_a_film(self):
        (self.folder / "moving.gltf").write_text(moving_triangle())
        self.open("--exposure", "0", "--fps", "4", scene="moving.gltf")
        page = self.shown()
        text = CAMERA.replace("[u, v, height]", "[u + t, v, height]")
        page.edit(text)
        # The time that is shown is not that of the film.
        change = page.result("view/change", time=0.5,
                             values=[{"parameter": "height", "value": 7}])["change"]
        page.wait_for("view/camera", change=change)
        begun = page.result("render/start", width=40, height=30, samples=3, frames=3, output="gif")
        self.assertEqual(begun["file"], "my.gif")
        again = page.result("render/start", width=40, height=30, samples=1, frames=2, output="gif",
                            turntable=True)
        self.assertEqual(again["file"], "my-2.gif")
        told = [page.wait_for("render/done", id=one["id"]) for one in (begun, again)]
        self.assertEqual([(one["file"], one["stopped"]) for one in told],
                         [("my.gif", False), ("my-2.gif", False)])
        (self.folder / "same.cam").write_text(text)
        for name, words in (("same", ("--samples", "3", "--frames", "3", "--set", "height=7")),
                            ("round", ("--samples", "1", "--frames", "2", "--set", "height=7",
                                       "--turntable"))):
            self.run_command("animate", "moving.gltf", "--camera", "same.cam", "--size", "40x30",
                             "--exposure", "0", "--fps", "4", *words, "-o", f"{name}.gif")
        for made, same in (("my.gif", "same.gif"), ("my-2.gif", "round.gif")):
            self.assertEqual((self.folder / made).read_bytes(), (self.folder / same).read_bytes())
        self.assertFalse([name for name in self.files() if "frames" in name])

    @unittest.skipUnless(has_ffmpeg, "ffmpeg is not installed")
    def test_a_stopped_film_has_the_frames_so_far(self):
        self.open()
        page = self.shown()
        begun = page.result("render/start", width=40, height=30, samples=1, frames=100_000,
                            output="gif")
        waiting = page.result("render/start", width=40, height=30, samples=1, frames=100_000,
                              output="gif")
        while not any(one["method"] == "render/progress" and one["params"]["done"] > 3 / 100_000
                      for one in page.told):
            page.next()
        for one in (begun, waiting):
            page.result("render/stop", id=one["id"])
        done = page.wait_for("render/done", id=begun["id"])
        self.assertEqual((done["file"], done["stopped"]), ("my.gif", True))
        self.assertGreater((self.folder / "my.gif").stat().st_size, 0)
        # One that had not begun leaves nothing.
        done = page.wait_for("render/done", id=waiting["id"])
        self.assertEqual((done["file"], done["stopped"]), (None, True))
        self.assertFalse([name for name in self.files() if "frames" in name or "-2" in name])

    @unittest.skipUnless(has_ffmpeg, "ffmpeg is not installed")
    def test_the_end_of_the_studio_leaves_no_empty_folders(self):
        self.open()
        page = self.shown()
        for output in ("gif", "mp4"):
            page.result("render/start", width=40, height=30, samples=1, frames=100_000,
                        output=output)
        page.wait_for("render/progress")
        self.process.terminate()
        self.process.wait(60)
        self.assertFalse([name for name in self.files() if "frames" in name or ".mp4" in name])

    def test_films_that_cannot_be(self):
        self.open(env=dict(os.environ, PATH="/nowhere"))
        page = self.shown()
        good = {"width": 4, "height": 2, "samples": 1, "output": "mp4", "frames": 2}
        self.assertIn(".mp4", page.about["films"])
        for wrong in ({"frames": 0}, {"frames": 1.5}, {"frames": 10**9}, {"turntable": "yes"},
                      {"output": "avi"}):
            self.assertEqual(page.error("render/start", **{**good, **wrong})["code"], -32602, wrong)
        del good["frames"]
        self.assertEqual(page.error("render/start", **good)["code"], -32602)
        refused = page.error("render/start", **good, frames=2)
        self.assertEqual(refused["code"], -32803)
        self.assertIn("needs the program ffmpeg", refused["message"])
        self.assertEqual(self.files(), ["my.cam", "room.glb", "scene.obj"])

    # What is rendered is what the command renders.
    def test_stereo(self):
        (self.folder / "my.cam").write_text(STRAIGHT)
        self.open("--exposure", "0", "--stereo", "side_by_side", "--separation", "0.5",
                  scene="room.glb")
        page = self.page().begin()
        self.assertIn("anaglyph", [one["name"] for one in page.about["stereoFormats"]])
        page.result("view/change", size=SMALL)
        self.assertEqual(page.wait_for("view/camera")["stereo"], "side_by_side")
        page.wait_for("view/rest")
        layers = [page.result("view/at", x=x, y=24)["ray"]["layer"] for x in (16, 48)]
        self.assertEqual(layers, ["left", "right"])
        told = page.result("view/drag", pulls=[{"point": [0, 0, -1], "from": [16, 24],
                                                "to": [18, 24]}])
        dragged = page.wait_for("view/dragged", change=told["change"])
        self.assertIn("the picture of one eye", dragged["diagnostics"][0]["message"])
        page.result("view/drag", pulls=[])
        for format_, words in (("anaglyph", ["--stereo", "anaglyph", "--separation", "0.5"]),
                               (None, [])):
            change = page.result("view/change", stereo=format_)["change"]
            told = page.wait_for("view/camera", change=change)
            self.assertEqual(told.get("stereo"), format_)
            page.wait_for("view/rest", change=change)
            line = shlex.split(page.result("command")["line"])
            for word in ("--stereo", "--separation"):
                self.assertEqual(line.count(word), words.count(word))
            begun = page.result("render/start", width=40, height=30, samples=2)
            file = page.wait_for("render/done", id=begun["id"])["file"]
            self.run_command("render", "room.glb", "--camera", "my.cam", "--size", "40x30",
                             "--samples", "2", "--exposure", "0", *words, "-o", "same.png")
            self.assertEqual((self.folder / file).read_bytes(),
                             (self.folder / "same.png").read_bytes())
        self.assertEqual(page.error("view/change", stereo="3d")["code"], -32602)
        self.assertEqual(page.error("view/change", stereo=3)["code"], -32602)
        self.refused("studio", "room.glb", "my.cam", "--stereo", "files", code=2,
                     says="one picture, not two files", helps="side_by_side")

    def test_read_only(self):
        self.open("--read-only")
        page = self.shown()
        self.assertIn("--read-only", page.error("render/start", width=4, height=3)["message"])


if __name__ == "__main__":
    support.main()
