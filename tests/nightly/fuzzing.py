# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The fuzzers, whose corpora are kept and minimised."""

import re

from tools import REPOSITORY, Failure, run


def fuzzer(target, minutes):
    """A check that runs a target of scripts/fuzz; the next run begins with what this one found."""

    def check(keep):
        def runs():
            said = run("scripts/fuzz", round(60 * minutes), target)
            found = re.search(r"number_of_executed_units: (\d+)", said)
            if not found:
                raise Failure("the fuzzer tells no number of runs")
            return int(found[1])

        executed = keep("runs", runs)
        run("scripts/fuzz", "minimise", target)
        kept = len(list((REPOSITORY / "build/fuzz/corpus" / target / "found").iterdir()))
        return f"{executed:,} runs in {minutes:g} minutes, {kept:,} inputs kept"

    return check
