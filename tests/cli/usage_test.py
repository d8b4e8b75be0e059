# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Help, invalid command lines, and closed streams."""

import os
import re
import subprocess

import support

COMMANDS = ("render", "check", "list", "info")


class Help(support.CommandTest):
    def test_of_every_command_reads_well(self):
        for words in ((), *((command,) for command in COMMANDS)):
            out, err = self.run_command(*words, "--help")
            self.assertEqual(err, "")
            self.assertIn("\n  balcony ", out, "no example")
            self.assertIn("Usage: " + " ".join(("balcony", *words)), out)
            self.assertLessEqual(max(map(len, out.splitlines())), 80)
            for clutter in ("TEXT", "REQUIRED", "UINT", "FLOAT", ":{", "INT in", "/balcony"):
                self.assertNotIn(clutter, out)

    def test_names_every_command_and_exit_code(self):
        out, _ = self.run_command("--help")
        for word in (*COMMANDS, "0 success", "1 bad input", "2 wrong usage", "3 environment", "130"):
            self.assertIn(word, out)

    def test_version(self):
        out, _ = self.run_command("--version")
        self.assertRegex(out, r"^balcony \d+\.\d+\.\d+\n$")


    def test_by_the_word_help(self):
        self.assertEqual(self.run_command("help"), self.run_command("--help"))
        self.assertEqual(self.run_command("help", "render"), self.run_command("render", "--help"))
        self.assertEqual(self.run_command("help", "zoom"), self.run_command("list", "zoom"))

    def test_of_many_options_begins_with_those_that_are_used_most(self):
        for command in ("render", "animate"):
            text, _ = self.run_command(command, "--help")
            self.assertLessEqual(len(text.splitlines()), 100)
            self.assertIn("\n\n--help all shows all options.\n\n", text)
            self.assertNotIn("\n\n\n", text)
            self.assertNotIn("--no-dither", text)
            for words in ((command, "--help", "all"), (command, "-h", "all"),
                          ("help", command, "all")):
                whole, _ = self.run_command(*words)
                self.assertIn("\nMore options:\n", whole)
                self.assertIn("  --no-dither ", whole)
        self.assertEqual(self.run_command("info", "--help"), self.run_command("info", "--help", "all"))

    def test_version_by_one_letter(self):
        self.assertEqual(self.run_command("-V"), self.run_command("--version"))


