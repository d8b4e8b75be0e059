# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of the studio's page, which are programs of Node.js.

Usage: studio_test.py types|parts|handles|inspection|page|picture|render|viewer|wall REPOSITORY BALCONY BUILD_SCENE
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

SKIPPED = 77

test, repository, balcony, build_scene = sys.argv[1:]
repository = Path(repository)
here = Path(__file__).resolve().parent
node = shutil.which("node")
browser = shutil.which("chromium") or shutil.which("chromium-browser")


def skip(what, remedy):
    print(f"skipped: {what}; {remedy} installs it")
    sys.exit(1 if os.environ.get("BALCONY_STUDIO") else SKIPPED)


if not node:
    skip("no Node.js", "scripts/setup studio")
if not (repository / "studio/node_modules/.package-lock.json").exists():
    skip("no packages of the page", "scripts/studio --setup")
if test not in ("types", "parts") and not browser:
    skip("no browser", "scripts/setup guides")
if test == "types":
    sys.exit(subprocess.run([node, repository / "studio/node_modules/typescript/bin/tsc", "--noEmit",
                             "--project", repository / "studio"]).returncode)
environment = dict(os.environ, BALCONY=balcony, BUILD_SCENE=build_scene, BROWSER=browser or "")
sys.exit(subprocess.run([node, "--test", here / f"{test}.test.mjs"], env=environment).returncode)
