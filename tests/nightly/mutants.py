# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Mutants: single operators and constants of a layer, changed in a copy of the sources. Its tests
should notice. Which are tried depends on the seed and the sources alone."""

import hashlib
import itertools
import os
import random
import re
import subprocess
import threading
import tomllib
from collections import deque
from concurrent.futures import ThreadPoolExecutor

from tools import CORES, FOLDER, REPOSITORY, Failure, run

SEED = 1
NO_MISTAKES = REPOSITORY / "tests/nightly/no_mistakes.toml"
AIM = 0.9
# Whose stages the tests of these layers use, too.
ALSO_TESTED_BY = {"camera": ("rays", "cameras", "lang")}
OPERATORS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " < ": " <= ", " <= ": " < ",
             " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ", " && ": " || ",
             " || ": " && ", " += ": " -= ", " -= ": " += ", "++": "--", "std::min(": "std::max(",
             "std::max(": "std::min(", "true": "false", "false": "true"}
# A constant that is no part of a name, a type or another number.
CONSTANT = re.compile(r"(?<![\w.'])\d+(?:\.\d+)?(?![\w.'])")
OPERATOR = re.compile("|".join(re.escape(word) if not word.isalpha() else rf"\b{word}\b"
                               for word in sorted(OPERATORS, key=len, reverse=True)))
# What is no code, or is none that runs.
PASSED_OVER = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'
                         r"'(?:\\.|[^'\\\n])'|^[ \t]*#[^\n]*|\bstatic_assert\([^;]*;|template <[^\n]*",
                         re.DOTALL | re.MULTILINE)


def changed(constant):
    return "1" + constant[1:] if constant in ("0", "0.0") else str(
        float(constant) + 1 if "." in constant else int(constant) + 1)


def mutants_of(layer):
    """All as (file, offset, before, after), in the order of files and offsets."""
    for path in sorted((REPOSITORY / "src" / layer).rglob("*.[ch]pp")):
        text = path.read_text()
        code = PASSED_OVER.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
        name = str(path.relative_to(REPOSITORY))
        for match in OPERATOR.finditer(code):
            yield name, match.start(), match[0], OPERATORS[match[0]]
        for match in CONSTANT.finditer(code):
            yield name, match.start(), match[0], changed(match[0])


class TestProgram:
    """That of a layer, in a build of a copy."""

    def __init__(self, tree, layer):
        self.tree = tree
        self.target = f"{layer}_test"
        self.file = tree / "build/mutants/tests" / layer / self.target
        if not self.builds():
            raise Failure("the tests do not build")
        began = os.times().elapsed
        if not self.passes(3600):
            raise Failure("the tests fail without a mutant")
        self.limit = 10 + 10 * (os.times().elapsed - began)

    def builds(self):
        return subprocess.run(["cmake", "--build", "build/mutants", "-j", str(CORES), "--target",
                               self.target], cwd=self.tree, stdout=subprocess.DEVNULL,
                              check=False).returncode == 0

    def fingerprint(self):
        return hashlib.sha256(self.file.read_bytes()).hexdigest()

    def passes(self, limit):
        try:
            return subprocess.run(["prlimit", "--as=8000000000", self.file, "--gtest_brief=1",
                                   "--gtest_fail_fast"], cwd=self.tree,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  timeout=limit, check=False).returncode == 0
        except subprocess.TimeoutExpired:
            return False


class Copy:
    """A work tree of this commit, of some, with its own build of the tests of a layer."""

    def __init__(self, layer, index):
        self.tree = FOLDER / f"mutants-{index}"
        if not self.tree.exists():
            run("git", "worktree", "prune")
            run("git", "worktree", "add", "--detach", self.tree, "HEAD")
        run("git", "checkout", "--force", "--detach",
            run("git", "rev-parse", "HEAD").strip(), cwd=self.tree)
        # A mutant may leave a name unused, and is one file, which is compiled by itself. One that
        # goes beyond the end of a list is noticed.
        run("cmake", "--preset", "ci", "-B", "build/mutants", "-DBALCONY_WERROR=OFF",
            "-DBALCONY_BENCH=OFF", "-DBALCONY_UNITY=OFF",
            "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG -D_GLIBCXX_ASSERTIONS", cwd=self.tree)
        self.own, *self.others = (TestProgram(self.tree, one)
                                  for one in (layer, *ALSO_TESTED_BY.get(layer, ())))
        self.content = self.own.fingerprint()

    def fate(self, mutant):
        """killed, survived, or equal: it does not compile, or to the same program."""
        name, offset, before, after = mutant
        path = self.tree / name
        text = path.read_text()
        path.write_text(text[:offset] + after + text[offset + len(before):])
        try:
            if not self.own.builds() or self.own.fingerprint() == self.content:
                return "equal"
            survives = self.own.passes(self.own.limit) and all(
                other.builds() and other.passes(other.limit) for other in self.others)
            return "survived" if survives else "killed"
        finally:
            path.write_text(text)


def mutated_line(mutant):
    name, offset, before, after = mutant
    text = (REPOSITORY / name).read_text()
    begin = text.rfind("\n", 0, offset) + 1
    return (text[begin:offset] + after + text[offset + len(before):].split("\n", 1)[0]).strip()


def no_mistakes(layer, mutants):
    """Those that no test needs to notice, as a file says with the reasons."""
    by_line = {}
    for mutant in sorted(mutants):
        by_line.setdefault((mutant[0], mutated_line(mutant)), []).append(mutant)
    found = set()
    for one in tomllib.loads(NO_MISTAKES.read_text())["mutant"]:
        if one["file"].startswith(f"src/{layer}/"):
            alike = by_line.get((one["file"], one["line"]), [])
            if len(alike) != one.get("alike", 1):
                raise Failure(f"{NO_MISTAKES.name}: there are {len(alike)} mutants {one['line']}")
            found.add(alike[one.get("nth", 1) - 1])
    return found


def place(mutant):
    name, offset, before, after = mutant
    line = (REPOSITORY / name).read_text()[:offset].count("\n") + 1
    return f"{name}:{line}: {before.strip()} becomes {after.strip()}"


class Copies:
    """A copy for each thread that asks for the fate of a mutant."""

    def __init__(self, layer):
        self.layer = layer
        self.index = itertools.count()
        self.making = threading.Lock()
        self.mine = threading.local()

    def fate(self, mutant):
        if not hasattr(self.mine, "copy"):
            with self.making:
                self.mine.copy = Copy(self.layer, next(self.index))
        return self.mine.copy.fate(mutant)


def in_order(make, given):
    """Pairs of what is given and what is made of it, by several threads, a few ahead."""
    given = iter(given)
    with ThreadPoolExecutor(CORES) as workers:
        ahead = deque((one, workers.submit(make, one)) for one in itertools.islice(given, CORES))
        while ahead:
            one, made = ahead.popleft()
            yield one, made.result()
            ahead.extend((next_, workers.submit(make, next_)) for next_ in itertools.islice(given, 1))


def mutation(layer, count):
    """A check that tries so many mutants of a layer; each is a part."""

    def check(keep):
        order = list(mutants_of(layer))
        random.Random(SEED).shuffle(order)
        harmless = no_mistakes(layer, order)
        order = [mutant for mutant in order if mutant not in harmless]
        copies = Copies(layer)

        def fate(mutant):
            # Several mutants of a line may read alike.
            return keep(f"{place(mutant)} ({mutant[1]})", lambda: copies.fate(mutant))

        tried = []
        for mutant, its_fate in in_order(fate, order):
            if its_fate != "equal":
                tried.append((mutant, its_fate))
            if len(tried) == count:
                break
        survivors = [place(mutant) for mutant, its_fate in tried if its_fate == "survived"]
        print(*survivors, sep="\n")
        says = f"{len(tried) - len(survivors)} of {len(tried)} killed"
        if len(tried) - len(survivors) < AIM * len(tried):
            raise Failure(says)
        return says

    return check
