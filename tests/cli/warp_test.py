# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony stmap and balcony warp: photos in the picture of a camera."""

import signal
import struct
import subprocess
import time

import support


def write_tiff(path, rows, orientation):
    """Writes rows of (r, g, b) with 8 bits, and how they are seen."""
    pixels = bytes(value for row in rows for pixel in row for value in pixel)
    short, long = 3, 4
    tags = [(256, short, 1, len(rows[0])), (257, short, 1, len(rows)), (258, short, 3, 8),
            (259, short, 1, 1), (262, short, 1, 2), (273, long, 1, 0),
            (274, short, 1, orientation), (277, short, 1, 3), (278, short, 1, len(rows)),
            (279, long, 1, len(pixels))]
    after = 8 + 2 + 12 * len(tags) + 4
    values = {258: after, 273: after + 6}
    directory = b"".join(struct.pack("<HHII", tag, kind, count, values.get(tag, value))
                         for tag, kind, count, value in tags)
    path.write_bytes(b"II*\0" + struct.pack("<IH", 8, len(tags)) + directory + bytes(4)
                     + struct.pack("<3H", 8, 8, 8) + pixels)


def turned(rows, orientation):
    """How rows are seen whose first row is at the right, say (TIFF 6.0, section 8)."""
    if orientation in (2, 3, 7, 8):
        rows = [row[::-1] for row in rows]
    if orientation in (3, 4, 6, 7):
        rows = rows[::-1]
    return [list(column) for column in zip(*rows)] if orientation >= 5 else rows


