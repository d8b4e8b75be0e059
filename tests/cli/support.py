# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Common parts of the tests of the command: a folder with a small scene, and runs of the command."""

import base64
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

BALCONY = ""
REPOSITORY = Path()

OBJ = """o wall
v -2 -1 -1
v 2 -1 -1
v 2 1 -1
v -2 1 -1
f 1 2 3 4
o tip
v -1 -1 0
v 1 -1 0
v 0 1 0
f 5 6 7
"""

CAMERAS = """// Looks down along z from above.
camera above(size = 3) {
    axes y_up
    map  u = -size .. size, v = square
    eye  surface(u, v) = [u, v, 5]
    toward surface(u, v) = [u, v, 0]
    look relative
}

// Has no ray left of the middle.
camera half {
    axes y_up
    map  u = -2 .. 2, v = square
    eye  surface(u, v) = [u, v, 5 + sqrt(u)/1e6]
    toward surface(u, v) = [u, v, 0]
    look relative
}

// Has no ray anywhere.
camera nowhere {
    axes y_up
    map  u = -2 .. 2, v = square
    eye  surface(u, v) = [u, v, sqrt(-1 - u^2)]
    toward surface(u, v) = [u, v, 0]
    look relative
}

// Looks at the scene from nearby.
camera closeup {
    axes y_up
    map  u = -1 .. 1, v = square
    eye  surface(u, v) = [u, v, 5]
    toward surface(u, v) = [u, v, 0]
    look relative
}
"""


CORNERS = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0)


def triangle(name="triangle"):
    """A glTF document with one triangle whose corners are its only buffer."""
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": name}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": len(CORNERS)}],
        "bufferViews": [{"buffer": 0, "byteLength": len(CORNERS)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [-1, -1, 0], "max": [1, 1, 0]}],
    }


def glb_bytes():
    """The triangle as a binary glTF file."""
    document = json.dumps(triangle()).encode()
    document += b" " * (-len(document) % 4)
    chunks = struct.pack("<I4s", len(document), b"JSON") + document
    chunks += struct.pack("<I4s", len(CORNERS), b"BIN\0") + CORNERS
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def gltf_text_with_light(name="triangle"):
    """The triangle and a point light as a glTF file of text."""
    document = triangle(name)
    document["buffers"][0]["uri"] = ("data:application/octet-stream;base64,"
                                     + base64.b64encode(CORNERS).decode())
    document["extensionsUsed"] = ["KHR_lights_punctual"]
    document["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point"}]}}
    document["nodes"].append({"name": "lamp", "translation": [0, 0, 3],
                              "extensions": {"KHR_lights_punctual": {"light": 0}}})
    document["scenes"][0]["nodes"].append(1)
    return json.dumps(document)


def gltf_text_with_cameras():
    """The triangle before two cameras at a distance of 3: the second sees the lower left part."""
    document = triangle()
    document["buffers"][0]["uri"] = ("data:application/octet-stream;base64,"
                                     + base64.b64encode(CORNERS).decode())
    document["cameras"] = [
        {"type": "perspective",
         "perspective": {"yfov": 1.5707963267948966, "aspectRatio": 1, "znear": 0.1}},
        {"type": "orthographic",
         "orthographic": {"xmag": 4, "ymag": 2, "znear": 0.1, "zfar": 100}}]
    document["nodes"] += [{"name": "Front", "translation": [0, 0, 3], "camera": 0},
                          {"name": "Plan", "translation": [4, 2, 3], "camera": 1}]
    document["scenes"][0]["nodes"] += [1, 2]
    return json.dumps(document)


def write_png(path, rows, channels):
    """Writes rows of bytes, with 8 bits a channel: grey, or red, green and blue."""
    def chunk(kind, body):
        return (struct.pack(">I", len(body)) + kind + body
                + struct.pack(">I", zlib.crc32(kind + body)))

    form = (len(rows[0]) // channels, len(rows), 8, {1: 0, 3: 2}[channels], 0, 0, 0)
    Path(path).write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", *form))
        + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 1))
        + chunk(b"IEND", b""))


