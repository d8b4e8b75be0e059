# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The share of branches that the tests take, by layer."""

import json

from tools import CORES, FOLDER, REPOSITORY, run


def branches(keep):
    """Of the branches in the code of each layer that are no exceptions'."""
    build = REPOSITORY / "build/coverage"
    run("cmake", "--preset", "dev", "-B", build, "-DBALCONY_BENCH=OFF", "-DBALCONY_UNITY=ON",
        "-DCMAKE_CXX_FLAGS=--coverage -fprofile-update=atomic")
    run("cmake", "--build", build, "-j", CORES)
    # A suite that the slow build makes too long counts for as far as it came.
    run("ctest", "--test-dir", build, "--parallel", CORES, allowed=(0, 8))
    report = FOLDER / "coverage.summary.json"
    run("gcovr", "--root", REPOSITORY, "--filter", "src/", "--filter", "include/", "--branches",
        "--exclude-throw-branches", "--exclude-unreachable-branches", "-j", CORES,
        "--json-summary", report, build)
    taken, all_ = {}, {}
    for file in json.loads(report.read_text())["files"]:
        parts = file["filename"].split("/")
        layer = parts[1] if parts[0] == "src" else "headers"
        taken[layer] = taken.get(layer, 0) + file["branch_covered"]
        all_[layer] = all_.get(layer, 0) + file["branch_total"]
    return ", ".join(f"{layer} {100 * taken[layer] / all_[layer]:.0f} %"
                     for layer in sorted(all_) if all_[layer] > 0)
