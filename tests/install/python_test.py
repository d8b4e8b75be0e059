# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Installs the module of Python from a build into a folder, where it is complete.

Usage: python_test.py BUILD REPOSITORY CMAKE
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CMAKE = sys.argv.pop(3)
BUILD = Path(sys.argv[1]).resolve()
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "guides"))

import guide  # noqa: E402

PYTHON = guide.python_with("numpy")


class InstalledModule(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        subprocess.run([CMAKE, "--install", BUILD, "--component", "python", "--prefix", self.folder],
                       check=True, capture_output=True)

    def run_test_of_packages(self, *options):
        run = subprocess.run([PYTHON, "-B", guide.REPOSITORY / "debian" / "tests" / "python", *options],
                             env=dict(os.environ, PYTHONPATH=str(self.folder)), cwd=self.folder,
                             capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertIn(f" in {self.folder}/balcony, ", run.stdout)

    def test_it_is_complete(self):
        files = {path.name for path in (self.folder / "balcony").iterdir()}
        modules = {name for name in files if name.endswith(".so")}
        self.assertEqual({name.split("-")[0].split(".")[0] for name in modules},
                         {"_balcony", "balcony_images", "balcony_proj"})
        sources = {path.name for path in (guide.REPOSITORY / "python" / "balcony").iterdir()}
        self.assertEqual(files - modules, sources - {"__pycache__"})
        self.assertEqual([path.name for path in self.folder.iterdir()], ["balcony"])
        self.run_test_of_packages()

    def test_without_the_module_for_images(self):
        for module in (self.folder / "balcony").glob("balcony_images-*.so"):
            module.unlink()
        self.run_test_of_packages("--without-images")


if __name__ == "__main__":
    if PYTHON is None:
        guide.skip("no Python has numpy", "build")
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
