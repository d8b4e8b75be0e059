# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The table of the nightly checks: a new one is a row."""

import os
from dataclasses import dataclass
from typing import Callable

from coverage import branches
from fuzzing import fuzzer
from mutants import mutation
from processes import kills, memory, valgrind
from tools import Failure, random_tests, run, suites  # noqa: F401


@dataclass(frozen=True)
class Check:
    """run(keep) returns the figures for the table or raises Failure. keep(part, make) is make(), whose
    result is stored: after an interruption, the parts that have one are not made again."""

    name: str
    what: str
    minutes: int  # The limit, with building.
    run: Callable


def plates(keep):
    run("scripts/plates", "--quality", "good")
    return "all plates"


# What starts threads: pictures, batches of points, maps of rays, searches for cameras, views.
THREADED = (r"^((app|dataset|live|python|render|solve)\.|analyse\.Locate$"
            r"|bridge\.([A-Za-z]*/)?(RayArrays|RayColumns|RayGrid|RayMap|RayStream|RoundTrip|StMap)"
            r"|cli\.(animate|check|checkpoint|dataset|interruption|shards|studio[a-z_]*|warp|watch)$)")

# Of each fuzzer: 60 for a thorough run, 5 for a look at all of them.
FUZZ_MINUTES = float(os.environ.get("BALCONY_FUZZ_MINUTES", 20))

CHECKS = (
    Check("asan", "all suites with AddressSanitizer and UndefinedBehaviorSanitizer", 720,
          suites("asan")),
    Check("tsan", "suites that start threads with ThreadSanitizer", 720, suites("tsan", THREADED)),
    *(Check(f"fuzz.{target}", f"{what}, fuzzed", 90, fuzzer(target, FUZZ_MINUTES)) for target, what in (
        ("camera", "camera files to compiled rays"), ("calibration", "calibrations to rays"),
        ("formula", "formulas through the simplifier and all runners"),
        ("map", "maps, images, tables and points of camera files"),
        ("marks", "files of marks to solved cameras"),
        ("prescription", "prescriptions of lenses to rays"),
        ("scene", "glTF, OBJ, PLY, STL and images"), ("sums", "checkpoints and shards"))),
    Check("mistakes", "each place of each camera file changed once", 240,
          random_tests("OneMistake", BALCONY_MISTAKES_EVERY=1)),
    Check("texts", "camera files changed at random", 240,
          random_tests("Mutation", BALCONY_FUZZ_TEXTS=1_000_000)),
    Check("plates", "the plates at good quality", 240, plates),
    *(Check(f"mutation.{layer}", f"mutants of src/{layer}, of which its tests kill 90 %", 480,
            mutation(layer, 30)) for layer in ("camera", "expr", "program", "rays", "lang")),
    Check("coverage", "branches that the tests take", 360, branches),
    Check("valgrind", "the first steps of the commands under valgrind", 60, valgrind),
    Check("memory", "a process that renders 1,000 pictures does not grow", 60, memory(1000)),
    Check("kills", "a render that is killed 500 times", 60, kills(500)),
)