def png_pixels(path, form=(8, 6)):
    """Width, height and rows of pixels, each chunk checked. They are tuples of bytes: of a file of 8
    bits a channel with red, green, blue and alpha, or with another form (bits, type of colours)."""
    data = Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG signature"
    place, packed, kinds = 8, b"", []
    while place < len(data):
        length, kind = struct.unpack_from(">I4s", data, place)
        body = data[place + 8:place + 8 + length]
        (check,) = struct.unpack_from(">I", data, place + 8 + length)
        assert zlib.crc32(kind + body) == check, "a chunk's check sum is wrong"
        kinds.append(kind)
        if kind == b"IHDR":
            width, height, bits, colour = struct.unpack_from(">IIBB", body)
            assert (bits, colour) == form, f"not of the form {form}"
        packed += body if kind == b"IDAT" else b""
        place += 12 + length
    assert kinds[-1] == b"IEND", "the file ends early"
    size = bits // 8 * {2: 3, 6: 4}[colour]
    return width, height, unfiltered(zlib.decompress(packed), width, height, size)


def unfiltered(raw, width, height, size):
    """Rows of a PNG image as lists of pixels of so many bytes."""
    stride, rows, above = size * width, [], bytes(size * width)
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left = row[i - size] if i >= size else 0
            corner = above[i - size] if i >= size else 0
            guess = left + above[i] - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - above[i]), 1, above[i]),
                        (abs(guess - corner), 2, corner))[2]
            row[i] = (row[i] + (0, left, above[i], (left + above[i]) // 2, paeth)[kind]) & 255
        rows.append([tuple(row[size * x:size * (x + 1)]) for x in range(width)])
        above = row
    return rows


def opaque_share(path):
    """The share of pixels that are not transparent."""
    width, height, rows = png_pixels(path)
    return sum(pixel[3] > 0 for row in rows for pixel in row) / (width * height)


class CommandTest(unittest.TestCase):
    """Each test has a folder of its own with scene.obj, room.glb and my.cam, and runs in it."""

    maxDiff = None

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="balcony-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "scene.obj").write_text(OBJ)
        (self.folder / "room.glb").write_bytes(glb_bytes())
        (self.folder / "my.cam").write_text(CAMERAS)

    def start(self, *words, **how):
        streams = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE,
                   "stderr": subprocess.PIPE}
        return subprocess.Popen([BALCONY, *words], cwd=self.folder, **{**streams, **how})

    def run_command(self, *words, code=0, **how):
        """Runs the command to its end; the exit code must be the one that is stated."""
        with self.start(*words, **how) as process:
            out, err = process.communicate(timeout=120)
        out, err = (out or b"").decode(), (err or b"").decode()
        self.assertEqual(process.returncode, code, f"{words}\n{out}\n{err}")
        return out, err

    def refused(self, *words, code, says, helps=""):
        """The command refuses with one clear message and nothing on standard output."""
        out, err = self.run_command(*words, code=code)
        self.assertEqual(out, "")
        self.assertIn("error: ", err)
        self.assertIn(says, err)
        self.assertIn(helps, err)
        for oddity in ("terminate", "std::", "TEXT", "basic_", "what():", "e+308", ".000000"):
            self.assertNotIn(oddity, err)
        return err

    def json_of(self, *words, code=0):
        """The one JSON document on standard output."""
        out, err = self.run_command(*words, "--json", code=code)
        self.assertEqual(err, "")
        document = json.loads(out)
        self.assertIsInstance(document["diagnostics"], list)
        failed = any(said["severity"] == "error" for said in document["diagnostics"])
        self.assertEqual(failed, code in (1, 2, 3))
        return document

    def files(self):
        return sorted(os.listdir(self.folder))


def main():
    """python3 NAME_test.py BALCONY REPOSITORY [unittest's options]"""
    global BALCONY, REPOSITORY
    BALCONY, REPOSITORY = os.path.abspath(sys.argv[1]), Path(sys.argv[2]).resolve()
    os.environ.pop("TERM", None)
    unittest.main(module="__main__", argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
