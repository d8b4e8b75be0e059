# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs NAME_test.py with the module of a build.

Usage: run.py NAME FOLDER [CLASS[.TEST]...]
"""

import os
import sys
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "guides"))

import guide  # noqa: E402


def main():
    name, folder, *tests = sys.argv[1:]
    python = guide.python_with("numpy")
    if python is None:
        guide.skip("no Python has numpy", "build")
    environment = dict(os.environ, PYTHONPATH=f"{folder}:{HERE}")
    os.execve(python, [python, "-B", "-W", "error", "-m", "unittest",
                       *([f"{name}_test.{test}" for test in tests] or [f"{name}_test"])],
              environment)


if __name__ == "__main__":
    main()