class Warp(support.CommandTest):
    def setUp(self):
        super().setUp()
        # No two pixels are alike.
        self.rows = [[(40 + 3 * x, 50 + 5 * y, (x * y) % 256) for x in range(64)] for y in range(32)]
        support.write_png(self.folder / "photo.png",
                          [bytes(value for pixel in row for value in pixel) for row in self.rows], 3)

    def warped(self, *words):
        self.run_command("warp", "photo.png", *words, "-o", "out.png")
        return support.png_pixels(self.folder / "out.png")

    def test_to_its_own_camera_a_photo_stays_as_it_is(self):
        for camera in ("pinhole", "panorama"):
            width, height, rows = self.warped("--from", camera, "--camera", camera, "--size",
                                              "64x32", "--aspect", "stretch")
            self.assertEqual((width, height), (64, 32))
            wanted = [[(*pixel, 255) for pixel in row] for row in self.rows]
            self.assertEqual([[tuple(pixel) for pixel in row] for row in rows], wanted, camera)

    def test_a_photo_is_upright(self):
        for orientation in range(1, 9):
            write_tiff(self.folder / "photo.tif", self.rows, orientation)
            wanted = turned(self.rows, orientation)
            size = f"{len(wanted[0])}x{len(wanted)}"
            self.run_command("warp", "photo.tif", "--from", "pinhole", "--camera", "pinhole",
                             "--size", size, "--aspect", "stretch", "-o", "out.png")
            _, _, rows = support.png_pixels(self.folder / "out.png")
            self.assertEqual([[tuple(pixel[:3]) for pixel in row] for row in rows], wanted,
                             orientation)

    def test_a_photo_is_not_mirrored(self):
        # The middle of a panorama looks along x; a quarter to its left is 90 degrees to the left.
        for yaw, column in (("0deg", 32), ("90deg", 16), ("-90deg", 48)):
            _, _, rows = self.warped("--from", "panorama", "--camera", "pinhole", "--set",
                                     f"yaw={yaw}", "--set", "fov=10deg", "--size", "2x2")
            for value in (pixel[0] for row in rows for pixel in row):
                self.assertAlmostEqual(value, 40 + 3 * (column - 0.5), delta=3)
        # Upwards is towards the first row.
        _, _, up = self.warped("--from", "panorama", "--camera", "pinhole", "--set", "pitch=60deg",
                               "--set", "fov=10deg", "--size", "1x1")
        self.assertAlmostEqual(up[0][0][1], 50 + 5 * (32 * 30 / 180 - 0.5), delta=5)

    def test_is_transparent_beside_the_photo(self):
        _, _, rows = self.warped("--from", "pinhole", "--camera", "panorama", "--size", "40x20")
        self.assertEqual(rows[10][0][3], 0)
        self.assertEqual(rows[10][20][3], 255)
        self.run_command("warp", "photo.png", "--from", "pinhole", "--camera", "panorama", "--size",
                         "40x20", "-o", "out.jpg")
        document = self.json_of("warp", "photo.png", "--from", "pinhole", "--camera", "panorama",
                                "--size", "40x20", "-o", "out.exr")
        # The centres of the pixels at the border may be in the photo or not.
        opacities = [pixel[3] for row in rows for pixel in row]
        self.assertGreaterEqual(document["valid"], opacities.count(255))
        self.assertLessEqual(document["valid"], len(opacities) - opacities.count(0))
        self.assertTrue(any(0 < opacity < 255 for opacity in opacities))

    def test_a_map_of_its_own_is_read_back_as_a_warp(self):
        """stmap writes what the stage stmap reads."""
        document = self.json_of("stmap", "pinhole", "--set", "fov=50deg", "--from", "pinhole",
                                "--size", "64x36", "-o", "st.exr")
        self.assertEqual(document["valid"], 64 * 36)
        (self.folder / "zoomed.cam").write_text(
            "camera zoomed {\n"
            "    let w = tan(30deg)\n"
            "    map u = w .. -w, v = -w*9/16 .. w*9/16\n"
            '    warp stmap("st.exr", from = (w, -w*9/16), to = (-w, w*9/16))\n'
            "    eye point\n    toward plane((1, 0, 0))\n}\n")
        streams = []
        for words in (("zoomed.cam",), ("pinhole", "--set", "fov=50deg")):
            with self.start("rays", *words, "--size", "48x27") as process:
                out, _ = process.communicate(timeout=60)
            streams.append([float(word) for word in out.split()])
        for one, other in zip(*streams, strict=True):
            self.assertAlmostEqual(one, other, 6)

    def test_the_circle_of_a_dome_master_is_no_fault(self):
        # At this size, the border of the circle has more cells than are divided.
        _, err = self.run_command("stmap", "pinhole", "--from", "fulldome", "--from-size",
                                  "4096x4096", "--size", "16", "-o", "st.exr")
        self.assertEqual(err, "")

    def test_cameras_without_a_single_viewpoint(self):
        words = ("--from", "panorama", "--size", "20x10", "-o", "st.exr")
        self.refused("stmap", "cylinder", *words, code=1, says="no single viewpoint",
                     helps="--allow-parallax")
        _, err = self.run_command("stmap", "superelliptic", *words, "--allow-parallax")
        self.assertIn("no single viewpoint", err)
        self.refused("stmap", "panorama", "--from", "cylinder", "-o", "st.exr", code=1,
                     says="camera 'cylinder' of the photo")
        _, err = self.run_command("stmap", "panorama", "--from", "cylinder", *words[2:],
                                  "--allow-parallax")
        self.assertIn("camera 'cylinder' of the photo", err)

    def test_interrupted(self):
        # Rows that are begun are finished, which takes seconds if the photo has no closed inverse.
        for words in (("stmap", "panorama"), ("warp", "photo.png", "--camera", "panorama")):
            with self.start(*words, "--from", "pinhole", "--size", "60000x30000", "-o",
                            "large.exr") as process:
                time.sleep(1.5)
                process.send_signal(signal.SIGINT)
                self.assertEqual(process.wait(timeout=60), 130)
            self.assertEqual([one for one in self.files() if one.startswith("large")], [])

    def test_a_file_limit(self):
        script = 'ulimit -f 100; exec "$0" stmap panorama --from panorama --size 400x200 -o st.exr'
        done = subprocess.run(["bash", "-c", script, support.BALCONY], cwd=self.folder,
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("cannot be written: File too large", done.stderr)

    def test_bad_usage(self):
        words = ("--from", "panorama", "--camera", "pinhole")
        self.refused("warp", "none.png", *words, "-o", "out.png", code=1, says="none.png")
        self.refused("warp", "my.cam", *words, "-o", "out.png", code=1, says="'my.cam' cannot be read")
        self.refused("warp", "photo.png", *words, "-o", "photo.png", code=2, says="overwritten")
        self.refused("warp", "photo.png", *words, "-o", "out.txt", code=2, says="out.txt")
        self.refused("warp", "photo.png", *words, "-o", "none/out.png", code=3, says="no folder")
        self.refused("warp", "photo.png", *words, "-o", "out.png", "--size", "0", code=2,
                     says="--size")
        self.refused("stmap", "pinhole", "--from", "panorama", "-o", "st.png", code=2, says="st.png",
                     helps=".exr")
        self.refused("stmap", "pinhole", "--from", "panorama", "-o", "st.exr", "--from-size", "20",
                     code=2, says="--from-size")
        self.refused("stmap", "pinhole", "--from", "none.cam", "-o", "st.exr", code=1,
                     says="none.cam")
        self.assertEqual(self.files(), sorted({*self.files()} - {"out.png", "st.exr"}))


if __name__ == "__main__":
    support.main()
