# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""packaging/make_wheel.py packs a folder as the format of wheels has it."""

import base64
import csv
import email
import hashlib
import importlib.metadata
import io
import os
import platform
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1)).resolve()
MODULE = "balcony/_balcony.cpython-311-x86_64-linux-gnu.so"
FILES = {"balcony/__init__.py": "answer = 42\n", MODULE: "a module", "balcony/lib/libz-balcony.so.1": "a library",
         "balcony-1.2.3.dist-info/licenses/LICENSE": "a licence"}


class Wheel(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_with(self, files, name="one", date=86400, numpy="numpy<2"):
        for file, text in files:
            path = self.folder / name / "stage" / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return subprocess.run([sys.executable, "-B", REPOSITORY / "packaging" / "make_wheel.py",
                               self.folder / name / "stage", "1.2.3", str(date), numpy],
                              capture_output=True, text=True, check=False)

    def wheel(self, files=tuple(FILES.items()), **options):
        run = self.run_with(files, **options)
        self.assertEqual(run.returncode, 0, run.stderr)
        return Path(run.stdout.strip())

    def test_name_and_tag_are_of_the_module_and_the_c_library(self):
        _, number = platform.libc_ver()
        tag = f"cp311-cp311-manylinux_{number.replace('.', '_')}_x86_64"
        wheel = self.wheel()
        self.assertEqual(wheel, self.folder / "one" / f"balcony-1.2.3-{tag}.whl")
        with zipfile.ZipFile(wheel) as archive:
            about = email.message_from_bytes(archive.read("balcony-1.2.3.dist-info/WHEEL"))
        self.assertEqual((about["Wheel-Version"], about["Root-Is-Purelib"], about.get_all("Tag")),
                         ("1.0", "false", [tag]))
        for other in ((), (("balcony/_balcony.so", ""),),
                      ((MODULE, ""), (MODULE.replace("311", "313"), ""))):
            run = self.run_with(other, name=f"other-{len(other)}")
            self.assertEqual((run.returncode, run.stdout), (1, ""))
            self.assertIn("one of C++ for CPython on Linux is needed", run.stderr)

    def test_the_record_has_each_file(self):
        with zipfile.ZipFile(self.wheel()) as archive:
            self.assertIsNone(archive.testzip())
            names = archive.namelist()
            self.assertEqual(set(names) - set(FILES), {
                f"balcony-1.2.3.dist-info/{name}" for name in ("METADATA", "WHEEL", "RECORD")})
            self.assertEqual(names[-1], "balcony-1.2.3.dist-info/RECORD")
            self.assertEqual(names[:-1], sorted(names[:-1], key=lambda name: (".dist-info/" in name, name)))
            rows = list(csv.reader(io.TextIOWrapper(archive.open(names[-1]))))
            self.assertEqual([row[0] for row in rows], names)
            self.assertEqual(rows[-1][1:], ["", ""])
            for name, digest, size in rows[:-1]:
                data = archive.read(name)
                sum_of_data = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode()
                self.assertEqual((digest, size), ("sha256=" + sum_of_data.rstrip("="), str(len(data))))
                if name in FILES:
                    self.assertEqual(data.decode(), FILES[name])

    def test_python_reads_it(self):
        unpacked = self.folder / "site"
        with zipfile.ZipFile(self.wheel()) as archive:
            archive.extractall(unpacked)
        found = list(importlib.metadata.distributions(path=[str(unpacked)]))
        self.assertEqual([one.metadata["Name"] for one in found], ["balcony"])
        self.assertEqual(found[0].version, "1.2.3")
        self.assertEqual(found[0].requires, ["numpy<2"])
        self.assertEqual(found[0].metadata["Requires-Python"], ">=3.11")
        self.assertIn("arrays of NumPy", found[0].metadata.get_payload())
        self.assertEqual({str(file) for file in found[0].files if file.hash},
                         {str(path.relative_to(unpacked)) for path in unpacked.rglob("*")
                          if path.is_file() and path.name != "RECORD"})

    def test_the_same_files_make_the_same_bytes(self):
        one = self.wheel()
        other = self.wheel(reversed(FILES.items()), name="other")
        for path in (self.folder / "other").rglob("*"):
            if path != other:
                os.utime(path, (10**9, 10**9))
                path.chmod(0o700)
        other = self.wheel((), name="other")
        self.assertEqual(one.read_bytes(), other.read_bytes())
        later = self.wheel((), name="other", date=1_800_000_000)
        # Files of zip are not older than 1980.
        for wheel, moment in ((one, (1980, 1, 1, 0, 0, 0)), (later, (2027, 1, 15, 8, 0, 0))):
            with zipfile.ZipFile(wheel) as archive:
                self.assertEqual({entry.date_time for entry in archive.infolist()}, {moment})


if __name__ == "__main__":
    unittest.main()
