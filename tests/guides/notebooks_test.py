# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs the notebooks of examples/notebooks, and compares what they print with what stands in them."""

import json
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import guide

PYTHON = guide.python_with_balcony("numpy", "matplotlib", "PIL", "nbclient", "ipykernel", packages="build guides")
NOTEBOOKS = guide.REPOSITORY / "examples/notebooks"
RUN = Path(__file__).parent / "run_notebooks.py"


def shown(notebook):
    """For each cell of code, what it prints, and the kinds of what it shows."""
    told = []
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            outputs = cell["outputs"]
            told.append(("".join("".join(one["text"]) for one in outputs if "text" in one),
                         [sorted(one["data"]) for one in outputs if "data" in one]))
    return told


class Notebooks(unittest.TestCase):
    def compare(self, name):
        with tempfile.TemporaryDirectory() as folder:
            copy = shutil.copy(NOTEBOOKS / name, folder)
            done = subprocess.run([PYTHON, "-B", RUN, copy], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            written, made = (json.loads(Path(file).read_text(encoding="utf-8")) for file in (NOTEBOOKS / name, copy))
        self.assertEqual(shown(made), shown(written), "scripts/pictures --notebooks writes it anew")
        self.assertTrue(any("image/png" in kinds for _, all_kinds in shown(made) for kinds in all_kinds))


def test_of(name):
    return lambda self: self.compare(name)


for file in sorted(NOTEBOOKS.glob("*.ipynb")):
    setattr(Notebooks, f"test_{file.stem}", test_of(file.name))


class Pages(unittest.TestCase):
    def test_each_notebook_is_small_and_listed(self):
        page = guide.page_text("python.md")
        files = list(NOTEBOOKS.glob("*.ipynb"))
        self.assertGreaterEqual(len(files), 4)
        for file in files:
            self.assertLess(file.stat().st_size, 400_000, file.name)
            self.assertIn(f"../examples/notebooks/{file.name}", page)


if __name__ == "__main__":
    guide.main()
