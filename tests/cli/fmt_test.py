# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony fmt: formats camera files."""

import json
import os

import support

UGLY = "camera a{eye sphere // round\nmap u=0..1,v=0..1}\n"
NEAT = "camera a {\n    eye sphere  // round\n    map u = 0 .. 1, v = 0 .. 1\n}\n"


class Fmt(support.CommandTest):
    def setUp(self):
        super().setUp()
        self.file = self.folder / "ugly.cam"
        self.file.write_text(UGLY)

    def test_in_place_and_then_never_again(self):
        self.assertEqual(self.run_command("fmt", "ugly.cam"), ("ugly.cam: formatted\n", ""))
        self.assertEqual(self.file.read_text(), NEAT)
        self.assertEqual(self.run_command("fmt", "ugly.cam"), ("", ""))
        self.assertEqual(self.file.read_text(), NEAT)

    def test_check_changes_nothing(self):
        self.refused("fmt", "--check", "ugly.cam", code=1, says="'ugly.cam' is not formatted",
                     helps="balcony fmt ugly.cam")
        self.assertEqual(self.file.read_text(), UGLY)
        self.file.write_text(NEAT)
        self.run_command("fmt", "--check", "ugly.cam")

    def test_from_standard_input(self):
        with self.file.open() as text:
            self.assertEqual(self.run_command("fmt", "-", stdin=text), (NEAT, ""))

    def test_standard_input_as_json(self):
        with self.file.open() as text:
            out, err = self.run_command("fmt", "-", "--json", stdin=text)
        self.assertEqual(err, "")
        self.assertEqual(json.loads(out)["files"], [{"file": "-", "changed": True, "text": NEAT}])

    def test_check_of_standard_input_writes_nothing(self):
        with self.file.open() as text:
            out, err = self.run_command("fmt", "--check", "-", code=1, stdin=text)
        self.assertEqual(out, "")
        self.assertIn("'standard input' is not formatted", err)

    def test_errors_leave_the_file_alone(self):
        self.file.write_text("camera a {")
        self.refused("fmt", "ugly.cam", code=1, says="ugly.cam:1")
        self.assertEqual(self.file.read_text(), "camera a {")
        self.refused("fmt", "none.cam", code=1, says="'none.cam'")

    def test_a_file_that_would_become_too_large_is_left_alone(self):
        text = "camera a{map u=1..-1,v=square eye sphere(" + "+".join(["1"] * 450_000) + ")}"
        self.file.write_text(text)
        self.refused("fmt", "ugly.cam", code=1, says="larger than 1 MB", helps="import")
        self.assertEqual(self.file.read_text(), text)

    def test_a_pipe_is_not_waited_for(self):
        os.mkfifo(self.folder / "pipe.cam")
        self.refused("fmt", "pipe.cam", code=1, says="'pipe.cam' is a pipe", helps="to a file")

    def test_json(self):
        files = self.json_of("fmt", "ugly.cam", "--check", code=1)["files"]
        self.assertEqual(files, [{"file": "ugly.cam", "changed": True}])


if __name__ == "__main__":
    support.main()
