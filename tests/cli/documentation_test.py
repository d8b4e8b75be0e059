# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs every command line that the README, docs/ and the help show."""

import json
import re
import shlex
import shutil
import signal
import struct
import subprocess

import support

FENCED = re.compile(r"^```(?:sh|console)\n(.*?)^```", re.MULTILINE | re.DOTALL)
# tests/guides runs all steps of these pages.
GUIDES = ("blender.md", "bridges.md", "calibrated.md", "cookbook.md", "datasets.md", "povray.md",
          "python.md", "raymaps.md", "solve.md")
# What my.cam:closeup and pinhole can show.
MARKS = """size: [320, 200]
unknowns: [fov, yaw]
marks: {door: [-24, 10, 0], sign: [-27, 12, 2]}
constraints: [{at: door, position: [200, 100]}, {level: [door, sign], deviation: 50}]
"""
FACADE = """size: [16, 8]
unknowns: [yaw, pitch]
marks: {door: [20, 4, 0]}
constraints: [{at: door, position: [6, 5]}]
"""
RECIPE = """scenes = ["room.glb"]
cameras = ["pinhole"]
poses = [{list = [[[1, 0, 0, 0], [0, -1, 0, 0], [0, 0, -1, 3]]]}]
render = {size = "8x8", samples = 1}
"""
STARTS = ("balcony ", "build/release/balcony ")


def command_lines(text):
    """The lines of a text that start the command, without their comments."""
    for line in text.replace("\\\n", " ").splitlines():
        line = line.strip().removeprefix("$ ")
        if line.startswith(STARTS):
            # In help, two spaces part a command from what it does.
            yield shlex.split(re.split(r" {2,}", line)[0], comments=True)[1:]


