# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Signals: the partial picture is saved, or the files are unchanged."""

import os
import pty
import resource
import signal
import time
from pathlib import Path

import support

# Would take minutes.
LONG = ("render", "scene.obj", "-c", "my.cam:above", "--size", "600x400", "-s", "1000000")


class Interruption(support.CommandTest):
    def start_long(self, *words, **how):
        """A render that traces rays already, however busy the machine is: reading the scene takes
        far less of a processor's time."""
        process = self.start(*LONG, *words, **how)
        self.wait_for_work(process, 3.0 if "BALCONY_SANITIZED" in os.environ else 0.7)
        return process

    def wait_for_work(self, process, wanted):
        """Until it has taken so many seconds of a processor."""
        while self.work_of(process) < wanted:
            time.sleep(0.1)
            self.assertIsNone(process.poll(), "it ended early")

    @staticmethod
    def work_of(process):
        """Seconds of a processor that it has taken."""
        fields = Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def end(self, process):
        """Seconds of a processor to the end, however busy the machine is, standard output and
        error."""
        work = self.work_of(process)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        out, err = process.communicate(timeout=60)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        whole = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return whole - work, out.decode(), err.decode()

    def test_saves_what_is_there(self):
        for which in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for ending in ("png", "exr"):
                process = self.start_long("-o", f"p.{ending}")
                process.send_signal(which)
                seconds, out, _ = self.end(process)
                self.assertEqual(process.returncode, 130)
                self.assertLess(seconds, 3.0)
                self.assertIn(f"interrupted; the partial picture is p.{ending}", out)
        self.assertEqual(support.png_pixels(self.folder / "p.png")[:2], (600, 400))
        self.assertGreater(support.opaque_share(self.folder / "p.png"), 0.2)
        self.assertEqual([name for name in self.files() if "partial" in name], [])

    def test_as_json(self):
        process = self.start_long("-o", "p.exr", "--json")
        process.send_signal(signal.SIGINT)
        _, out, _ = self.end(process)
        facts = support.json.loads(out)
        self.assertEqual((facts["interrupted"], facts["output"]), (True, "p.exr"))

    def test_before_anything_is_rendered(self):
        # A scene that takes seconds to read.
        (self.folder / "slow.obj").write_text(support.OBJ + "f 5 6 7\n" * 6_000_000)
        for which in (signal.SIGINT, signal.SIGTERM):
            process = self.start("render", "slow.obj", "-o", "p.exr", *LONG[-2:])
            self.wait_for_work(process, 0.5)
            process.send_signal(which)
            seconds, out, err = self.end(process)
            self.assertEqual(process.returncode, 130)
            self.assertEqual((out, err), ("", "error: interrupted\n"))
            self.assertLess(seconds, 1.0)
        self.assertNotIn("p.exr", self.files())

    def test_analysis_of_a_camera(self):
        (self.folder / "many.cam").write_text(
            "".join(f"camera a{i} {{ map u = -1 .. 1, v = square eye sphere({i + 1}) }}\n"
                    for i in range(2000))
        )
        # It takes seconds on a fast machine, too, before points are searched for. While sightings are
        # written to a pipe that nobody reads, a signal ends the command at once.
        (self.folder / "turned.cam").write_text(
            "camera turned { map u = -1 .. 1, v = square eye sphere(1)\n"
            "  move repeat(50, repeat(60, twist(z, 0.02deg))) }\n"
        )
        (self.folder / "points.csv").write_text("3,2,1\n" * 80_000)
        (self.folder / "p.png").write_bytes(b"old")
        for words in (
            ("check", "many.cam"),
            ("locate", "turned.cam", "--points", "points.csv"),
            ("draw", "fisheye", "-o", "p.png", "--size", "16384x16384"),
        ):
            for how in ([], ["--json"]):
                process = self.start(*words, *how)
                self.wait_for_work(process, 0.7)
                process.send_signal(signal.SIGINT)
                seconds, out, err = self.end(process)
                self.assertEqual(process.returncode, 130, words)
                self.assertIn("interrupted", out if how else err, words)
                # A tenth on an idle machine.
                self.assertLess(seconds, 1.0, words)
        self.assertEqual((self.folder / "p.png").read_bytes(), b"old")

    # A picture so large that its writing, which the first signal leads to, takes a while.
    def test_a_second_signal_ends_at_once(self):
        (self.folder / "p.png").write_bytes(b"old")
        process = self.start_long("-o", "p.png", "--size", "6000x3000")
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        seconds, out, _ = self.end(process)
        self.assertEqual(process.returncode, 130)
        self.assertLess(seconds, 1.0)
        self.assertEqual(out, "")
        self.assertEqual((self.folder / "p.png").read_bytes(), b"old")

    def test_killed(self):
        (self.folder / "p.exr").write_bytes(b"old")
        before = self.files()
        process = self.start_long("-o", "p.exr")
        process.kill()
        self.end(process)
        self.assertEqual((self.folder / "p.exr").read_bytes(), b"old")
        self.assertEqual(self.files(), before)

    def test_a_hang_up_that_is_ignored_stays_ignored(self):
        def ignore():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)

        process = self.start_long("-o", "p.exr", preexec_fn=ignore)
        process.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        self.end(process)
        self.assertEqual(process.returncode, 130)

    def test_leaves_a_clean_line_on_a_terminal(self):
        screen, terminal = pty.openpty()
        process = self.start_long("-o", "p.exr", stdout=terminal, stderr=terminal,
                                  env={**os.environ, "TERM": "xterm"})
        os.close(terminal)
        process.send_signal(signal.SIGINT)
        seen = b""
        try:
            while part := os.read(screen, 65536):
                seen += part
        except OSError:
            pass
        os.close(screen)
        self.assertEqual(process.wait(timeout=60), 130)
        self.assertRegex(seen.decode(), r"\r\x1b\[Kinterrupted; [^\r\n]*\r\n  lit by [^\r\n]*\r\n  --resume [^\r\n]*\r\n$")


if __name__ == "__main__":
    support.main()
