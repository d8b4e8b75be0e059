# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Threads, signals, processes, memory and the end of the interpreter."""

import os
import resource
import signal
import subprocess
import sys
import threading
import time
import unittest
import weakref

import balcony
import numpy as np
from scene_files import AIMED, RoomTest

PROLOGUE = "import balcony, os, signal, sys, threading, time\n"


class Running(RoomTest):
    def script(self, text):
        """Another interpreter that runs a text; `room` is the file of a scene."""
        return subprocess.Popen([sys.executable, "-B", "-c", f"room = {str(self.room)!r}\n{PROLOGUE}{text}"],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def output_of(self, text, wanted=0):
        process = self.script(text)
        output, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, wanted, errors)
        return output

    def test_an_interrupt_stops_the_work(self):
        process = self.script("scene = balcony.load(room)\n"
                              "print('begins', flush=True)\n"
                              "try:\n"
                              "    scene.render('fisheye', size=(640, 480), samples=100000)\n"
                              "except KeyboardInterrupt:\n"
                              "    print('stopped', len(scene.render('fisheye', size=8, samples=1)['color']))\n")
        self.assertEqual(process.stdout.readline(), "begins\n")
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=120)
        self.assertTrue(output.startswith("stopped"), errors)

    def test_other_threads_run_meanwhile(self):
        scene = balcony.load(self.room)
        counted = 0
        done = threading.Event()

        def work():
            scene.render("fisheye", size=(320, 240), samples=8)
            done.set()

        thread = threading.Thread(target=work)
        thread.start()
        while not done.wait(0.001):
            counted += 1
        thread.join()
        self.assertGreater(counted, 10)

    def test_objects_may_be_used_by_several_threads(self):
        scene = balcony.load(self.room)
        cam = balcony.camera(AIMED)
        wanted = {fov: balcony.camera(AIMED, fov=fov).rays(64, 48).directions for fov in (1.0, 1.5)}
        failed = []

        def work(number):
            try:
                for i in range(20):
                    cam.fov = 1.0 if (i + number) % 2 else 1.5
                    found = cam.rays(64, 48).directions
                    if not any(np.array_equal(found, one) for one in wanted.values()):
                        failed.append("rays of neither value")
                    cam.project([[1, 0, 0]], size=(64, 48), scene=scene)
                scene.render(cam, size=(16, 8), samples=1)
            except Exception as error:  # noqa: BLE001
                failed.append(error)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failed, [])

    def test_a_forked_process_says_what_to_do(self):
        output = self.output_of("balcony.camera('pinhole').rays(8, 8)\n"
                                "if os.fork() == 0:\n"
                                "    try:\n"
                                "        balcony.camera('pinhole')\n"
                                "    except balcony.UsageError as error:\n"
                                "        print(error.remedy)\n"
                                "    sys.exit()\n"
                                "os.wait()\n")
        self.assertIn("spawn", output)

    def test_a_process_that_was_forked_before_works(self):
        self.assertEqual(self.output_of("if os.fork() == 0:\n"
                                        "    print(balcony.camera('pinhole').rays(8, 8).valid.all())\n"
                                        "    sys.exit()\n"
                                        "os.wait()\n"), "True\n")

    def test_the_end_of_the_interpreter_stops_the_work(self):
        began = time.monotonic()
        self.output_of("scene = balcony.load(room)\n"
                       "threading.Thread(target=lambda: scene.render('fisheye', size=(640, 480), samples=100000),\n"
                       "                 daemon=True).start()\n"
                       "time.sleep(0.5)\n")
        self.assertLess(time.monotonic() - began, 100)

    def test_a_camera_does_not_keep_a_scene(self):
        cam = balcony.camera("fisheye")
        scene = balcony.load(self.room)
        alive = weakref.ref(scene._scene)
        of_scene = cam.rays(8, 8, scene=scene, axes="z_up").origins
        del scene
        self.assertIsNone(alive())
        # Nor what it was asked with it: without one, it is not placed.
        self.assertFalse(np.array_equal(cam.rays(8, 8, axes="z_up").origins, of_scene))

    @unittest.skipIf("BALCONY_SANITIZED" in os.environ, "a sanitizer holds what is freed for a while")
    def test_what_is_let_go_is_freed(self):
        scene = balcony.load(self.room)

        def work():
            cam = balcony.camera("superelliptic")
            cam.rays(256, 256, footprints=True)
            cam.project([[1, 2, 3]], size=(64, 48))
            picture = scene.render(cam, size=(256, 256), samples=1)
            picture["color"], picture.pixels()
            with self.assertRaises(balcony.Error):
                cam.set(no_such=1)

        for _ in range(10):
            work()
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        for _ in range(60):
            work()
        # One run makes arrays of 22 MB, in all 1.3 GB. In kB:
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, 40_000)


if __name__ == "__main__":
    unittest.main()
