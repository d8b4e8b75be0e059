#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Plants one fault at a time in a copy of the repository and sees the checks find it.

Usage: self_test.py REPOSITORY
"""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import architecture
import house_rules

REPOSITORY = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None
LICENCE = "".join(f"// {line}\n" for line in house_rules.HEADER)


class Planted(unittest.TestCase):
    """All tests share a copy; each takes away what it has planted."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = Path(folder.name).resolve()
        for part in ("src", "include", "tests/architecture"):
            shutil.copytree(REPOSITORY / part, cls.root / part)
        cls.before = {check: set(check.findings(cls.root)) for check in (architecture, house_rules)}

    def plant(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.exists():
            self.addCleanup(path.write_bytes, path.read_bytes())
        else:
            self.addCleanup(path.unlink)
        with path.open("a", encoding="utf-8") as file:
            file.write(text)

    def assert_found(self, check, name, text, *expected):
        self.plant(name, text)
        new = [finding for finding in check.findings(self.root)
               if finding not in self.before[check]]
        self.assertTrue(any(all(part in finding for part in expected) for finding in new), new)

    def test_finds_an_include_of_a_layer_above(self):
        self.plant("include/balcony/render.hpp", "")
        self.assert_found(architecture, "src/base/planted.cpp",
                          '#include "balcony/render.hpp"\n', "base may not use render")

    def test_finds_an_include_of_a_layer_beside(self):
        self.plant("include/balcony/scene.hpp", "")
        self.assert_found(architecture, "src/camera/objects/planted.cpp",
                          "  #  include <balcony/scene.hpp>\n", "camera may not use scene")

    def test_finds_a_private_header_of_a_layer_above(self):
        self.plant("src/render/planted.hpp", "")
        self.assert_found(architecture, "src/scene/planted.cpp",
                          '#include "../render/planted.hpp"\n', "scene may not use render")

    def test_finds_a_private_header_of_another_layer(self):
        self.plant("src/base/planted.hpp", "")
        self.assert_found(architecture, "src/scene/planted.cpp", '#include "base/planted.hpp"\n',
                          "src/scene/planted.cpp", "the private headers of base are its own")

    def test_finds_a_private_header_in_a_test_of_another_layer(self):
        self.plant("src/base/planted.hpp", "")
        self.assert_found(architecture, "tests/lang/planted.cpp", '#include "base/planted.hpp"\n',
                          "tests/lang/planted.cpp", "the private headers of base are its own")

    def test_allows_a_private_header_in_a_test_of_its_layer(self):
        self.plant("src/base/planted.hpp", "")
        self.plant("tests/base/planted.cpp", '#include "base/planted.hpp"\n')
        self.assertFalse([finding for finding in architecture.findings(self.root)
                          if "tests/base/planted.cpp" in finding])

    def test_allows_what_a_layer_may_use_through_another(self):
        self.plant("src/lang/planted.cpp", '#include "balcony/base.hpp"\n')
        self.assertFalse([finding for finding in architecture.findings(self.root)
                          if "src/lang/planted.cpp" in finding and "may not" in finding])

    def test_knows_whose_a_public_header_is(self):
        self.plant("include/balcony/picture.hpp", "")
        self.assert_found(architecture, "src/expr/planted.cpp",
                          '#include "balcony/picture.hpp"\n', "expr may not use camera")

    def test_finds_an_include_without_a_link(self):
        listing = self.root / "src/bridge/CMakeLists.txt"
        self.addCleanup(listing.write_bytes, listing.read_bytes())
        listing.write_text("balcony_layer(bridge SOURCES a.cpp USES camera)\n", encoding="utf-8")
        self.plant("include/balcony/program.hpp", "")
        self.assert_found(architecture, "src/bridge/planted.cpp",
                          '#include "balcony/program.hpp"\n', "does not link bridge to program")

    def test_finds_a_link_to_a_layer_above(self):
        self.assert_found(architecture, "src/scene/CMakeLists.txt",
                          "balcony_layer(more SOURCES more.cpp USES base camera PRIVATE fmt::fmt)\n",
                          "scene may not be linked to camera")

    def test_finds_a_link_beside_the_table_of_uses(self):
        self.assert_found(architecture, "src/expr/CMakeLists.txt",
                          "target_link_libraries(balcony_expr PRIVATE balcony::program)\n",
                          "expr may not be linked to program")

    def test_finds_files_that_include_each_other(self):
        self.plant("src/base/one.hpp", '#include "base/two.hpp"\n')
        self.plant("src/base/two.hpp", '#include "three.hpp"\n')
        self.assert_found(architecture, "src/base/three.hpp", '#include "one.hpp"\n',
                          "files include each other", "two.hpp > src/base/three.hpp")

    def test_finds_folders_that_include_each_other(self):
        self.plant("src/film/sums/planted.hpp", "")
        self.plant("src/film/files/planted.hpp", '#include "film/sums/planted.hpp"\n')
        self.assert_found(architecture, "src/film/sums/planted.cpp",
                          '#include "film/files/planted.hpp"\n', "folders include each other",
                          "film/files", "film/sums")

    def test_finds_a_header_beside_folders_that_includes_one_of_theirs(self):
        self.plant("src/film/files/planted.hpp", '#include "film/ground.hpp"\n')
        self.plant("src/film/top.hpp", '#include "film/files/planted.hpp"\n')
        self.assert_found(architecture, "src/film/ground.hpp", "",
                          "folders include each other", "src/film", "src/film/files")

    def test_finds_a_header_that_is_opened_without_need(self):
        self.plant("src/base/planted.hpp", "")
        self.assert_found(architecture, "tests/architecture/layers.txt",
                          "base/planted.hpp open to scene\n", "opens base/planted.hpp to scene")

    def test_allows_a_header_that_is_open(self):
        self.plant("src/base/planted.hpp", "")
        self.plant("tests/architecture/layers.txt", "base/planted.hpp open to scene\n")
        self.plant("src/scene/planted.cpp", '#include "base/planted.hpp"\n')
        self.assertFalse([finding for finding in architecture.findings(self.root)
                          if "planted" in finding])

    def test_finds_a_public_header_that_includes_a_private_one(self):
        self.plant("src/base/planted.hpp", "")
        self.assert_found(architecture, "include/balcony/base.hpp",
                          '#include "base/planted.hpp"\n', "may not include a private one")

    def test_finds_embree_outside_its_folder(self):
        self.assert_found(architecture, "src/render/planted.cpp", "#include <embree3/rtcore.h>\n",
                          "embree3/ belongs in src/render/embree")

    def test_allows_embree_in_its_folder(self):
        self.plant("src/render/embree/planted.cpp", "#include <embree3/rtcore.h>\n")
        self.assertFalse([finding for finding in architecture.findings(self.root)
                          if "render/embree/planted.cpp" in finding])

    def test_finds_an_unknown_layer(self):
        self.assert_found(architecture, "src/planted/planted.cpp", LICENCE, "no layer 'planted'")

    def test_finds_a_long_file(self):
        self.assert_found(house_rules, "src/base/planted.cpp", LICENCE + "\n" * 499, "501 lines")

    def test_finds_a_missing_licence_header(self):
        self.assert_found(house_rules, "src/base/planted.cpp", "int planted;\n", "licence header")

    def test_finds_a_skip_that_its_suite_hides(self):
        skipped = "TEST(Planted, MayBeSkipped) {\n    GTEST_SKIP();\n}\n"
        other = "TEST(Planted, Runs) {}\n"
        self.assert_found(
            house_rules, "tests/base/planted_test.cpp", LICENCE + skipped + other, "suite of its own"
        )

    def test_finds_tests_in_a_shared_namespace(self):
        tests = LICENCE + "namespace balcony {\nTEST(Planted, Runs) {}\n}  // namespace balcony\n"
        self.assert_found(house_rules, "tests/base/planted_test.cpp", tests, "::planted_test")

    def test_finds_a_large_picture(self):
        self.assert_found(house_rules, "docs/pictures/planted.png", "x" * 300_001, "300 kB")

    def test_finds_a_broken_link(self):
        self.plant("docs/there.md", "")
        text = "[a](there.md#a), [b](https://b.example), [c](../gone.md#c)\n"
        self.assert_found(house_rules, "docs/planted.md", text, "docs/planted.md", "../gone.md,")
        self.assertNotIn("there.md", "".join(house_rules.broken_links(self.root / "docs/planted.md")))

    def test_finds_work_left_to_do(self):
        self.assert_found(house_rules, "src/base/planted.cpp", LICENCE + "// TO" "DO: more\n",
                          "planted.cpp:3: work left to do")


if __name__ == "__main__":
    unittest.main()
