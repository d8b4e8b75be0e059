# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs layouts_test.py with a Python that has NumPy.

Usage: run.py BALCONY REPOSITORY [CLASS[.TEST]...]
"""

import os
import sys
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "guides"))

import guide  # noqa: E402


def main():
    balcony, repository, *tests = sys.argv[1:]
    python = guide.python_with("numpy")
    if python is None:
        guide.skip("no Python has numpy", "build")
    environment = dict(os.environ, PYTHONPATH=str(HERE.parent / "cli"))
    os.execve(python, [python, "-B", str(HERE / "layouts_test.py"), balcony, repository, *tests],
              environment)


if __name__ == "__main__":
    main()
