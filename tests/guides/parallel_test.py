# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs the lines of docs/farm.md with GNU parallel, on this machine."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import guide

if shutil.which("parallel") is None:
    guide.skip("GNU parallel is not installed")


class Parallel(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="balcony-parallel-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "room.obj").write_text("v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n")
        (self.folder / "my.cam").write_text(
            "camera c {\n    axes y_up\n    map u = -1 .. 1, v = square\n"
            "    eye surface(u, v) = [u + t, v, 5]\n    toward surface(u, v) = [u + t, v, 0]\n"
            "    look relative\n}\n")
        path = self.folder / "bin"
        path.mkdir()
        (path / "balcony").symlink_to(guide.BALCONY)
        self.path = f"{path}:{os.environ['PATH']}"

    def lines(self):
        """The commands of the section, on this machine, for a small picture and few frames."""
        section = guide.page_text("farm.md").split("## GNU parallel")[1].split("\n## ")[0]
        text = "".join(re.findall(r"^```\n(.*?)^```", section, re.MULTILINE | re.DOTALL))
        text = text.replace("\\\n", " ").replace("--sshlogin alpha,beta,gamma --workdir .", "")
        text = text.replace("room.glb", "room.obj --size 150x70 --ambient 0.5")
        text = text.replace("-s 256", "-s 2").replace("1-240", "1-6").replace("{1..30}", "{1..3}")
        return [line.strip() for line in text.replace("/30", "/3").splitlines() if line.strip()]

    def test_the_lines_of_the_page(self):
        lines = self.lines()
        self.assertEqual(sum("parallel" in line for line in lines), 2)
        for line in lines:
            guide.run_line(line, self.folder, self.path)
        whole = re.search(r"balcony render .*", lines[0])[0]
        whole = re.sub(r"--resume|--shard \S+|::: .*", "", whole).replace("room.exr", "whole.exr")
        guide.run_line(whole, self.folder, self.path)
        self.assertEqual((self.folder / "room.exr").read_bytes(),
                         (self.folder / "whole.exr").read_bytes())
        self.assertTrue((self.folder / "room.mp4").exists())


if __name__ == "__main__":
    if shutil.which("ffmpeg") is None:
        guide.skip("ffmpeg is not installed")
    result = unittest.main(argv=["parallel_test.py"], verbosity=2, exit=False).result
    raise SystemExit(0 if result.wasSuccessful() else 1)
