# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The extension for VS Code, as scripts/vscode makes it."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import guide

if not os.environ.get("BALCONY_STUDIO"):
    print("skipped: BALCONY_STUDIO=1 says that the registry of npm may be used")
    sys.exit(guide.SKIPPED)


class VsCode(unittest.TestCase):
    def test_the_extension_starts_the_command(self):
        subprocess.run([guide.REPOSITORY / "scripts/vscode"], check=True, capture_output=True)
        packed, = (guide.REPOSITORY / "build").glob("balcony-cameras-*.vsix")
        folder = Path(tempfile.mkdtemp(prefix="balcony-vscode-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        zipfile.ZipFile(packed).extractall(folder)
        extension = folder / "extension"
        manifest = json.loads((extension / "package.json").read_text())
        for grammar in manifest["contributes"]["grammars"]:
            self.assertTrue((extension / grammar["path"]).exists())
        self.assertIn("vscode-languageclient", (extension / "licences.txt").read_text())

        def told(command):
            return subprocess.run(
                ["node", Path(__file__).parent / "vscode_host.cjs", extension / manifest["main"],
                 command], check=True, capture_output=True, text=True, timeout=60).stdout
        self.assertEqual(told(guide.BALCONY), "activated\ndeactivated\n")
        self.assertIn("Install Balcony, or name its command in the setting", told("no-such-command"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
