# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The command as a process: its memory, what valgrind says of it, and that it may be killed."""

import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tools import REPOSITORY, Failure, program, run

sys.path.insert(0, str(REPOSITORY / "tests" / "cli"))
import support  # noqa: E402

MOVING = """camera moving {
    axes y_up
    map  u = -2 .. 2, v = square
    eye  surface(u, v) = [u + t/100, v, 5]
    toward surface(u, v) = [u + t/100, v, 0]
    look relative
}
"""


def folder():
    """A folder with a scene and cameras, which the caller closes."""
    made = tempfile.TemporaryDirectory(prefix="balcony-nightly-")
    place = Path(made.name)
    (place / "scene.obj").write_text(support.OBJ)
    (place / "my.cam").write_text(support.CAMERAS)
    (place / "moving.cam").write_text(MOVING)
    return made, place


def resident(process):
    """Bytes of memory that a process has."""
    try:
        status = Path(f"/proc/{process.pid}/status").read_text()
    except OSError:
        return 0
    return next((1024 * int(line.split()[1]) for line in status.splitlines()
                 if line.startswith("VmRSS:")), 0)


def memory(frames):
    """A check that a process that renders many pictures does not grow: from the first fifth of them
    to the end by less than 4 kB for each, the least that it would take to keep a page of memory."""

    def check(keep):
        balcony = program() / "balcony"
        made, place = folder()
        with made:
            words = [balcony, "animate", "scene.obj", "--camera", "moving.cam", "--frames",
                     f"1-{frames}", "--size", "64x48", "--samples", "2", "-q", "-o", "f.#####.exr"]
            process = subprocess.Popen(words, cwd=place)
            measured = []  # Pictures and bytes.
            while process.poll() is None:
                measured.append((len(list(place.glob("f.*.exr"))), resident(process)))
                time.sleep(0.05)
            done = len(list(place.glob("f.*.exr")))
        if process.returncode != 0 or done != frames:
            raise Failure(f"{done} pictures, exit code {process.returncode}")
        early = [size for count, size in measured if 0.1 * frames <= count < 0.2 * frames]
        late = [size for count, size in measured if count >= 0.9 * frames and size > 0]
        if not early or not late:
            raise Failure("too fast to be measured")
        growth = (max(late) - max(early)) / (0.8 * frames)
        says = f"{max(early) / 1e6:.1f} MB, {max(late) / 1e6:.1f} MB at the end"
        if growth > 4096:
            raise Failure(f"{says}: {growth:.0f} bytes for each of {frames} pictures")
        return f"{says} of {frames} pictures"

    return check


STARTS = (("--version",), ("list",), ("explain", "superelliptic"), ("check", "pinhole"),
          ("rays", "pinhole", "--size", "8x8", "-o", "rays.npy"),
          ("render", "scene.obj", "--camera", "my.cam:above", "--size", "8x8", "--samples", "1",
           "-o", "p.exr"))


def valgrind(keep):
    """No invalid access, no use of what was not initialised, and nothing lost."""
    balcony = program() / "balcony"
    made, place = folder()
    with made:
        for words in STARTS:
            run("valgrind", "--quiet", "--error-exitcode=99", "--leak-check=full",
                "--errors-for-leak-kinds=definite", "--show-leak-kinds=definite", balcony, *words,
                cwd=place)
    return f"{len(STARTS)} commands"


def kills(count):
    """A check that a render which is killed at random times ends with the picture of one that is
    not."""

    def check(keep):
        balcony = program() / "balcony"
        dice = random.Random(1)
        render = [balcony, "render", "scene.obj", "--camera", "my.cam:above", "--size", "200x150",
                  "--samples", "3000", "--integrator", "preview", "-q"]
        resumed = [*render, "--checkpoint-every", "0.05s", "--resume", "-o", "p.exr"]
        made, place = folder()
        with made:
            run(*render, "-o", "whole.exr", cwd=place)
            whole = (place / "whole.exr").read_bytes()

            def ends(code):
                if code != 0:
                    raise Failure(f"a continued render ends with {code}")
                if (place / "p.exr").read_bytes() != whole:
                    raise Failure("the picture is another one")
                (place / "p.exr").unlink()

            killed = continued = pictures = 0
            while killed < count:
                process = subprocess.Popen(resumed, cwd=place)
                try:
                    code = process.wait(timeout=dice.uniform(0.02, 0.8))
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
                    killed += 1
                    continued += (place / "p.exr.checkpoint").exists()
                    continue
                ends(code)
                pictures += 1
            ends(subprocess.run(resumed, cwd=place, check=False).returncode)
            left = sorted(file.name for file in place.glob("p.exr*"))
            if left:
                raise Failure(f"{', '.join(left)} is left")
            if continued < count / 4:
                raise Failure(f"only {continued} of {killed} kills left something to continue")
        return (f"{killed} kills, {continued} left something to continue; {pictures + 1} pictures equal "
                "to the bit")

    return check
