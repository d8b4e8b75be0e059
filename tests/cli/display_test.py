# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony render --display: the picture so far, in a program that takes tev's messages."""

import signal
import socket
import struct
import threading

import support

CREATE, UPDATE = 4, 6


def srgb(light):
    light = min(max(light, 0.0), 1.0)
    return 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055


class Viewer(threading.Thread):
    """What tev does with the messages of one connection."""

    def __init__(self, most_messages=None):
        super().__init__(daemon=True)
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.address = "127.0.0.1:%d" % self.socket.getsockname()[1]
        self.most = most_messages
        self.pictures = {}  # Name: width, height, values by (x, y, channel).
        self.updates = 0
        self.updated = threading.Condition()
        self.start()

    def has_updates(self, count):
        """False if they do not come."""
        with self.updated:
            return self.updated.wait_for(lambda: self.updates >= count, timeout=120)

    def read(self, form):
        values = struct.unpack_from("<" + form, self.message, self.at)
        self.at += struct.calcsize("<" + form)
        return values if len(values) > 1 else values[0]

    def text(self):
        end = self.message.index(0, self.at)
        found = self.message[self.at:end].decode()
        self.at = end + 1
        return found

    def take(self, message):
        self.message, self.at = message, 0
        length, kind, focus = self.read("IBB")
        assert (length, focus) == (len(message), 0)
        name = self.text()
        if kind == CREATE:
            width, height, count = self.read("iii")
            assert [self.text() for _ in range(count)] == ["R", "G", "B", "A"]
            self.pictures[name] = (width, height, {})
            return
        assert kind == UPDATE, kind
        count = self.read("i")
        assert [self.text() for _ in range(count)] == ["R", "G", "B", "A"]
        left, top, width, height = self.read("iiii")
        offsets, strides = self.read("4q"), self.read("4q")
        data = self.read("%df" % (width * height * 4))
        values = self.pictures[name][2]
        for i in range(width * height):
            for c in range(4):
                values[left + i % width, top + i // width, c] = data[offsets[c] + i * strides[c]]
        with self.updated:
            self.updates += 1
            self.updated.notify_all()

    def run(self):
        with self.socket:
            connection, _ = self.socket.accept()
        taken = 0
        with connection, connection.makefile("rb") as stream:
            while self.most is None or taken < self.most:
                head = stream.read(4)
                if len(head) < 4:
                    return
                self.take(head + stream.read(struct.unpack("<I", head)[0] - 4))
                taken += 1


class Display(support.CommandTest):
    def test_shows_the_picture_of_the_file(self):
        viewer = Viewer()
        self.run_command("render", "scene.obj", "--size", "40x30", "-s", "2", "--exposure", "0",
                         "--no-dither", "--view-transform", "standard", "--display", viewer.address,
                         "-o", "p.png")
        viewer.join(30)
        self.assertFalse(viewer.is_alive())
        width, height, values = viewer.pictures["p.png"]
        self.assertEqual((width, height), (40, 30))
        self.assertEqual(len(values), 40 * 30 * 4)
        _, _, rows = support.png_pixels(self.folder / "p.png")
        self.assertGreater(max(pixel[1] for row in rows for pixel in row), 0)
        for y, row in enumerate(rows):
            for x, pixel in enumerate(row):
                self.assertEqual(round(255 * values[x, y, 3]), pixel[3])
                if pixel[3] == 255:
                    self.assertAlmostEqual(255 * srgb(values[x, y, 1]), pixel[1], delta=0.51)

    def test_shows_a_part_in_its_place(self):
        viewer = Viewer()
        self.run_command("render", "scene.obj", "--size", "40x30", "-s", "1", "--crop",
                         "10x5+20+15", "--display", viewer.address, "-o", "part.exr")
        viewer.join(30)
        width, height, values = viewer.pictures["part.exr"]
        self.assertEqual((width, height), (40, 30))
        self.assertEqual({(x, y) for x, y, _ in values},
                         {(x, y) for x in range(20, 30) for y in range(15, 20)})

    def start_long_render(self, viewer):
        process = self.start("render", "scene.obj", "--size", "60x40", "-s", "1000000", "--display",
                             viewer.address, "-o", "p.exr")
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def end(self, process):
        """Its messages after the interruption."""
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130)
        self.assertIn("p.exr", self.files())
        return err.decode()

    def test_follows_a_long_render(self):
        viewer = Viewer()
        process = self.start_long_render(viewer)
        self.assertTrue(viewer.has_updates(3))
        self.end(process)
        viewer.join(30)
        self.assertFalse(viewer.is_alive())

    def test_renders_without_a_viewer(self):
        with socket.create_server(("127.0.0.1", 0)) as closed:
            port = closed.getsockname()[1]
        _, err = self.run_command("render", "scene.obj", "--size", "8", "-s", "1", "--display",
                                  f"127.0.0.1:{port}", "-o", "p.exr")
        self.assertIn(f"no program shows pictures at 127.0.0.1:{port}", err)
        self.assertIn("start tev", err)
        self.assertIn("p.exr", self.files())

    def test_goes_on_after_a_viewer_ends(self):
        process = self.start_long_render(Viewer(most_messages=1))
        said = b""
        while b"does not take it any more" not in said:
            line = process.stderr.readline()
            self.assertNotEqual(line, b"", said)
            said += line
        self.assertNotIn("does not take it any more", self.end(process))

    def test_refuses_what_is_no_address(self):
        for text in ("localhost", ":14158", "localhost:0", "localhost:70000", "localhost:port"):
            _, err = self.run_command("render", "scene.obj", "--display", text, "-o", "p.exr",
                                      code=2)
            self.assertIn("such as localhost:14158", err)


if __name__ == "__main__":
    support.main()
