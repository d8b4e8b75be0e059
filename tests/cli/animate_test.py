# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Films and sequences: `balcony animate`, and `balcony merge` of its shards.

Usage: animate_test.py BALCONY
"""

import base64
import json
import os
import resource
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import support  # noqa: E402

# Looks at the triangle from a place that moves with t.
CAMERA = """
camera moving {
    axes y_up
    map  u = -2 .. 2, v = square
    eye  surface(u, v) = [u + t, v, 5]
    toward surface(u, v) = [u + t, v, 0]
    look relative
}
"""

FAKE_FFMPEG = """#!/bin/sh
case "$*" in
*-encoders*) echo ' V....D libx264  x' ;;
*) cat > /dev/null; echo 'the encoder is ill' >&2; exit 1 ;;
esac
"""

has_ffmpeg = shutil.which("ffmpeg") and shutil.which("ffprobe")


def moving_triangle(seconds=1.0):
    """The triangle of room.glb, which moves to the right by 1 while these seconds pass."""
    document = support.triangle()
    data = support.CORNERS + struct.pack("<2f", 0, seconds) + struct.pack("<6f", 0, 0, 0, 1, 0, 0)
    document["buffers"] = [{"byteLength": len(data), "uri": "data:application/octet-stream;base64,"
                            + base64.b64encode(data).decode()}]
    at = len(support.CORNERS)
    document["bufferViews"] += [{"buffer": 0, "byteOffset": at, "byteLength": 8},
                                {"buffer": 0, "byteOffset": at + 8, "byteLength": 24}]
    document["accessors"] += [
        {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0],
         "max": [seconds]},
        {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}]
    document["animations"] = [{"samplers": [{"input": 1, "output": 2}],
                               "channels": [{"sampler": 0,
                                             "target": {"node": 0, "path": "translation"}}]}]
    return json.dumps(document)


class AnimationTest(support.CommandTest):
    SMALL = ("--size", "96x70", "--samples", "2", "--ambient", "0.5", "--exposure", "0")

    def setUp(self):
        super().setUp()
        (self.folder / "move.cam").write_text(CAMERA)
        (self.folder / "moving.gltf").write_text(moving_triangle())

    def words(self, *more, scene="room.glb", camera="move.cam"):
        return ("animate", scene, "--camera", camera, *self.SMALL, *more)

    def animate(self, *more, code=0, **how):
        return self.run_command(*self.words(*more), code=code, **how)

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def times(self, *names):
        return [(self.folder / name).stat().st_mtime_ns for name in names]


class Frames(AnimationTest):
    def render(self, frame, output, *more, scene="room.glb", seed=None):
        self.run_command("render", scene, "--camera", "move.cam", *self.SMALL, "--time",
                         repr((frame - 1) / 24), "--seed", str(frame if seed is None else seed),
                         "-o", output, *more)

    def test_are_renders_at_their_times(self):
        for scene in ("room.glb", "moving.gltf"):
            for more in ((), ("--shutter", "1/48")):
                with self.subTest(scene=scene, more=more):
                    ending = "exr" if more else "png"
                    self.run_command(*self.words("--frames", "3-5", "-o", f"f.###.{ending}",
                                                 "--overwrite", *more, scene=scene))
                    for frame in (3, 5):
                        self.render(frame, f"one.{ending}", *more, scene=scene)
                        self.assertEqual(self.bytes_of(f"f.{frame:03}.{ending}"),
                                         self.bytes_of(f"one.{ending}"))
        self.assertNotEqual(self.bytes_of("f.003.png"), self.bytes_of("f.004.png"))

    def test_stereo(self):
        stereo = ("--stereo", "side_by_side", "--separation", "0.5")
        self.animate("--frames", "3", "-o", "f.#.exr", *stereo)
        self.render(3, "one.exr", *stereo)
        self.assertEqual(self.bytes_of("f.3.exr"), self.bytes_of("one.exr"))
        self.refused(*self.words("--frames", "1", "-o", "g.#.exr", "--stereo", "files"), code=2,
                     says="not two", helps="--stereo left")

    def test_layers_of_motion(self):
        self.run_command(*self.words("--frames", "2", "-o", "f.#.exr", "--layers", "motion",
                                     scene="moving.gltf"))
        self.render(2, "one.exr", "--layers", "motion", scene="moving.gltf")
        self.assertEqual(self.bytes_of("f.2.exr"), self.bytes_of("one.exr"))

    def test_shutter_angle(self):
        self.animate("--frames", "4", "-o", "f.#.exr", "--shutter", "180deg")
        self.animate("--frames", "4", "-o", "g.#.exr", "--shutter", "1/48")
        self.assertEqual(self.bytes_of("f.4.exr"), self.bytes_of("g.4.exr"))
        self.refused(*self.words("--frames", "1", "-o", "f.#.exr", "--shutter", "xdeg"), code=2,
                     says="--shutter cannot be 'xdeg'")

    def test_start_time_and_rate(self):
        self.animate("--frames", "1", "-o", "f.#.exr", "--start-time", "0.5")
        self.animate("--frames", "6", "-o", "g.#.exr", "--fps", "10", "--seed", "4294967291")
        self.assertEqual(self.bytes_of("f.1.exr"), self.bytes_of("g.6.exr"))

    def test_noise(self):
        (self.folder / "still.cam").write_text(CAMERA.replace("u + t", "u"))
        light = ("--shutter", "0.1", "--samples", "1", "--filter", "gaussian")
        self.run_command(*self.words("--frames", "1-2", "-o", "f.#.exr", "--same-noise", *light,
                                     scene="moving.gltf", camera="still.cam"))
        self.run_command("render", "moving.gltf", "--camera", "still.cam", *self.SMALL, *light,
                         "--time", repr(1 / 24), "-o", "one.exr")
        self.assertEqual(self.bytes_of("f.2.exr"), self.bytes_of("one.exr"))

    def test_as_many_as_the_scene_needs(self):
        facts = self.json_of(*self.words("--fps", "4", "-o", "f.#.exr", scene="moving.gltf"))
        self.assertEqual(facts["frames"], "1-5")
        self.refused(*self.words("-o", "g.#.exr"), code=2, says="nothing tells how many frames",
                     helps="--frames 1-240")

    def test_names(self):
        for written, made in (("a.####.exr", "a.0007.exr"), ("b%03d.exr", "b007.exr"),
                              ("c#.exr", "c7.exr"), ("%d.exr", "7.exr")):
            self.animate("--frames", "7", "-o", written)
            self.assertTrue((self.folder / made).exists(), written)
        for wrong in ("frame.png", "frame", "#/frame.png", "a%s.png", "a%x.png"):
            self.refused(*self.words("--frames", "7", "-o", wrong), code=2,
                         says="has no # for the number of the frame", helps=".####.png'")
        out, err = self.animate("--frames", "99-100", "-o", "w.##.exr")
        self.assertIn("frame 100 has more digits than 'w.##.exr'", err)
        self.assertTrue((self.folder / "w.100.exr").exists())

    def test_numbers(self):
        for text, numbers in (("2", [2]), ("0-2", [0, 1, 2]), ("1-7x3", [1, 4, 7]),
                              ("5,1-2,2", [1, 2, 5])):
            facts = self.json_of(*self.words("--frames", text, "-o", "n.#.exr", "--overwrite"))
            self.assertEqual([one["frame"] for one in facts["pictures"]], numbers)
        for text in ("", "x", "3-1", "1-", "-3", "1-9x0", "1--2", "1,", "1.5", "99999999", "+1"):
            self.refused("animate", "room.glb", f"--frames={text or ' '}", "-o", "n.#.exr", code=2,
                         says="--frames cannot be")

    def test_one_number_is_the_length_of_a_film(self):
        if has_ffmpeg:
            facts = self.json_of(*self.words("--frames", "3", "-o", "n.gif"))
            self.assertEqual(facts["frames"], "1-3")
        out, _ = self.animate("--frames", "3", "-o", "n.#.png")
        self.assertIn("n.#.png: frames 3 of", out)
        self.assertIn("that frame alone; --frames 1-3 renders the first 3", out)

    def test_wrong_usage(self):
        self.refused(*self.words("--frames", "1", "-o", "no/f.#.png"), code=3, says="no folder")
        err = self.refused(*self.words("--frames", "1", "-o", "no/f.mp4"), code=3,
                           says="no folder 'no'")
        self.assertEqual(err.count("error: "), 1)
        self.refused(*self.words("--frames", "1", "-o", "f.#.png", "--crf", "18"), code=2,
                     says="--crf is for films")
        self.refused(*self.words("--frames", "1", "-o", "f.#.png", "--fps", "0"), code=2,
                     says="--fps cannot be '0'")
        self.refused("animate", "room.glb", code=2, says="--output")
        (self.folder / "f.1.glb").write_bytes(support.glb_bytes())
        self.refused("animate", "f.1.glb", "--frames", "1", "-o", "f.#.glb", code=2, says="f.1.glb")

    def test_exposure_is_that_of_frame_1(self):
        (self.folder / "fade.cam").write_text(CAMERA.replace("5]", "5 - 100*t]"))
        words = ("animate", "room.glb", "--camera", "fade.cam", "--size", "32x20", "--samples", "1",
                 "--ambient", "100", "--integrator", "direct")
        first = self.json_of(*words, "--frames", "1-3", "-o", "a.#.png")
        last = self.json_of(*words, "--frames", "3", "-o", "b.#.png")
        self.assertLess(first["exposure"], -3.0)
        self.assertEqual(first["exposure"], last["exposure"])
        self.assertEqual(self.bytes_of("a.3.png"), self.bytes_of("b.3.png"))


class Resuming(AnimationTest):
    def test_only_what_is_missing_is_rendered(self):
        self.animate("--frames", "1-4", "-o", "f.#.exr")
        whole = self.bytes_of("f.3.exr")
        before = self.times("f.1.exr", "f.2.exr", "f.4.exr")
        (self.folder / "f.3.exr").unlink()
        facts = self.json_of(*self.words("--frames", "1-5", "-o", "f.#.exr"))
        self.assertEqual([one["frame"] for one in facts["pictures"]], [3, 5])
        self.assertEqual(facts["skipped"], 3)
        self.assertEqual(self.bytes_of("f.3.exr"), whole)
        self.assertEqual(self.times("f.1.exr", "f.2.exr", "f.4.exr"), before)
        (self.folder / "f.2.exr").write_bytes(b"")
        self.assertEqual(self.json_of(*self.words("--frames", "1-5", "-o", "f.#.exr"))["rendered"],
                         1)

    def test_other_settings_are_refused_or_replace_all(self):
        self.animate("--frames", "1-3", "-o", "f.#.png")
        for more, says in ((("--samples", "3"), "--samples was '2' and is '3'"),
                           (("--size", "40x30"), "the size was '96x70' and is '40x30'"),
                           (("--exposure", "1"), "--exposure was '0' and is '1'"),
                           (("--fps", "25"), "--fps was '24' and is '25'")):
            self.refused(*self.words("--frames", "1-3", "-o", "f.#.png", *more), code=1, says=says,
                         helps="--overwrite")
        self.animate("--frames", "2", "-o", "f.#.png", "--samples", "3", "--overwrite")
        self.assertEqual([one["frame"] for one in self.json_of(*self.words(
            "--frames", "1-3", "-o", "f.#.png", "--samples", "3"))["pictures"]], [1, 3])
        (self.folder / "move.cam").write_text(CAMERA + "// Changed.\n")
        self.refused(*self.words("--frames", "1-3", "-o", "f.#.png", "--samples", "3"), code=1,
                     says="the file 'move.cam' has changed")

    def test_turns_of_other_lengths_differ(self):
        self.animate("--frames", "1-2", "-o", "f.#.exr", "--turntable")
        self.refused(*self.words("--frames", "1-3", "-o", "f.#.exr", "--turntable"), code=1,
                     says="--frames was '1-2' and is '1-3'")

    def test_pictures_of_somebody_else(self):
        (self.folder / "f.2.exr").write_bytes(b"mine")
        self.refused(*self.words("--frames", "1-3", "-o", "f.#.exr"), code=1,
                     says="'f.2.exr' is there already", helps="--overwrite")
        self.assertEqual(self.bytes_of("f.2.exr"), b"mine")
        self.animate("--frames", "3", "-o", "f.#.exr")
        (self.folder / "f.#.exr.animation").write_text("{")
        self.refused(*self.words("--frames", "3", "-o", "f.#.exr"), code=1,
                     says="'f.#.exr.animation' is damaged", helps="--overwrite")

    def interrupted(self, kill, code):
        words = self.words("--frames", "1-6", "-o", "f.#.exr", "--samples", "150",
                           "--checkpoint-every", "0.05")
        with self.start(*words) as process:
            while process.poll() is None and not (self.folder / "f.2.exr").exists():
                time.sleep(0.005)
            process.send_signal(kill)
            out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, code, err)
        self.assertFalse((self.folder / "f.6.exr").exists(), "it was too fast")
        # Of a process that was killed behind its frame.
        (self.folder / "f.1.exr.checkpoint").touch()
        self.run_command(*words)
        self.run_command(*self.words("--frames", "1-6", "-o", "w.#.exr", "--samples", "150"))
        for frame in range(1, 7):
            self.assertEqual(self.bytes_of(f"f.{frame}.exr"), self.bytes_of(f"w.{frame}.exr"))
        self.assertEqual([name for name in self.files() if "checkpoint" in name], [])
        return out.decode()

    def test_after_ctrl_c(self):
        said = self.interrupted(signal.SIGINT, 130)
        self.assertIn("the same command continues", said)

    def test_after_kill(self):
        self.interrupted(signal.SIGKILL, -signal.SIGKILL)

    def test_after_a_full_disk(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))

        words = self.words("--frames", "1-2", "-o", "f.#.exr")
        out, err = self.run_command(*words, code=3, preexec_fn=limit)
        self.assertIn("give the same command again", err)
        self.assertFalse((self.folder / "f.1.exr").exists())
        self.run_command(*words)
        self.assertTrue((self.folder / "f.2.exr").exists())


class Turntable(AnimationTest):
    def test_begins_at_the_camera_and_does_not_repeat_it(self):
        (self.folder / "still.cam").write_text(CAMERA.replace("u + t", "u"))
        bare = ("--background", "transparent")
        turn = self.words("--turntable", "--same-noise", *bare, camera="still.cam")
        self.run_command(*turn, "--frames", "1-4", "-o", "t.#.png")
        self.run_command("render", "room.glb", "--camera", "still.cam", *self.SMALL, *bare, "-o",
                         "one.png")
        self.assertEqual(self.bytes_of("t.1.png"), self.bytes_of("one.png"))
        # From behind, the triangle is the same but for the order of its pixels in a row.
        front = support.png_pixels(self.folder / "t.1.png")[2]
        behind = support.png_pixels(self.folder / "t.3.png")[2]
        covered = [[[pixel[3] > 127 for pixel in row] for row in rows] for rows in (front, behind)]
        different = sum(a != b for rows in zip(*covered)
                        for a, b in zip(rows[0], reversed(rows[1])))
        self.assertLess(different, 20)
        self.assertGreater(sum(map(sum, covered[0])), 500)
        # From the side, it is a line.
        self.assertLess(support.opaque_share(self.folder / "t.2.png"), 0.02)
        # Every second frame of eight is a frame of four.
        self.run_command(*turn, "--frames", "1-7x2", "-o", "s.#.png")
        self.assertEqual(self.bytes_of("s.3.png"), self.bytes_of("t.2.png"))

    def test_without_a_camera_shows_everything_from_all_sides(self):
        (self.folder / "tall.obj").write_text(
            "v 3 0 0\nv 9 0 0\nv 6 9 0\nv 6 0 5\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n")
        for size in ("96x54", "40x80"):
            self.run_command("animate", "tall.obj", "--turntable", "--frames", "1-6", "--size",
                             size, "--samples", "1", "--background", "transparent", "-o",
                             "t.#.png", "--overwrite")
            for frame in range(1, 7):
                width, height, rows = support.png_pixels(self.folder / f"t.{frame}.png")
                border = rows[0] + rows[-1] + [row[0] for row in rows] + [row[-1] for row in rows]
                self.assertEqual(max(pixel[3] for pixel in border), 0)
                self.assertGreater(support.opaque_share(self.folder / f"t.{frame}.png"), 0.08)

    def test_around_an_object(self):
        (self.folder / "two.obj").write_text(
            "o far\nv 30 0 0\nv 39 0 0\nv 36 9 0\nf 1 2 3\n"
            "o near\nv 3 0 0\nv 9 0 0\nv 6 9 0\nv 6 0 5\nf 4 5 6\nf 4 5 7\nf 4 6 7\nf 5 6 7\n")
        words = ("animate", "two.obj", "--frames", "1-4", "--size", "60x60", "--samples", "1",
                 "--background", "transparent", "-o", "t.#.png")
        self.run_command(*words, "--around", "near")
        for frame in range(1, 5):
            self.assertGreater(support.opaque_share(self.folder / f"t.{frame}.png"), 0.1)
        self.run_command(*words, "--turntable", "--overwrite")
        self.assertLess(support.opaque_share(self.folder / "t.1.png"), 0.1)
        self.refused(*words, "--around", "nea", "--overwrite", code=1, says="nea", helps="near")


class Shards(AnimationTest):
    def test_whole_frames(self):
        self.animate("--frames", "1-5", "-o", "w.#.exr")
        for number in (1, 2):
            self.animate("--frames", "1-5", "-o", "f.#.exr", "--shard", f"{number}/2")
            made = [name for name in self.files() if name.startswith("f.") and
                    name.endswith(".exr")]
            self.assertEqual(len(made), 3 if number == 1 else 5)
        for frame in range(1, 6):
            self.assertEqual(self.bytes_of(f"f.{frame}.exr"), self.bytes_of(f"w.{frame}.exr"))
        self.run_command("merge", "f.#.exr")

    def test_parts_of_frames(self):
        more = ("--frames", "1-2", "--parts-per-frame", "3")
        for output, layers in (("f.#.png", ()), ("f.#.exr", ("--layers", "all"))):
            for number in range(1, 5):
                self.animate(*more, *layers, "-o", output, "--shard", f"{number}/4")
            self.animate("--frames", "1-2", *layers, "-o", output.replace("f", "w", 1))
            self.run_command("merge", output)
            for frame in ("1", "2"):
                name = output.replace("#", frame)
                self.assertEqual(self.bytes_of(name), self.bytes_of(name.replace("f", "w", 1)))

    def test_missing_and_damaged_parts_are_named(self):
        more = ("--frames", "1-3", "--parts-per-frame", "2", "-o", "f.#.exr")
        for number in (1, 2, 3):
            self.animate(*more, "--shard", f"{number}/6")
        part = self.folder / "f.1.exr.shard-1-of-2"
        whole = part.read_bytes()
        part.write_bytes(whole[:-3])
        err = self.refused("merge", "f.#.exr", code=1,
                           says="frame 1: 'f.1.exr.shard-1-of-2' cannot be merged: it is damaged",
                           helps="without --shard")
        self.assertIn("frame 2: 1 of 2 shards missing: 2/2", err)
        self.assertIn("1 of 3 frames missing: 3", err)
        self.assertFalse((self.folder / "f.1.exr").exists())
        document = self.json_of(*self.words(*more))
        self.assertIn("'f.1.exr.shard-1-of-2' is damaged and is rendered again", str(document))
        self.assertEqual((document["rendered"], part.read_bytes()), (4, whole))
        self.run_command("merge", "f.#.exr")

    def test_damaged_frames_are_named(self):
        for ending in ("png", "exr", "tif", "jpg", "webp"):
            more = ("--frames", "1-3", "-o", f"f.#.{ending}")
            self.animate(*more)
            self.run_command("merge", f"f.#.{ending}")
            frame = self.folder / f"f.2.{ending}"
            whole = frame.read_bytes()
            for size in (len(whole) - 40, len(whole) // 2, 20):
                frame.write_bytes(whole[:size])
                self.refused("merge", f"f.#.{ending}", code=1,
                             says=f"frame 2: 'f.2.{ending}' is damaged: ", helps="remove it")
                document = self.json_of(*self.words(*more))
                self.assertEqual(document["rendered"], 1)
                self.assertIn(f"frame 2: 'f.2.{ending}' is damaged and is rendered again: ",
                              document["diagnostics"][0]["message"])
                self.assertEqual(len(frame.read_bytes()), len(whole))
            self.run_command("merge", f"f.#.{ending}")

    def test_parts_of_other_settings(self):
        more = ("--frames", "1", "--parts-per-frame", "2")
        self.animate(*more, "-o", "f.#.exr", "--shard", "1/2")
        self.animate(*more, "-o", "g.#.exr", "--shard", "2/2", "--samples", "3")
        self.refused("merge", "f.1.exr.shard-1-of-2", "g.1.exr.shard-2-of-2", "-o", "h.exr",
                     code=1, says="--samples was '2' and is '3'")
        self.refused(*self.words(*more, "-o", "f.#.exr", "--shard", "2/2", "--samples", "3"),
                     code=1, says="--samples was '2' and is '3'")

    def test_fewer_frames_than_shards(self):
        self.refused(*self.words("--frames", "1-3", "-o", "f.#.exr", "--shard", "1/7"), code=2,
                     says="there are 7 shards, but only 3 frames", helps="--parts-per-frame 3")
        self.animate("--frames", "1-3", "-o", "f.#.exr", "--shard", "7/7", "--parts-per-frame",
                     "3")
        self.refused("merge", "x.#.exr", code=1, says="there are no frames of 'x.#.exr'")

    def test_a_picture_by_its_name(self):
        for number in (1, 2):
            self.run_command("render", "room.glb", *self.SMALL, "-o", "p.exr", "--shard",
                             f"{number}/2")
        self.run_command("merge", "p.exr")
        self.assertTrue((self.folder / "p.exr").exists())


class Films(AnimationTest):
    def test_ffmpeg_is_missing(self):
        out, err = self.animate("--frames", "1-3", "-o", "film.mp4", code=3,
                                env=dict(os.environ, PATH="/nowhere"))
        self.assertIn("needs the program ffmpeg", err)
        self.assertIn("--output 'film.####.png'", err)
        self.assertFalse((self.folder / "film.mp4").exists())
        self.assertEqual([name for name in self.files() if name.endswith(".png")], [])

    def test_ffmpeg_fails(self):
        fake = self.folder / "ffmpeg"
        fake.write_text(FAKE_FFMPEG)
        fake.chmod(0o755)
        out, err = self.animate("--frames", "1-3", "-o", "film.mp4", code=3,
                                env=dict(os.environ, PATH=f"{self.folder}:/usr/bin:/bin"))
        self.assertIn("the encoder is ill", err)
        self.assertIn("film.mp4.frames", err)
        frames = self.folder / "film.mp4.frames"
        self.assertEqual(len(list(frames.glob("*.png"))), 3)
        if has_ffmpeg:
            self.assertEqual(self.json_of(*self.words("--frames", "1-3", "-o", "film.mp4"))[
                "rendered"], 0)
            self.assertFalse(frames.exists())

    @unittest.skipUnless(has_ffmpeg, "ffmpeg is not installed")
    def test_formats(self):
        for name, codec in (("a.mp4", "h264"), ("a.mov", "h264"), ("a.mkv", "h264"),
                            ("a.webm", "vp9"), ("a.gif", "gif")):
            with self.subTest(name=name):
                self.animate("--frames", "1-5", "--fps", "10", "-o", name)
                self.assertEqual([left for left in self.files() if left.startswith(f"{name}.")], [])
                probed = subprocess.run(
                    ["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of", "json",
                     name], cwd=self.folder, capture_output=True, check=True)
                stream = json.loads(probed.stdout)["streams"][0]
                self.assertEqual(stream["codec_name"], codec)
                self.assertEqual((stream["width"], stream["height"]), (96, 70))
                self.assertEqual(stream["nb_read_frames"], "5")
                self.assertEqual(stream["r_frame_rate"], "10/1")
                if codec != "gif":
                    self.assertEqual(stream["pix_fmt"], "yuv420p")
                    self.assertEqual([stream[f"color_{kind}"] for kind in
                                      ("space", "primaries", "transfer", "range")],
                                     ["bt709", "bt709", "bt709", "tv"])

    @unittest.skipUnless(has_ffmpeg, "ffmpeg is not installed")
    def test_colours_survive(self):
        words = ("animate", "room.glb", "--camera", "my.cam:nowhere", "--size", "64x48",
                 "--background", "0.9,0.2,0.1", "--samples", "1", "--frames", "1-2")
        self.run_command(*words, "-o", "a.mp4")
        subprocess.run(["ffmpeg", "-v", "error", "-i", "a.mp4", "-frames:v", "1", "-pix_fmt",
                        "rgba", "b.png"], cwd=self.folder, check=True)
        self.run_command(*words, "-o", "c.#.png")
        found = support.png_pixels(self.folder / "b.png")[2][24][32]
        wanted = support.png_pixels(self.folder / "c.1.png")[2][24][32]
        for a, b in zip(found, wanted):
            self.assertLessEqual(abs(a - b), 3)

    @unittest.skipUnless(has_ffmpeg, "ffmpeg is not installed")
    def test_sizes_frames_and_quality(self):
        out, err = self.animate("--frames", "1-2", "--size", "95x71", "-o", "a.mp4",
                                "--keep-frames")
        self.assertIn("an even number of pixels: 94 x 70", err)
        self.assertTrue((self.folder / "a.mp4.frames" / "frame.00002.png").exists())
        for crf, more in (("-1", 2), ("52", 2), ("x", 2)):
            self.refused(*self.words("--frames", "1", "-o", "a.mp4", f"--crf={crf}"), code=more,
                         says="--crf cannot be")
        self.refused(*self.words("--frames", "1", "-o", "a.gif", "--crf", "5"), code=2,
                     says="has no --crf")

    @unittest.skipUnless(has_ffmpeg, "ffmpeg is not installed")
    def test_shards(self):
        self.animate("--frames", "1-5", "-o", "w.mp4")
        more = ("--frames", "1-5", "-o", "f.mp4")
        self.animate(*more, "--shard", "1/2")
        self.refused("merge", "f.mp4", code=1, says="2 of 5 frames missing: 2,4")
        self.animate(*more, "--shard", "2/2")
        self.assertFalse((self.folder / "f.mp4").exists())
        self.run_command("merge", "f.mp4")
        self.assertEqual(self.bytes_of("f.mp4"), self.bytes_of("w.mp4"))
        self.animate("--frames", "1-5", "-o", "s.#.png", "--background", "black")
        self.run_command("merge", "s.#.png", "-o", "s.mp4")
        self.assertTrue((self.folder / "s.1.png").exists())


if __name__ == "__main__":
    support.main()
