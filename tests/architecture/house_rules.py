#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Checks what every source file of ours keeps to.

Usage: house_rules.py REPOSITORY

Names on standard output each file that is over 500 lines long, does not open with the licence
header, holds a note of work left to do, or has a test that can be skipped in a suite with others:
ctest runs suites, and counts one as skipped only if all of it was; each file of tests without a
namespace of its own, as several are compiled as one; each picture of docs that is larger than 300 kB;
and each link of a page to a file that is not there. The exit code is 1 if there is any.
"""

import re
import sys
from pathlib import Path

FOLDERS = ("include", "src", "tests", "plates", "bench", "cmake", "scripts", "debian", "studio",
           ".ci")
CODE_SUFFIXES = {".cpp", ".hpp", ".h", ".inl", ".py", ".sh", ".ts", ".mjs"}
LONGEST_FILE = 500
LARGEST_PICTURE = 300_000
HEADER = ["Balcony: rendering through extended cameras.", "SPDX-License-Identifier: Apache-2.0"]
# Spelt in two halves, so that this file is clean.
WORK_LEFT = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")


TEST = re.compile(r"^TEST(?:_F|_P)?\((\w+), \w+\)")


def suites_that_hide_a_skip(lines):
    """The line numbers of tests that can be skipped and share their suite."""
    suites = [match[1] for line in lines if (match := TEST.match(line))]
    suite = None
    for number, line in enumerate(lines, 1):
        if match := TEST.match(line):
            suite = match[1]
        if "GTEST_SKIP" in line and suites.count(suite) > 1:
            yield number


def lacks_namespace(path, lines):
    opens = re.compile(rf"^namespace [\w:]+::{path.stem} {{$")
    return path.name.endswith("_test.cpp") and not any(opens.match(line) for line in lines)


LINK = re.compile(r"\]\((?!https?:)([^)#\s]+)(?:#[^)\s]*)?\)")


def broken_links(page):
    """The files that a page links to and that are not there."""
    for match in LINK.finditer(page.read_text(encoding="utf-8")):
        if not (page.parent / match[1]).exists():
            yield match[1]


def is_code(path, lines):
    return path.suffix in CODE_SUFFIXES or (bool(lines) and lines[0].startswith("#!"))


def findings(root):
    paths = [path for folder in FOLDERS for path in (root / folder).rglob("*")
             if path.is_file() and "node_modules" not in path.parts]
    for path in sorted(paths):
        try:
            lines = path.read_text(encoding="utf-8").splitlines()
        except UnicodeDecodeError:
            continue
        name = path.relative_to(root)
        for number, line in enumerate(lines, 1):
            if WORK_LEFT.search(line):
                yield f"{name}:{number}: work left to do: {line.strip()}"
        for number in suites_that_hide_a_skip(lines):
            yield f"{name}:{number}: a test that can be skipped needs a suite of its own"
        if lacks_namespace(path, lines):
            yield f"{name}: its tests need the namespace balcony::...::{path.stem}"
        if not is_code(path, lines):
            continue
        if len(lines) > LONGEST_FILE:
            yield f"{name}: {len(lines)} lines, more than {LONGEST_FILE}"
        opening = [re.sub(r"^(//|#) ?", "", line) for line in lines if not line.startswith("#!")]
        if opening[:2] != HEADER:
            yield f"{name}: does not open with the licence header"
    for path in sorted((root / "docs").rglob("*.png")):
        if path.stat().st_size > LARGEST_PICTURE:
            yield f"{path.relative_to(root)}: more than {LARGEST_PICTURE // 1000} kB"
    for page in [*root.glob("*.md"), *(root / "docs").rglob("*.md")]:
        for link in broken_links(page):
            yield f"{page.relative_to(root)}: a link to {link}, which is not there"


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    found = list(findings(Path(sys.argv[1]).resolve()))
    print("\n".join(found) if found else "all files keep the house rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
