# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony render --watch: the picture follows the files that it is made of."""

import os
import queue
import signal
import threading
import time

import support

PATIENCE = 60  # Seconds; a loaded machine needs some.


class Watch(support.CommandTest):
    def watch(self, *words):
        """Begins to watch. What the command says is put into self.said, line by line."""
        process = self.start("render", "--size", "8x8", "-s", "1", *words, "-o", "p.png", "--watch")
        self.said = queue.Queue()
        for stream in (process.stdout, process.stderr):
            threading.Thread(target=lambda stream=stream: [self.said.put(line.decode())
                                                           for line in stream],
                             daemon=True).start()
        self.addCleanup(lambda: (process.kill(), process.wait(), process.stdout.close(),
                                 process.stderr.close()))
        return process

    def wait_for(self, *texts):
        """Waits for all texts, in any order, since they come from two streams."""
        end = time.monotonic() + PATIENCE
        missing = set(texts)
        seen = []
        while missing and time.monotonic() < end:
            try:
                seen.append(self.said.get(timeout=0.2))
            except queue.Empty:
                continue
            missing = {text for text in missing if text not in seen[-1]}
        self.assertFalse(missing, f"these are not said, but {seen}")

    def replace(self, name, text):
        """As editors save: the new file takes the place of the old one."""
        (self.folder / "new").write_text(text)
        os.replace(self.folder / "new", self.folder / name)

    def test_follows_the_environment(self):
        def environment(value):
            header = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n"
            (self.folder / "new").write_bytes(header + bytes([value, value, value, 128]) * 8)
            os.replace(self.folder / "new", self.folder / "sky.hdr")

        environment(100)
        process = self.watch("scene.obj", "--environment", "sky.hdr")
        self.wait_for("watching 2 files")
        environment(0)
        self.wait_for("'sky.hdr' is black", "watching")
        (self.folder / "new").write_text("no picture")
        os.replace(self.folder / "new", self.folder / "sky.hdr")
        self.wait_for("'sky.hdr' cannot be used", "watching")
        environment(50)
        self.wait_for("p.png", "watching")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=PATIENCE), 130)

    def test_follows_cameras_and_scenes(self):
        (self.folder / "more.cam").write_text(
            'import "my.cam"\ncamera mine { axes y_up map u = -1 .. 1, v = square\n'
            "eye surface(u, v) = [u, v, 5] toward surface(u, v) = [u, v, 0] look relative }\n")
        process = self.watch("scene.obj", "-c", "more.cam:above",
                             "--background", "transparent")
        self.wait_for("watching")
        before = support.opaque_share(self.folder / "p.png")

        # A file that the camera file imports.
        self.replace("my.cam", support.CAMERAS.replace("size = 3", "size = 0.5"))
        self.wait_for("watching")
        self.assertGreater(support.opaque_share(self.folder / "p.png"), before)

        # A mistake, and its correction.
        self.replace("my.cam", "camera above {")
        self.wait_for("error")
        self.wait_for("watching")
        self.replace("my.cam", support.CAMERAS)
        self.wait_for("p.png: 8 x 8 pixels", "watching")
        self.assertEqual(support.opaque_share(self.folder / "p.png"), before)

        # A scene that disappears, and comes back with less in it.
        os.remove(self.folder / "scene.obj")
        self.wait_for("there is no file 'scene.obj'")
        self.wait_for("watching")
        self.replace("scene.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n")
        self.wait_for("p.png: 8 x 8 pixels", "watching")
        self.assertLess(support.opaque_share(self.folder / "p.png"), before)

        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=PATIENCE), 130)

    def test_a_change_ends_a_render_that_is_of_no_use_any_more(self):
        process = self.watch("scene.obj", "-c", "my.cam:above", "-s", "1000000", "--size", "600x400")
        time.sleep(2.0)
        self.replace("my.cam", "camera above {")
        self.wait_for("error")
        self.assertNotIn("p.png", self.files())
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=PATIENCE), 130)

    def test_what_cannot_be_watched(self):
        self.refused("render", "scene.obj", "room.glb", "--watch", code=2, says="one scene")
        self.refused("render", "scene.obj", "--watch", "-o", "-", code=2, says="exclude each other")
        self.refused("render", "scene.obj", "--watch", "-o", "scene.obj", code=2,
                     says="not a picture format")


if __name__ == "__main__":
    support.main()
