# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs notebooks in a kernel of Python, as Jupyter does, and writes what their cells show into them.

Usage: run_notebooks.py NOTEBOOK...
"""

import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient


def run(file, folder):
    """The notebook with what its cells show when they are run in a folder."""
    notebook = nbformat.read(file, as_version=4)
    NotebookClient(notebook, timeout=600, kernel_name="python3", record_timing=False,
                   resources={"metadata": {"path": str(folder)}}).execute()
    # The kernel's own name and version are those of a machine.
    notebook.metadata = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
                         "language_info": {"name": "python"}}
    return notebook


def main():
    for file in map(Path, sys.argv[1:]):
        with tempfile.TemporaryDirectory() as folder:
            notebook = run(file, folder)
        file.write_text(nbformat.writes(notebook) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
