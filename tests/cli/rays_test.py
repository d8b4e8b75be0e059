# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony rays: the rays of a camera as streams and files."""

import ast
import math
import signal
import struct
import subprocess
import time

import support

# Larger than a pipe holds.
MANY = ("rays", "panorama", "--size", "400x200")


def npy(path):
    """Shape, type and numbers of an array."""
    data = path.read_bytes()
    assert data[:8] == b"\x93NUMPY\x01\x00", "no array of version 1"
    (length,) = struct.unpack_from("<H", data, 8)
    assert (10 + length) % 64 == 0, "the numbers are not aligned"
    header = ast.literal_eval(data[10:10 + length].decode())
    assert header["fortran_order"] is False
    body = data[10 + length:]
    kind = header["descr"]
    count = math.prod(header["shape"])
    assert len(body) == count * int(kind[2:]), "the file ends early or late"
    return header["shape"], kind, struct.unpack(f"<{count}{ {'<f4': 'f', '<f8': 'd'}[kind]}", body)


class Rays(support.CommandTest):
    def stream(self, *words):
        with self.start("rays", *words) as process:
            out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, err), (0, b""))
        return out

    def test_text_has_a_line_for_each_ray_from_the_top_left(self):
        lines = self.stream("pinhole", "--set", "fov=90deg", "--size", "4x2").decode().splitlines()
        self.assertEqual(len(lines), 8)
        rays = [[float(word) for word in line.split(" ")] for line in lines]
        x, y, z = 1.0, 0.75, 0.25  # The middle of the first pixel, left and above.
        length = math.sqrt(x * x + y * y + z * z)
        for got, wanted in zip(rays[0], (0, 0, 0, x / length, y / length, z / length), strict=True):
            self.assertAlmostEqual(got, wanted, 15)
        self.assertGreater(rays[0][4], rays[3][4], "y does not decrease along a row")
        self.assertAlmostEqual(rays[0][5], -rays[4][5], 15, "the second row is not below")

    def test_binary_streams_have_the_numbers_of_the_text(self):
        words = ("superelliptic", "--size", "150x70")
        text = [float(word) for word in self.stream(*words).split()]
        self.assertEqual(len(text), 6 * 150 * 70)
        doubles = struct.unpack(f"={len(text)}d", self.stream(*words, "--format", "double"))
        self.assertEqual(list(doubles), text)
        floats = struct.unpack(f"={len(text)}f", self.stream(*words, "--format", "float"))
        self.assertEqual(floats, struct.unpack(f"={len(text)}f",
                                               struct.pack(f"={len(text)}f", *text)))

    def test_no_ray_is_six_zeros(self):
        lines = self.stream("my.cam:half", "--size", "4x1").decode().splitlines()
        self.assertEqual(lines[:2], ["0 0 0 0 0 0"] * 2)
        self.assertNotIn("0 0 0 0 0 0", lines[2:])

    def test_arrays(self):
        document = self.json_of("rays", "my.cam:half", "--size", "6x3", "-o", "r.npy")
        self.assertEqual((document["output"], document["valid"], document["axes"]),
                         ("r.npy", 9, "y_up"))
        shape, kind, numbers = npy(self.folder / "r.npy")
        self.assertEqual((shape, kind), ((3, 6, len(document["columns"])), "<f8"))
        rows = [numbers[i:i + shape[2]] for i in range(0, len(numbers), shape[2])]
        self.assertEqual([row[6] for row in rows], [0, 0, 0, 1, 1, 1] * 3)
        stream = [float(word) for word in self.stream("my.cam:half", "--size", "6x3").split()]
        self.assertEqual([number for row in rows for number in row[:6]], stream)
        self.run_command("rays", "my.cam:half", "--size", "6x3", "-o", "f.NPY", "--format", "float",
                         "--footprints")
        shape, kind, numbers = npy(self.folder / "f.NPY")
        self.assertEqual((shape, kind), ((3, 6, 21), "<f4"))
        # The origin moves by 4/6 from pixel to pixel.
        self.assertAlmostEqual(numbers[21 * 5 + 9], 4 / 6, 6)

    def test_axes_and_time(self):
        (up,) = self.stream("pinhole", "--size", "1x1", "--set", "pitch=90deg").decode().splitlines()
        self.assertAlmostEqual(float(up.split(" ")[5]), 1)
        (up,) = self.stream("pinhole", "--size", "1x1", "--set", "pitch=90deg", "--axes",
                            "y_up").decode().splitlines()
        self.assertAlmostEqual(float(up.split(" ")[4]), 1)
        at_time = self.stream("pinhole", "--size", "1x1", "--set", "px=t", "--time", "7")
        self.assertTrue(at_time.startswith(b"7 0 0 "))

    def test_layers(self):
        (self.folder / "two.cam").write_text(
            support.CAMERAS + "picture both { layer above layer closeup { clip ellipse } }\n"
            "picture twins { layer above layer above }\n")
        self.refused("rays", "two.cam:both", code=1, says="has 2 camera layers",
                     helps="1 above, 2 closeup")
        self.refused("rays", "two.cam:both", "--layer", "close", code=1, says="no camera layer",
                     helps="closeup")
        self.refused("rays", "two.cam:twins", "--layer", "above", code=1, says="2 camera layers",
                     helps="number")
        size = ("--size", "40x20")
        by_name = self.stream("two.cam:both", "--layer", "closeup", *size)
        self.assertEqual(by_name, self.stream("two.cam:both", "--layer", "2", *size))
        self.assertTrue(by_name.startswith(b"0 0 0 0 0 0\n"), "it is clipped in the corner")

    def test_a_map_that_no_disk_holds(self):
        self.refused("rays", "my.cam:above", "--size", "1000000x1000000", "-o", "r.npy", code=1,
                     says="a map of 1000000 x 1000000 rays is too large")
        self.assertNotIn("r.npy", self.files())

    def test_the_reader_leaves(self):
        with self.start(*MANY) as process:
            process.stdout.readline()
            process.stdout.close()
            err = process.stderr.read().decode()
            self.assertEqual(process.wait(timeout=60), 3)
        self.assertIn("standard output took only", err)

    def test_a_full_disk(self):
        for words in (MANY, (*MANY, "--format", "double")):
            with open("/dev/full", "wb") as full:
                with self.start(*words, stdout=full) as process:
                    process.wait(timeout=60)
            self.assertEqual(process.returncode, 3)

    def test_a_file_limit(self):
        for name in ("r.exr", "r.npy"):
            script = f'ulimit -f 100; exec "$0" rays panorama --size 400x200 -o {name}'
            done = subprocess.run(["bash", "-c", script, support.BALCONY], cwd=self.folder,
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("cannot be written: File too large", done.stderr)
            self.assertEqual([one for one in self.files() if one.startswith("r.")], [])

    def test_interrupted(self):
        with self.start("rays", "panorama", "--size", "100000x50000", "-o", "r.npy") as process:
            time.sleep(1.0)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(timeout=60), 130)
        self.assertEqual([one for one in self.files() if one.startswith("r.")], [])

    def test_bad_usage(self):
        self.refused("rays", "pinhole", "-o", "r.png", code=2, says="r.png", helps=".exr or .npy")
        self.refused("rays", "pinhole", "-o", "r.exr", "--format", "double", code=2,
                     says="--format", helps=".npy")
        self.refused("rays", "pinhole", "-o", "r.npy", "--format", "text", code=2, says="--format")
        self.refused("rays", "pinhole", "--format", "binary", code=2, says="--format")
        self.refused("rays", "pinhole", "--footprints", code=2, says="footprints", helps="--output")
        self.refused("rays", "pinhole", "--axes", "up", code=2, says="--axes")
        self.refused("rays", "none.cam", code=1, says="none.cam")
        self.refused("rays", "pinhole", "-o", "none/r.exr", code=3, says="no folder 'none'")
        self.json_of("rays", "pinhole", code=2)


if __name__ == "__main__":
    support.main()