class WrongUsage(support.CommandTest):
    def test_nothing_said_shows_the_help(self):
        out, err = self.run_command(code=2)
        self.assertEqual(out, "")
        self.assertIn("Usage: balcony", err)

    def test_misspelt_command(self):
        self.refused("rendr", "scene.obj", code=2, says="'rendr'", helps="did you mean 'render'?")
        self.refused("qwertyuiop", code=2, says="'qwertyuiop'", helps="balcony --help")

    def test_help_for_what_is_no_command(self):
        for words in (("help", "NOPE"), ("NOPE", "--help"), ("NOPE", "x", "-h")):
            self.refused(*words, code=2, says="balcony has no command 'NOPE'")
        self.refused("help", "rendr", code=2, says="'rendr'", helps="did you mean 'render'?")

    def test_misspelt_option(self):
        for words in (("--samplse", "3"), ("--samplse=3",)):
            self.refused("render", "scene.obj", *words, code=2, says="no option '--samplse'",
                         helps="did you mean '--samples'?")
        self.refused("info", "--ojects", code=2, says="'--ojects'", helps="'--objects'")

    def test_something_missing_or_too_much(self):
        self.refused("render", code=2, says="SCENE", helps="balcony render --help")
        self.refused("check", code=2, says="FILE", helps="balcony check --help")
        self.refused("render", "scene.obj", "--size", code=2, says="--size needs a value")
        self.refused("info", "scene.obj", "other.obj", code=2, says="'other.obj'")

    def test_arguments_that_are_values_of_an_option(self):
        for words, helps in ((("render", "scene.obj", "my.cam"), "--camera my.cam"),
                             (("render", "scene.obj", "my.exr"), "--output my.exr"),
                             (("render", "scene.obj", "gamma=1/2"), "--set gamma=1/2"),
                             (("render", "scene.obj", "-camera", "panorama"),
                              "--camera with two hyphens"),
                             (("locate", "panorama", "1,2,-3"), "--point 1,2,-3"),
                             (("locate", "panorama", "--point", "1", "2", "3"), "--point X,Y,Z"),
                             (("draw", "panorama", "-o", "a.svg", "b.svg"), "--output b.svg"),
                             (("scene.obj",), "balcony render scene.obj"),
                             (("my.cam",), "balcony check my.cam"),
                             (("render", "scene.obj", "--denoise", "1"), "--denoise without a value"),
                             (("info", "scene.obj", "--objects", "true"),
                              "--objects without a value")):
            self.refused(*words, code=2, says="", helps=helps)

    def test_a_camera_in_the_place_of_a_scene(self):
        for command in ("info", "render"):
            for camera in ("my.cam", "panorama"):
                self.refused(command, camera, code=1, says=f"'{camera}' is a camera, not a scene",
                             helps=f"balcony explain {camera}")

    def test_as_json(self):
        for words in (("rendr",), ("render",), ("render", "scene.obj", "--samplse"), ()):
            document = self.json_of(*words, code=2)
            self.assertEqual(len(document["diagnostics"]), 1)

    def test_the_last_of_an_option_counts(self):
        words = ("--size", "7x7", "--size", "4x2", "-s", "9", "-s", "2", "-o", "a.exr")
        facts = self.json_of("render", "scene.obj", *words)
        self.assertEqual((facts["width"], facts["height"], facts["passes"]), (4, 2, 2))
        self.assertIn("a.exr", self.files())

    def test_options_as_others_call_them(self):
        words = ("render", "scene.obj", "--resolution", "6x4", "--spp=2", "--draft", "--out", "a.exr",
                 "--transparent", "-c", "pinhole", "--fov", "40deg")
        facts = self.json_of(*words)
        self.assertEqual((facts["width"], facts["height"], facts["passes"]), (6, 4, 2))
        same = self.json_of("render", "scene.obj", "--size", "6x4", "-s", "2", "--integrator", "preview",
                            "-o", "b.exr", "--background", "transparent", "-c", "pinhole", "--set",
                            "fov=40deg")
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())
        self.assertEqual(same["passes"], 2)
        self.refused("render", "scene.obj", "--frame", "3", code=2, says="no option '--frame'",
                     helps="did you mean '--time'")
        self.refused("render", "scene.obj", "--hdri", "no.hdr", code=1, says="no.hdr")

    def test_two_words_for_a_size(self):
        facts = self.json_of("render", "scene.obj", "--size", "6", "4", "-s", "1", "-o", "a.exr")
        self.assertEqual((facts["width"], facts["height"]), (6, 4))

    def test_what_an_option_names_is_given_once(self):
        self.refused("render", "scene.obj", "-c", "panorama", "-c", "pinhole", code=2,
                     says="--camera is given twice: 'panorama' and 'pinhole'")
        self.refused("render", "scene.obj", "-o", "a.exr", "--output", "b.exr", code=2,
                     says="--output is given twice")
        self.assertNotIn("a.exr", self.files())

    def test_films_are_no_pictures(self):
        for name in ("y.avi", "y.mp4", "Y.GIF"):
            self.refused("render", "scene.obj", "-o", name, code=2, says=f"'{name}' is a film",
                         helps="balcony animate")
        self.refused("animate", "scene.obj", "--frames", "1-2", "-o", "y.avi", code=2,
                     says="'y.avi' are not written", helps=".mp4")

    def test_what_is_no_camera_file(self):
        (self.folder / "fish.yml").write_text("camera_matrix: [1, 1, 1, 1]\n")
        (self.folder / "large.glb").write_bytes(b"glTF" + bytes(2_000_000))
        (self.folder / "photo.png").write_bytes(b"\x89PNG")
        for words in (("check",), ("render", "scene.obj", "-c")):
            self.refused(*words, "scene.obj", code=1, says="'scene.obj' is a scene",
                         helps="balcony info scene.obj")
            self.refused(*words, "large.glb", code=1, says="'large.glb' is a scene")
            self.refused(*words, "photo.png", code=1, says="'photo.png' is a picture")
            self.refused(*words, "fish.yml", code=1, says="'fish.yml' is a calibration",
                         helps='camera fish { eye opencv("fish.yml") }')

    def test_addresses(self):
        address = "https://example.org/room.glb"
        for words in (("info", address), ("render", address), ("check", address),
                      ("render", "scene.obj", "-c", address),
                      ("render", "scene.obj", "--add", address),
                      ("render", "scene.obj", "--environment", address)):
            self.refused(*words, code=1, says=f"'{address}' is an address, not a file",
                         helps="download it")

    def test_a_scene_named_as_a_command(self):
        (self.folder / "list").write_text("no scene")
        self.refused("render", "list", code=1, says="list")


