# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs a Python that has NumPy and finds the modules of some folders.

Usage: with_numpy.py FOLDER[:FOLDER...] ARGUMENT...
"""

import os
import sys

sys.dont_write_bytecode = True

import guide  # noqa: E402


def main():
    folders, *arguments = sys.argv[1:]
    python = guide.python_with("numpy")
    if python is None:
        guide.skip("no Python has numpy", "build")
    os.execve(python, [python, "-B", *arguments], dict(os.environ, PYTHONPATH=folders))


if __name__ == "__main__":
    main()
