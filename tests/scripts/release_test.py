# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""scripts/release in a small repository, with a stand-in for what builds."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from email.utils import parsedate_to_datetime
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1)).resolve()
PACKAGE = '#!/bin/sh\necho "package $@" >> build/package/done\nexit $PACKAGE\n'
NEWS = "# Changelog\n\n## Unreleased\n\n- News.\n"


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class Release(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="balcony-release-"))
        self.addCleanup(shutil.rmtree, self.folder)
        for name in ("scripts/common.sh", "scripts/release", "CMakeLists.txt", "debian/changelog",
                     "debian/control"):
            (self.folder / name).parent.mkdir(exist_ok=True)
            shutil.copy(REPOSITORY / name, self.folder / name)
        (self.folder / "scripts" / "package").write_text(PACKAGE)
        (self.folder / "scripts" / "package").chmod(0o755)
        for name in ("build/package", "packaging"):
            (self.folder / name).mkdir(parents=True)
        (self.folder / "CHANGELOG.md").write_text(NEWS)
        (self.folder / "packaging" / "recipe").write_text("version 0.1.0, not 0.1.01 or 001.0\n")
        (self.folder / "README.md").write_text("find_package(balcony 0.1 REQUIRED)\n")
        (self.folder / ".gitignore").write_text("/build/\n")
        self.git("init", "--quiet")
        self.commit()

    def git(self, *words):
        return subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@example.org", *words],
                              cwd=self.folder, check=True, capture_output=True, text=True).stdout

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message", "State")

    def release(self, version, code, says, package=0):
        environment = os.environ | {
            "PACKAGE": str(package), "GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@example.org",
            "GIT_COMMITTER_NAME": "b & c|d", "GIT_COMMITTER_EMAIL": "b@example.org"}
        run = subprocess.run([self.folder / "scripts" / "release", version], env=environment,
                             capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, code, run.stderr)
        self.assertIn(says, run.stdout + run.stderr)

    def news(self):
        path = self.folder / "CHANGELOG.md"
        path.write_text(path.read_text().replace("## Unreleased\n", "## Unreleased\n\n- More.\n", 1))
        self.commit()

    def test_versions(self):
        self.release("0.2.0", 0, "Version 0.2.0 is committed and tagged")
        self.assertEqual(self.git("status", "--porcelain"), "")
        self.assertEqual(self.git("tag", "--points-at", "HEAD"), "v0.2.0\n")
        steps = [f"package {step} {suite}\n" for suite in ("bookworm", "trixie")
                 for step in ("try", "deb", "reproduce", "try-deb", "wheel", "try-wheel")]
        self.assertEqual((self.folder / "build/package/done").read_text(), "package \n" + "".join(steps))
        for name, text in (("CMakeLists.txt", "project(balcony VERSION 0.2.0 LANGUAGES"),
                           ("debian/changelog", "balcony (0.2.0) unstable; "),
                           ("debian/changelog", "\n -- b & c|d <b@example.org>  "),
                           ("debian/control", "\nMaintainer: b & c|d <b@example.org>\n"),
                           ("packaging/recipe", "version 0.2.0, not 0.1.01 or 001.0"),
                           ("README.md", "find_package(balcony 0.2 REQUIRED)"),
                           ("CHANGELOG.md", "## Unreleased\n\n## 0.2.0 (2")):
            self.assertIn(text, (self.folder / name).read_text())
        made = re.search("^ -- .*>  (.*)", (self.folder / "debian/changelog").read_text(), re.MULTILINE)
        self.assertLess(abs(time.time() - parsedate_to_datetime(made[1]).timestamp()), 600)
        self.release("0.3.0", 1, "nothing under 'Unreleased'")
        self.news()
        for version in ("0.2.0", "0.1.9"):
            self.release(version, 1, "the last version is 0.2.0")
        self.release("0.2.1", 1, "nothing is tagged", package=1)
        self.assertEqual(self.git("tag"), "v0.2.0\n")
        self.git("reset", "--keep", "HEAD~1")
        self.release("0.10.0", 0, "tagged")

    def test_what_is_not_ready(self):
        for version in ("", "1.0", "v1.0.0", "1.0.00", "1.0.0-rc1"):
            self.release(version, 2, "MAJOR.MINOR.PATCH")
        (self.folder / "other").write_text("")
        self.release("1.0.0", 1, "commit all changes first")
        self.assertEqual(self.git("tag"), "")


if __name__ == "__main__":
    unittest.main()