class OptionRows(support.CommandTest):
    """balcony list options --json: what other programs build their own options from."""

    def rows(self, command):
        commands = self.json_of("list", "options")["commands"]
        return {row["name"]: row for one in commands if one["name"] == command
                for row in one["options"]}

    def test_are_those_of_the_help(self):
        commands = self.json_of("list", "options")["commands"]
        for command in commands:
            text, _ = self.run_command(command["name"], "--help", "all")
            spelt = re.findall(r"^  (?:-\w, )?(--[\w-]+)", text, re.MULTILINE)
            rows = [row["name"] for row in command["options"]]
            self.assertEqual(sorted(name for name in rows if name.startswith("-")),
                             sorted(name for name in spelt if name not in ("--help", "--version")))
            self.assertTrue(all(f" {name}" in text for name in rows))

    def test_tell_types_ranges_and_defaults(self):
        rows = self.rows("draw")
        self.assertEqual({key: rows["--rays"][key] for key in ("type", "minimum", "maximum",
                                                               "default", "placeholder")},
                         {"type": "count", "minimum": 0, "maximum": 100, "default": "9",
                          "placeholder": "COUNT"})
        self.assertEqual(rows["--output"]["letter"], "-o")
        self.assertTrue(rows["--output"]["required"])
        self.assertEqual([one["name"] for one in self.rows("rays")["--axes"]["choices"]],
                         ["y_up", "z_up"])

    def test_can_be_read(self):
        text, _ = self.run_command("list", "options")
        self.assertIn("    --rays", text)


class Streams(support.CommandTest):
    def test_a_reader_that_has_read_enough(self):
        for words in (("list",), ("list", "--json"), ("render", "scene.obj", "--size", "4")):
            reading, writing = os.pipe()
            os.close(reading)
            _, err = self.run_command(*words, stdout=writing)
            os.close(writing)
            self.assertEqual(err, "")

    def test_full_standard_output(self):
        with open("/dev/full", "wb") as full:
            for words in (("list",), ("--help",), ("info", "scene.obj", "--json")):
                _, err = self.run_command(*words, code=3, stdout=full)
                self.assertIn("standard output", err)

    def test_full_standard_output_is_one_error(self):
        with open("/dev/full", "wb") as full:
            _, err = self.run_command("rays", "panorama", "--size", "400", code=3, stdout=full)
        self.assertEqual(err.count("error: "), 1, err)

    def test_closed_streams(self):
        def shell(redirection):
            line = f'exec "$0" render scene.obj --size 8x8 -o picture.png {redirection}'
            return subprocess.run(["sh", "-c", line, support.BALCONY], cwd=self.folder,
                                  capture_output=True, timeout=60).returncode

        for redirection, code in (("2>&-", 0), ("<&-", 0), (">&-", 3), ("<&- >&- 2>&-", 3)):
            self.assertEqual(shell(redirection), code, redirection)
            self.assertEqual(support.png_pixels(self.folder / "picture.png")[:2], (8, 8))

    def test_a_lost_reader_of_the_progress_does_not_end_a_render(self):
        reading, writing = os.pipe()
        os.close(reading)
        self.run_command("render", "scene.obj", "--size", "600", "-s", "30", "-o", "a.exr",
                         stderr=writing)
        os.close(writing)
        self.assertIn("a.exr", self.files())


if __name__ == "__main__":
    support.main()
