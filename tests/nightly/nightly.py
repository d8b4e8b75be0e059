#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs the checks of checks.py that have no result for this commit, and prints the table of all.

scripts/nightly calls it; its help tells the options. A check runs in a process of its own, which is
ended with what it started when its time is over. build/nightly has, for each check, NAME.json with
the result and those of its parts, and NAME.log.
"""

import argparse
import datetime
import json
import os
import signal
import subprocess
import sys
import threading
import time
import traceback
from pathlib import Path

sys.dont_write_bytecode = True
REPOSITORY = Path(__file__).resolve().parents[2]
FOLDER = REPOSITORY / "build" / "nightly"

import checks  # noqa: E402


def commit():
    """The commit, and whether files differ from it."""
    git = ["git", "-C", str(REPOSITORY)]
    name = subprocess.run([*git, "rev-parse", "--short=8", "HEAD"], capture_output=True, text=True,
                          check=True).stdout.strip()
    changed = subprocess.run([*git, "status", "--porcelain"], capture_output=True, text=True,
                             check=True).stdout
    return name + ("+" if changed else "")


class Record:
    """What is known of a check for a commit: kept in a file after each part."""

    def __init__(self, name, at):
        self.file = FOLDER / f"{name}.json"
        self.lock = threading.Lock()
        try:
            self.facts = json.loads(self.file.read_text())
        except (OSError, ValueError):
            self.facts = {}
        if self.facts.get("commit") != at:
            self.facts = {"commit": at, "seconds": 0, "parts": {}}

    def write(self):
        new = self.file.with_suffix(".new")
        new.write_text(json.dumps(self.facts, indent=1))
        new.replace(self.file)

    def keep(self, part, make):
        """The result of make() for a part of the check, from an earlier run if there is one."""
        with self.lock:
            if part in self.facts["parts"]:
                return self.facts["parts"][part]
        made = make()
        with self.lock:
            self.facts["parts"][part] = made
            self.write()
        return made

    def end(self, result, says, seconds):
        self.facts.update(result=result, says=says, seconds=self.facts["seconds"] + round(seconds),
                          date=datetime.date.today().isoformat())
        self.write()


def run_here(check, at):
    """The check in this process; the exit code tells whether it passed."""
    record, began = Record(check.name, at), time.monotonic()
    try:
        result, says = "passed", check.run(record.keep)
    except checks.Failure as failure:
        result, says = "failed", str(failure)
    except Exception:  # A defect of the check itself.
        traceback.print_exc()
        result, says = "failed", "the check itself: see the log"
    record.end(result, says, time.monotonic() - began)
    return 0 if result == "passed" else 1


def run_apart(check, at):
    """The check in a process group of its own, for as long as it may take."""
    began = time.monotonic()
    with open(FOLDER / f"{check.name}.log", "ab") as log:
        process = subprocess.Popen([sys.executable, "-B", __file__, "--here", check.name, "--at", at],
                                   cwd=REPOSITORY, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                                   start_new_session=True)
        try:
            process.wait(timeout=60 * check.minutes)
        except BaseException as reason:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            if not isinstance(reason, subprocess.TimeoutExpired):
                raise
            record = Record(check.name, at)
            record.end("unfinished", f"{len(record.facts['parts'])} parts in {check.minutes} minutes",
                       time.monotonic() - began)


def table(chosen):
    rows = ["| check | what | result | figures | minutes | date | commit |", "|---|---|---|---|---|---|---|"]
    for check in chosen:
        try:
            facts = json.loads((FOLDER / f"{check.name}.json").read_text())
        except (OSError, ValueError):
            facts = {}
        minutes = f"{facts['seconds'] / 60:.1f}" if "result" in facts else ""
        rows.append(f"| {check.name} | {check.what} | {facts.get('result', 'not run')} | "
                    f"{facts.get('says', '')} | {minutes} | {facts.get('date', '')} | "
                    f"{facts['commit'] if 'result' in facts else ''} |")
    return "\n".join(rows)


def arguments():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--table", action="store_true")
    parser.add_argument("--here", action="store_true")
    parser.add_argument("--at")
    given = parser.parse_args()
    known = {check.name: check for check in checks.CHECKS}
    wrong = [name for name in given.names if name not in known]
    if wrong:
        parser.error(f"there is no check '{wrong[0]}': {', '.join(known)}")
    return given, [known[name] for name in given.names] or list(checks.CHECKS)


def main():
    given, chosen = arguments()
    FOLDER.mkdir(parents=True, exist_ok=True)
    if given.here:
        return run_here(chosen[0], given.at)
    if given.list:
        for check in chosen:
            print(f"{check.name:16} {check.what}, at most {check.minutes} minutes")
        return 0
    at = commit()
    stopped = False
    for check in () if given.table else chosen:
        # What a changed tree gave says nothing of its next state.
        if given.again or at.endswith("+"):
            (FOLDER / f"{check.name}.json").unlink(missing_ok=True)
        if Record(check.name, at).facts.get("result") in (None, "unfinished"):
            print(f"--- {check.name}: {check.what}", file=sys.stderr, flush=True)
            try:
                run_apart(check, at)
            except KeyboardInterrupt:
                stopped = True
                break
    print(table(chosen))
    if stopped:
        return 130
    return 0 if all(Record(one.name, at).facts.get("result") == "passed" for one in chosen) else 1


if __name__ == "__main__":
    sys.exit(main())