class Documentation(support.CommandTest):
    def setUp(self):
        super().setUp()
        for name in ("build/release", "out", "pictures"):
            (self.folder / name).mkdir(parents=True)
        for name in ("gallery", "scene", "build/release/gallery"):
            (self.folder / f"{name}.glb").write_bytes(support.glb_bytes())
        for name in ("docs", "plates", "examples"):
            (self.folder / name).symlink_to(support.REPOSITORY / name)
        shutil.copy(support.REPOSITORY / "examples" / "my.cam", self.folder)
        (self.folder / "filmed.gltf").write_text(support.gltf_text_with_cameras())
        self.run_command("render", "scene.glb", "--size", "16x8", "-s", "1", "-o", "photo.png")
        (self.folder / "corners.csv").write_text("1,2,3\n-1,0,0.5\n")
        (self.folder / "marks.yml").write_text(MARKS)
        (self.folder / "facade.yml").write_text(FACADE)
        header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3), }".ljust(117) + "\n"
        (self.folder / "cloud.npy").write_bytes(
            b"\x93NUMPY\x01\0" + struct.pack("<H", 118) + header.encode() +
            struct.pack("<3d", 0, 0, 1))
        domes = (support.REPOSITORY / "docs" / "domes.md").read_text()
        (self.folder / "dome.cam").write_text(
            re.search(r"^```cam\n(camera left .*?)^```", domes, re.MULTILINE | re.DOTALL)[1])

    def run_all(self, lines):
        for number, words in enumerate(dict.fromkeys(map(tuple, lines))):
            with self.subTest(line=" ".join(words)):
                # The last option of a kind counts, so these make the page's picture small.
                size = ("-W", "24") if "-W" in words else ("--size", "24x16")
                small = (*size, "--samples", "1") if words[0] in ("render", "animate") else ()
                small = size if words[0] in ("blend", "demo", "rays", "stmap", "warp") else small
                if words[0] == "merge" and words[1].endswith(".mp4") and not shutil.which("ffmpeg"):
                    continue
                if words[0] == "animate" or (words[0] == "draw" and "--frames" in words):
                    small += ("--frames", "1-4")
                    words = self.without_films(words, f"film-{number}.#.png")
                if words[0] == "lsp":
                    self.serve(*words)
                elif words[0] == "studio":
                    self.open_studio(*words)
                elif "--watch" in words:
                    self.watch(*words, *small)
                else:
                    self.run_command(*words, *small)

    @staticmethod
    def without_films(words, sequence):
        """A sequence in place of a film where there is no ffmpeg."""
        output = words.index("-o") + 1
        if shutil.which("ffmpeg") or "#" in words[output]:
            return words
        return (*words[:output], sequence, *words[output + 1:])

    def watch(self, *words):
        with self.start(*words) as process:
            for line in process.stderr:
                if b"watching" in line:
                    process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(timeout=60), 130)

    def open_studio(self, *words):
        with self.start(*words) as process:
            self.assertIn(b"http://", process.stdout.readline())
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(timeout=60), 130)

    def serve(self, *words):
        """An editor says what it must say, and that is all."""
        said = b""
        for number, method in ((1, "initialize"), (2, "shutdown"), (None, "exit")):
            message = {"jsonrpc": "2.0", "method": method, **({"id": number} if number else {})}
            text = json.dumps(message).encode()
            said += b"Content-Length: %d\r\n\r\n%s" % (len(text), text)
        with self.start(*words, stdin=subprocess.PIPE) as process:
            process.communicate(said, timeout=60)
        self.assertEqual(process.returncode, 0)

    def test_pages(self):
        pages = [support.REPOSITORY / "README.md", *(support.REPOSITORY / "docs").glob("*.md")]
        pages = [page for page in pages if page.name not in GUIDES]
        lines = [line for page in pages for block in FENCED.findall(page.read_text())
                 for line in command_lines(block)]
        self.assertGreaterEqual(len(lines), 5, "the README shows the command no more")
        self.run_all(lines)

    def test_the_superelliptic_camera_is_the_built_in_one(self):
        """A reader who types the listing gets the camera that has its name."""
        cameras = support.REPOSITORY / "cameras"
        code = "".join(line for line in (cameras / "paper" / "superelliptic.cam").open()
                       if not line.startswith("//"))
        for name in ("README.md", "docs/language.md"):
            page = (support.REPOSITORY / name).read_text()
            listings = re.findall(r"^camera superelliptic\(.*?^}\n", page, re.MULTILINE | re.DOTALL)
            self.assertEqual(listings, [code], name)

    def test_json_fields(self):
        page = (support.REPOSITORY / "docs" / "command.md").read_text()
        runs = {"render": ("room.glb", "--size", "8"), "check": ("my.cam",), "list": ("zoom",),
                "info": ("room.glb",), "draw": ("pinhole", "-o", "p.svg"),
                "export": ("pinhole", "-o", "p.osl"),
                "rays": ("pinhole", "--size", "8", "-o", "r.npy"),
                "blend": ("dome.cam:left", "--from", "fulldome", "--size", "8", "-o", "out"),
                "stmap": ("pinhole", "--from", "panorama", "--size", "8", "-o", "st.exr"),
                "warp": ("photo.png", "--from", "panorama", "--camera", "pinhole", "--size", "8",
                         "-o", "w.png"),
                "solve": ("my.cam:closeup", "--with", "marks.yml"),
                "animate": ("room.glb", "--size", "8", "--frames", "1", "-o", "f.#.png"),
                "merge": ("m.png.shard-1-of-1",), "dataset": ("a.toml", "-o", "set")}
        (self.folder / "a.toml").write_text(RECIPE)
        self.run_command("render", "room.glb", "--size", "8", "--shard", "1/1", "-o", "m.png")
        for command, words in runs.items():
            (row,) = re.findall(rf"^\| `{command}` \| (.*) \|$", page, re.MULTILINE)
            document = self.json_of(command, *words)
            inner = [document.get("scene", {}), *document.get("files", []),
                     *document.get("stages", []), *document.get("pictures", []),
                     *document.get("projectors", [])]
            for field in {"diagnostics", *document} | {name for part in inner for name in part}:
                self.assertIn(f"`{field}`", page if field == "diagnostics" else row)

    def test_help(self):
        lines = []
        for words in ((), ("render",), ("animate",), ("check",), ("list",), ("info",), ("draw",),
                      ("explain",), ("export",), ("locate",), ("solve",), ("rays",), ("stmap",),
                      ("warp",), ("blend",), ("studio",)):
            lines += command_lines(self.run_command(*words, "--help")[0])
        self.assertGreaterEqual(len(lines), 10)
        self.run_all(lines)


if __name__ == "__main__":
    support.main()
