# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""packaging/list_contents.py prints an SPDX document of what travels with a program."""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1)).resolve()


class Contents(unittest.TestCase):
    def run_with(self, *libraries):
        return subprocess.run([sys.executable, "-B", REPOSITORY / "packaging" / "list_contents.py",
                               "1.2.3", "86400", *libraries],
                              capture_output=True, text=True, check=False)

    def setUp(self):
        linked = subprocess.run(["ldd", "/bin/sh"], capture_output=True, text=True, check=True)
        run = self.run_with(*re.findall(r"=> (/\S+)", linked.stdout))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.document = json.loads(run.stdout)
        self.packages = {part["name"]: part for part in self.document["packages"]}

    def test_what_notice_names_is_listed(self):
        rows = re.findall(r" ([a-z0-9-]+-dev) .*?(?:\(([\w ]+) only\))?$",
                          (REPOSITORY / "NOTICE").read_text(), re.MULTILINE)
        of_module = json.loads(self.run_with("--python").stdout)["packages"]
        for part, packages in (("the command", self.document["packages"]),
                               ("the module of Python", of_module)):
            listed = {package["name"]: package["licenseDeclared"] for package in packages
                      if package["licenseDeclared"] != "NOASSERTION"}
            self.assertEqual(set(listed), {"balcony"} | {name for name, of in rows if of in ("", part)})
            for licence in listed.values():
                self.assertRegex(licence, r"^[A-Za-z][A-Za-z0-9.-]+( AND [A-Z][A-Za-z0-9.-]+)*$")
        self.assertEqual(self.packages["libopenimageio-dev"]["licenseDeclared"],
                         "BSD-3-Clause AND Apache-2.0")
        self.assertEqual(self.packages["libturbojpeg0-dev"]["licenseDeclared"], "IJG AND BSD-3-Clause")
        self.assertEqual(self.packages["libfmt-dev"]["licenseDeclared"], "MIT")

    def test_packages_of_libraries_are_listed(self):
        libc = self.packages["libc6"]
        self.assertRegex(libc["versionInfo"], r"^2\.\d+")
        self.assertEqual(libc["licenseDeclared"], "NOASSERTION")
        self.assertRegex(libc["downloadLocation"], r"/glibc/2\.\d+\S*/$")

    def test_packages_of_the_page_are_listed(self):
        with tempfile.NamedTemporaryFile("w") as file:
            file.write("The page contains these.\n\n---\n\n@codemirror/view 6.43.15: MIT\n\nMIT License\n"
                       "\nYear 2018: all rights\n\n---\n\nlit 3.3.3: BSD-3-Clause\n\nBSD 3 Clause\n")
            file.flush()
            run = self.run_with("--page", file.name)
        parts = [part for part in json.loads(run.stdout)["packages"]
                 if part["SPDXID"].startswith("SPDXRef-npm")]
        self.assertEqual([(part["name"], part["versionInfo"], part["licenseDeclared"],
                           part["downloadLocation"]) for part in parts],
                         [("@codemirror/view", "6.43.15", "MIT",
                           "https://registry.npmjs.org/@codemirror/view/-/view-6.43.15.tgz"),
                          ("lit", "3.3.3", "BSD-3-Clause",
                           "https://registry.npmjs.org/lit/-/lit-3.3.3.tgz")])

    def test_a_library_of_no_package(self):
        run = self.run_with(__file__)
        self.assertEqual((run.returncode, run.stdout), (1, ""))
        self.assertIn("contents_test.py belongs to no Debian package", run.stderr)

    def test_form(self):
        names = [part["SPDXID"] for part in self.document["packages"]]
        self.assertEqual(len(names), len(set(names)))
        for name in names:
            self.assertRegex(name, r"^SPDXRef-[A-Za-z0-9.-]+$")
        for relation in self.document["relationships"]:
            self.assertIn(relation["relatedSpdxElement"], names)
        self.assertEqual(self.document["creationInfo"]["created"], "1970-01-02T00:00:00Z")
        self.assertEqual(self.packages["balcony"]["versionInfo"], "1.2.3")


if __name__ == "__main__":
    unittest.main()
