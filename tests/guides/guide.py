# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs a page of docs/ step by step: writes its files and runs its commands, in one folder."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BALCONY = Path(sys.argv[1]).resolve()
REPOSITORY = Path(sys.argv[2]).resolve()
SKIPPED = 77
# What stands for Python modules that are not installed.
STAND_INS = REPOSITORY / "tests" / "guides" / "gradients" / "stand_ins"

BLOCK = re.compile(r"^```(\w+)\n(.*?)^```", re.MULTILINE | re.DOTALL)
# The first line of a block that is a file: "# layers.py", "// walls.cam".
FILE_NAME = re.compile(r"(?:#|//) ([\w-]+\.\w+)\n")


def skip(what, packages="guides"):
    """Ends the test as skipped, or as failed where everything must be checked."""
    print(f"{what}; scripts/setup {packages} installs it")
    sys.exit(1 if os.environ.get("BALCONY_GUIDES") else SKIPPED)


def python_with(*modules):
    """The path of a Python that has some modules, or None: the one that runs this, or Debian's."""
    for python in (sys.executable, "/usr/bin/python3"):
        test = [python, "-c", "import " + ", ".join(modules)]
        if Path(python).exists() and subprocess.run(test, capture_output=True).returncode == 0:
            return python
    return None


def python_with_balcony(*modules, packages="build"):
    """A Python with these modules, which finds the one of the build. Without either, the test is skipped."""
    python = python_with(*modules)
    if python is None:
        skip(f"no Python has {' and '.join(modules)}", packages)
    module = BALCONY.parent / "python"
    if not module.exists() or os.environ.get("BALCONY_SANITIZED"):
        print("this build has no module of Python for an interpreter as it is")
        sys.exit(SKIPPED)
    os.environ["PYTHONPATH"] = str(module)
    return python


def run_line(line, folder, path):
    """What a command line prints; it must end with 0."""
    done = subprocess.run(["bash", "-c", line], cwd=folder, env=dict(os.environ, PATH=path),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{line}\nends with {done.returncode}:\n{done.stdout}")
    return done.stdout


def page_text(page):
    return (REPOSITORY / "docs" / page).read_text()


def run_page(page, folder, path, edit=lambda line: line):
    """Writes the files of a page and runs its commands, edited; returns what these print, by line."""
    outputs = {}
    for language, text in BLOCK.findall(page_text(page)):
        name = FILE_NAME.match(text)
        if language == "sh":
            for line in text.splitlines():
                outputs[line] = run_line(edit(line), folder, path)
        elif name:
            (folder / name[1]).write_text(text)
    return outputs


class GuideTest(unittest.TestCase):
    """The steps of PAGE, run once; `outputs` are what its commands print, by command line."""

    PAGE = ""
    PATH = os.environ["PATH"]
    EDIT = staticmethod(lambda line: line)  # What is run in the place of a command line.

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="balcony-guide-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.path = f"{BALCONY.parent}:{cls.PATH}"
        cls.prepare()
        cls.outputs = run_page(cls.PAGE, cls.folder, cls.path, cls.EDIT)

    @classmethod
    def prepare(cls):
        """Writes files that the page takes for granted."""

    def run_line(self, line):
        return run_line(line, self.folder, self.path)

    def output_of(self, beginning):
        """What the first command that begins with some words printed."""
        return next(text for line, text in self.outputs.items() if line.startswith(beginning))


def main():
    unittest.main(argv=sys.argv[:1], verbosity=2)


if __name__ == "__main__":
    # guide.py BALCONY REPOSITORY PAGE FOLDER: runs a page in a folder, for its pictures.
    run_page(sys.argv[3], Path(sys.argv[4]), f"{BALCONY.parent}:{os.environ['PATH']}")
