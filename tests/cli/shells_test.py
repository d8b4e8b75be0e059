# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Completion and manual pages: what the command tells shells and man."""

import shutil
import subprocess
import unittest

import support


class Completion(support.CommandTest):
    def words(self, *line):
        out, err = self.run_command("complete", *line)
        self.assertEqual(err, "")
        return [word.split("\t")[0] for word in out.splitlines()]

    def test_commands_and_options_are_those_of_help(self):
        text, _ = self.run_command("--help")
        commands = [word for word in self.words("") if not word.startswith("-")]
        self.assertIn("render", commands)
        for command in commands:
            self.assertIn(f"\n  {command} ", text)
            own, _ = self.run_command(command, "--help", "all")
            for option in self.words(command, "-"):
                self.assertIn(option, own)
            self.assertIn("--help", self.words(command, "--"))
        self.assertEqual(self.words("re"), ["render"])
        self.assertEqual(self.words("help", "re"), ["render"])

    def test_files(self):
        (self.folder / "my_rooms").mkdir()
        (self.folder / "my_rooms" / "hall.ply").write_text("")
        self.assertEqual(self.words("render", ""), ["my_rooms/", "room.glb", "scene.obj"])
        self.assertEqual(self.words("render", "my_rooms/"), ["my_rooms/hall.ply"])
        self.assertEqual(self.words("fmt", "my"), ["my.cam", "my_rooms/"])
        self.assertEqual(self.words("check", "my.cam", "--scene", "ro"), ["room.glb"])

    def test_cameras_and_their_parameters(self):
        self.assertIn("panorama", self.words("render", "scene.obj", "-c", "p"))
        self.assertEqual(self.words("render", "scene.obj", "--camera", "my"), ["my.cam"])
        self.assertEqual(self.words("render", "scene.obj", "--camera", "my.cam:c"),
                         ["my.cam:closeup"])
        self.assertEqual(self.words("explain", "my.cam:h"), ["my.cam:half"])
        for camera in (("render", "scene.obj", "-c", "my.cam:above"), ("explain", "my.cam:above")):
            self.assertEqual(self.words(*camera, "--set", ""), ["size="])
        self.assertIn("fov=", self.words("render", "-c", "pinhole", "--set", "f"))

    def test_values(self):
        self.assertIn("preview", self.words("render", "scene.obj", "--integrator", ""))
        self.assertEqual(self.words("render", "scene.obj", "--integrator=pre"),
                         ["--integrator=preview"])
        self.assertEqual(self.words("locate", "panorama", "--axes", "y"), ["y_up"])
        self.assertEqual(self.words("render", "scene.obj", "--samples", ""), [])

    def test_names_that_would_control_a_terminal_are_left_out(self):
        for name in ("red\033[31m.obj", "two\nlines.obj", "turned\u202e.obj", "tab\tbed.obj"):
            (self.folder / name).write_text("")
        self.assertEqual(self.words("render", ""), ["room.glb", "scene.obj"])

    def test_what_is_wrong_completes_to_nothing(self):
        for line in ((), ("",) * 3, ("rendr", "x"), ("render", "--no-such", ""),
                     ("render", "-c", "lost.cam:"), ("render", "lost/")):
            self.run_command("complete", *line)

    @unittest.skipUnless(shutil.which("bash"), "bash is not installed")
    def test_in_bash(self):
        script = support.REPOSITORY / "src/cli/completions/balcony.bash"
        (self.folder / "other scene.obj").write_text(support.OBJ)

        def completed(*words):
            line = ('source "$0"; compopt() { :; }; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
                    '_balcony; printf "%s\\n" "${COMPREPLY[@]}"')
            return subprocess.run(["bash", "-c", line, script, support.BALCONY, *words],
                                  cwd=self.folder, capture_output=True, text=True, check=True,
                                  timeout=60).stdout.splitlines()

        self.assertEqual(completed("ren"), ["render"])
        self.assertEqual(completed("render", "o"), ["other\\ scene.obj"])
        # Bash has split the words at the colon and the equals sign.
        self.assertEqual(completed("render", "-c", "my.cam", ":", "c"), ["closeup"])
        self.assertEqual(completed("render", "--camera", "=", "my.cam", ":", "c"), ["closeup"])


class Manual(support.CommandTest):
    def test_has_a_page_with_every_option_of_each_command(self):
        self.run_command("manual", "pages")
        text, _ = self.run_command("--help")
        pages = sorted(path.name for path in (self.folder / "pages").iterdir())
        out, _ = self.run_command("complete", "")
        commands = [line.split("\t")[0] for line in out.splitlines() if line[0] != "-"]
        self.assertEqual(pages, sorted(["balcony.1", *(f"balcony-{c}.1" for c in commands)]))
        for command in commands:
            page = (self.folder / "pages" / f"balcony-{command}.1").read_text()
            self.assertTrue(page.startswith(f".TH BALCONY-{command.upper()} 1 "))
            out, _ = self.run_command("complete", command, "--")
            for line in out.splitlines():
                self.assertIn(line.split("\t")[0].replace("-", "\\-"), page)

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_is_valid_for_man(self):
        self.run_command("manual", "pages")
        for page in (self.folder / "pages").iterdir():
            done = subprocess.run(["groff", "-man", "-Tascii", "-ww", "-z", page],
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (0, ""), page)


if __name__ == "__main__":
    support.main()
