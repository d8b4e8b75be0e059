# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""What the checks share: commands, builds, suites of tests."""

import json
import os
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
FOLDER = REPOSITORY / "build" / "nightly"
CORES = os.cpu_count() or 1


class Failure(Exception):
    """A check found something; the text stands in the table, and the log tells more."""


def run(*words, allowed=(0,), **how):
    """The output of a command, which the log has, too."""
    print("+", *words, flush=True)
    done = subprocess.run([str(word) for word in words], cwd=how.pop("cwd", REPOSITORY), text=True,
                          errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **how)
    print(done.stdout, end="", flush=True)
    if done.returncode not in allowed:
        raise Failure(f"`{' '.join(map(str, words[:3]))}` ends with {done.returncode}")
    return done.stdout


def program(preset="ci", target="balcony"):
    """Builds targets of a preset and returns the folder of the build."""
    run("scripts/build", preset, target)
    return REPOSITORY / "build" / ("release" if preset == "ci" else preset)


def suites_of(folder, pattern):
    listed = subprocess.run(["ctest", "--test-dir", folder, "-R", pattern, "--show-only=json-v1"],
                            capture_output=True, text=True, check=True).stdout
    return [test["name"] for test in json.loads(listed)["tests"]]


def suites(preset, pattern="."):
    """A check that runs the suites whose names match, each a part."""

    def check(keep):
        folder = program(preset, "all")
        names = suites_of(folder, pattern)

        def passes(name):
            try:
                run("ctest", "--test-dir", folder, "-R", f"^{name}$", "--output-on-failure")
            except Failure:
                return False
            return True

        with ThreadPoolExecutor(CORES) as workers:
            passed = list(workers.map(lambda name: keep(name, lambda: passes(name)), names))
        failed = [name for name, good in zip(names, passed) if not good]
        if failed:
            raise Failure(f"{len(failed)} of {len(names)} suites: {', '.join(failed[:8])}")
        return f"{len(names)} suites"

    return check


def random_tests(suite, **environment):
    """A check that runs a random suite of lang_test for longer than its default."""

    def check(keep):
        folder = program(target="lang_test")
        run(folder / "tests/lang/lang_test", f"--gtest_filter={suite}.*",
            env={**os.environ, **{name: str(value) for name, value in environment.items()}})
        return ", ".join(f"{name}={value}" for name, value in environment.items())

    return check
