# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony draw: pictures and scenes of cameras, and errors."""

import json
import shutil
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree as ElementTree

import support

SVG = "{http://www.w3.org/2000/svg}"


class Draw(support.CommandTest):
    def parts(self, file):
        """How many paths of each class an SVG file has."""
        root = ElementTree.parse(self.folder / file).getroot()
        counts = {}
        for path in root.iter(f"{SVG}path"):
            counts[path.get("class")] = counts.get(path.get("class"), 0) + 1
        return counts

    def test_svg(self):
        out, err = self.run_command("draw", "pinhole", "-o", "pinhole.svg", "--size", "400x300")
        self.assertEqual((out, err), ("pinhole.svg: drawn\n", ""))
        root = ElementTree.parse(self.folder / "pinhole.svg").getroot()
        self.assertEqual((root.get("width"), root.get("height")), ("400", "300"))
        self.assertEqual(root.find(f"{SVG}title").text, "pinhole")
        self.assertEqual(set(self.parts("pinhole.svg")),
                         {"eye", "toward", "frame", "ray", "axis"})

    def test_parts_can_be_left_out(self):
        self.run_command("draw", "pinhole", "-o", "bare.svg", "--no-toward", "--no-frame",
                         "--no-axes", "--rays", "0", "-q")
        self.assertEqual(self.parts("bare.svg"), {"eye": 1})
        self.assertIn('d="M480 360h0"', (self.folder / "bare.svg").read_text())

    def test_color_of_arrows(self):
        self.run_command("draw", "pinhole", "-o", "grey.svg", "--color", "0.2140", "-q")
        root = ElementTree.parse(self.folder / "grey.svg").getroot()
        arrows = {path.get("stroke") for path in root.iter(f"{SVG}path")
                  if path.get("class") == "ray" and path.get("stroke") not in (None, "none")}
        self.assertEqual(arrows, {"#7f7f7f"})

    def test_png(self):
        self.run_command("draw", "superelliptic", "-o", "s.png", "--size", "64x48", "--set",
                         "gamma=1/2")
        data = (self.folder / "s.png").read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(data[16:24], b"\0\0\0\x40\0\0\0\x30")

    def test_glb_renders(self):
        self.run_command("draw", "superelliptic", "-o", "s.glb")
        scene = self.json_of("info", "s.glb")["scene"]
        self.assertEqual([each["name"] for each in scene["objects"]]
                         if isinstance(scene["objects"][0], dict) else scene["objects"],
                         ["surface", "rays", "frame"])
        self.run_command("render", "s.glb", "-o", "s.png", "--size", "32x24", "-s", "1")
        self.assertGreater(support.opaque_share(self.folder / "s.png"), 0.02)

    def test_pictures(self):
        (self.folder / "two.cam").write_text(
            'import "my.cam"\n'
            "picture inner { layer above(size = 1) layer nowhere }\n"
            "picture two { layer closeup layer above(size = 1) layer inner }\n")
        _, err = self.run_command("draw", "two.cam", "-o", "two.svg", "-q")
        # What cannot be drawn is said, and the rest is drawn: once for the same parameters.
        self.assertIn("warning: camera 'nowhere' has no valid point", err)
        parts = self.parts("two.svg")
        self.assertEqual({name for name in parts if name.startswith("ray")},
                         {"ray camera-1", "ray camera-2"})
        self.assertEqual(parts["ray camera-1"], parts["ray camera-2"])
        root = ElementTree.parse(self.folder / "two.svg").getroot()
        texts = [(text.text, text.get("fill")) for text in root.iter(f"{SVG}text")]
        self.assertEqual([text for text, _ in texts], ["layers 2, 3.1, above", "layer 1, closeup"])
        self.assertEqual(len({color for _, color in texts}), 2)
        self.run_command("draw", "two.cam", "-o", "two.glb", "-q")
        objects = self.json_of("info", "two.glb")["scene"]["objects"]
        names = [one["name"] if isinstance(one, dict) else one for one in objects]
        self.assertIn("layer 1, closeup: rays", names)
        self.assertIn("layers 2, 3.1, above: surface", names)
        # A camera by itself has no labels.
        self.run_command("draw", "my.cam:above", "-o", "one.svg", "-q")
        self.assertNotIn("<text", (self.folder / "one.svg").read_text())

    def test_time_and_view_matter(self):
        (self.folder / "t.cam").write_text(
            "camera c { map u = 1 .. -1, v = square eye surface(u, v) = [t*v^2, u, v] }")
        texts = []
        for words in ((), ("--time", "1"), ("--view", "10,20"), ("--length", "3")):
            self.run_command("draw", "t.cam", "-o", "t.svg", *words)
            texts.append((self.folder / "t.svg").read_text())
        self.assertEqual(len(set(texts)), len(texts))

    def test_drawings_of_a_film_have_one_frame(self):
        (self.folder / "fly.cam").write_text(
            "camera c { map u = 1 .. -1, v = square eye sphere(1) move translate(9*t, 0, 0) }")

        def axes(*words):
            self.run_command("draw", "fly.cam", "-o", "fly.svg", *words)
            root = ElementTree.parse(self.folder / "fly.svg").getroot()
            return [path.get("d") for path in root.iter(f"{SVG}path")
                    if path.get("class") == "axis"]

        self.assertEqual(axes("--time", "0.3", "--during", "0,1"),
                         axes("--time", "1", "--during", "0,1"))
        self.assertNotEqual(axes("--time", "0"), axes("--time", "1"))

    def test_a_film_has_a_drawing_for_each_frame(self):
        (self.folder / "fly.cam").write_text(
            "camera c { map u = 1 .. -1, v = square eye sphere(1) move translate(9*t, 0, 0) }")
        words = ("draw", "fly.cam", "--size", "96x72", "--rays", "0")
        out, _ = self.run_command(*words, "--frames", "3-7x2", "--time", "1", "--fps", "4",
                                  "-o", "f.##.svg")
        self.assertIn("f.##.svg: frames 3,5,7 drawn", out)
        self.assertEqual([name for name in self.files() if name.startswith("f.")],
                         ["f.03.svg", "f.05.svg", "f.07.svg"])
        # Frame 1 is at --time, so frame 5 is at 1 + 4/4.
        self.run_command(*words, "--time", "2", "--during", "1.5,2.5", "-o", "one.svg")
        self.assertEqual((self.folder / "one.svg").read_bytes(),
                         (self.folder / "f.05.svg").read_bytes())
        self.run_command(*words, "--frames", "1-3", "--during", "0,9", "-o", "g.#.svg")
        self.run_command(*words, "--time", "0", "--during", "0,9", "-o", "one.svg")
        self.assertEqual((self.folder / "one.svg").read_bytes(),
                         (self.folder / "g.1.svg").read_bytes())
        self.refused(*words, "--frames", "3", "-o", "f.svg", code=2, says="'f.svg' has no #")
        self.refused(*words, "-o", "f.mp4", code=2, says="nothing tells how many frames",
                     helps="--frames 48")
        (self.folder / "c.1.svg").write_bytes((self.folder / "fly.cam").read_bytes())
        self.refused("draw", "c.1.svg:c", "--frames", "1", "-o", "c.#.svg", code=2,
                     says="'c.1.svg' is read here and would be overwritten")

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_a_film_of_drawings(self):
        words = ("draw", "walkthrough", "--size", "96x72", "-o", "film.gif")
        self.run_command(*words, "--frames", "4", "--fps", "10")
        self.assertNotIn("film.gif.frames", self.files())
        probed = subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of", "json", "film.gif"],
            cwd=self.folder, capture_output=True, check=True)
        stream = json.loads(probed.stdout)["streams"][0]
        self.assertEqual((stream["width"], stream["height"], stream["nb_read_frames"],
                          stream["r_frame_rate"]), (96, 72, "4", "10/1"))
        # A film that animate has begun is not touched.
        frames = self.folder / "film.gif.frames"
        frames.mkdir()
        (frames / "frame.#####.png.animation").write_text("{}")
        self.refused(*words, "--frames", "4", code=1, says="an animation that is not finished")
        self.assertTrue((frames / "frame.#####.png.animation").exists())

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_a_stopped_film_leaves_nothing(self):
        (self.folder / "hang.cam").write_text(
            "camera c { map u = -1e9 .. 1e9, v = -0.5 .. 0.5 eye sphere(1) look normal }")
        process = self.start("draw", "hang.cam", "-o", "c.mp4", "--size", "4096x4096",
                             "--frames", "99")
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertEqual([name for name in self.files() if name.startswith("c.")], [])

    def test_poster(self):
        self.run_command("draw", "pinhole", "--explain", "-o", "class.svg")
        root = ElementTree.parse(self.folder / "class.svg").getroot()
        texts = [text.text or "" for text in root.iter(f"{SVG}text")]
        for line in ("pinhole: Rays start at a point;", "    let half_width = tan(fov/2)",
                     "direction_x = "):
            self.assertTrue(any(text.startswith(line) for text in texts), line)
        self.assertEqual(root.get("width"), "1920")
        self.refused("draw", "nothing", "--explain", "-o", "p.svg", code=1, says="'nothing'")

    def test_json(self):
        self.assertEqual(self.json_of("draw", "pinhole", "-o", "p.svg")["output"], "p.svg")
        self.assertIsNone(self.json_of("draw", "nothing", "-o", "p.svg", code=1)["output"])

    def test_what_cannot_be_drawn_whole_is_said(self):
        (self.folder / "hang.cam").write_text(
            "camera c { map u = -1e9 .. 1e9, v = -0.5 .. 0.5 eye sphere(1) look normal }")
        (self.folder / "far.cam").write_text(
            "camera c { map u = 1 .. -1, v = -1e308 .. 1 eye circle(2)"
            " toward surface(u, v) = [1, 0, v] }")
        for camera, says in (("hang.cam", "turn or jump too often"), ("far.cam", "are farther")):
            for output in ("c.svg", "c.png", "c.glb"):
                _, err = self.run_command("draw", camera, "-o", output, "-q")
                self.assertIn(says, err)
                self.assertNotIn("error", err)
            self.assertNotRegex((self.folder / "c.svg").read_text(), "nan|inf")
            self.assertLess((self.folder / "c.glb").stat().st_size, 100e6)
        # Once for all frames of a film.
        _, err = self.run_command("draw", "hang.cam", "--frames", "1-2", "-o", "c.#.svg", "-q")
        self.assertEqual(err.count("turn or jump too often"), 1)

    def test_obeys_a_signal(self):
        (self.folder / "hang.cam").write_text(
            "camera c { map u = -1e9 .. 1e9, v = -0.5 .. 0.5 eye sphere(1) look normal }")
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start("draw", "hang.cam", "-o", "c.png", "--size", "16384x16384")
            time.sleep(0.5)
            process.send_signal(number)
            process.communicate(timeout=60)
            self.assertEqual(process.returncode, 130)
        self.assertNotIn("c.png", self.files())

    def test_refusals(self):
        before = self.files()
        for words, code, says in (
                (("pinhole", "-o", "p.bmp"), 2, "is not a drawing format"),
                (("pinhole", "-o", "no/p.svg"), 3, "there is no folder"),
                (("pinhole", "-o", "p.svg", "--rays", "many"), 2, "--rays cannot be 'many'"),
                (("pinhole", "-o", "p.svg", "--view", "90"), 2, "--view cannot be '90'"),
                (("pinhole", "-o", "p.svg", "--size", "5x5"), 2, "a drawing cannot have 5 x 5 pixels"),
                (("pinhole", "-o", "p.svg", "--length", "0"), 2, "--length cannot be '0'"),
                (("pinhole", "-o", "p.svg", "--during", "3"), 2, "--during cannot be '3'"),
                (("pinhole", "-o", "p.svg", "--color", "2"), 2, "--color cannot be '2'"),
                (("my.cam:nowhere", "-o", "p.svg"), 1, "no valid point"),
                (("pinhole", "-o", "p.svg", "--set", "fov"), 1, "--set fov sets nothing"),
                (("pinhole",), 2, "")):
            with self.subTest(words=words):
                self.refused("draw", *words, code=code, says=says)
        self.assertEqual(self.files(), before)


if __name__ == "__main__":
    support.main()
