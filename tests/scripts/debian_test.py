# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""debian/ agrees with scripts/packages.txt, NOTICE and the version of CMakeLists.txt."""

import re
import sys
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1)).resolve()


def text_of(name):
    return (REPOSITORY / name).read_text()


def section(name):
    """The packages of a section of scripts/packages.txt."""
    part = re.search(rf"^\[{name}\]\n(([a-z0-9].*\n)+)", text_of("scripts/packages.txt"), re.MULTILINE)
    return {line.split()[0] for line in part[1].splitlines()}


def field(name, paragraph):
    """The packages that a field of a paragraph of debian/control names."""
    text = text_of("debian/control").split("\n\n")[paragraph]
    words = re.search(rf"^{name}:((.|\n )*)$", text, re.MULTILINE)[1].split(",")
    return {word.split()[0] for word in words if word.split()}


# build-essential has the compiler; python3-dev has Python; the packages are built without tests.
NOT_IN_PACKAGES = {"g++", "python3", "libgtest-dev", "python3-numpy"}


class Debian(unittest.TestCase):
    def test_what_the_build_needs(self):
        self.assertEqual(field("Build-Depends", 0),
                         section("build") - NOT_IN_PACKAGES | {"debhelper-compat", "dh-sequence-python3"})

    def test_what_programs_need(self):
        # NOTICE says of the others that programs do not contain them.
        rows = re.findall(r" (lib\S+-dev|nlohmann\S+) (.*)", text_of("NOTICE"))
        needed = {package for package, licence in rows if not licence.endswith(")")}
        self.assertEqual(field("Depends", 2), needed | {"${misc:Depends}"})

    def test_version(self):
        version = re.search(r"^project\(balcony VERSION (\S+)", text_of("CMakeLists.txt"), re.MULTILINE)
        self.assertRegex(text_of("debian/changelog"), rf"^balcony \({re.escape(version[1])}\) ")


if __name__ == "__main__":
    unittest.main()
