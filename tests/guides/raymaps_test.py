# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs docs/raymaps.md."""

import re
import subprocess
from pathlib import Path

import guide

PYTHON = guide.python_with("numpy")
if PYTHON is None:
    guide.skip("no Python has numpy")

# Compares the stream of the page with the rays of the same camera in a file.
COMPARE = """
import numpy as np
stream = np.fromfile("rays.bin", dtype="=f4").reshape(128, 256, 6)
print(np.array_equal(stream, np.load("same.npy")[..., :6]))
"""

# The directions of the page's script, once more, and those that Balcony reads from its map.
BACK = """
import numpy as np
given = np.load("rays.npy")
back = np.load("back.npy")
valid = np.any(given[..., 3:] != 0, axis=-1)
length = np.linalg.norm(given[..., 3:], axis=-1, keepdims=True)
exact = np.divide(given[..., 3:], length, where=length > 0, out=np.zeros_like(given[..., 3:]))
print(np.array_equal(back[..., 6] == 1, valid), np.abs(back[..., 3:6] - exact)[valid].max())
"""


class RayMapsGuide(guide.GuideTest):
    PAGE = "raymaps.md"
    PATH = f"{Path(PYTHON).parent}:{guide.GuideTest.PATH}"

    def python(self, script):
        return subprocess.run([PYTHON, "-c", script], cwd=self.folder, check=True,
                              capture_output=True, text=True).stdout

    def test_the_stream_has_the_rays_of_a_file(self):
        self.run_line("balcony rays panorama --size 256x128 --format float -o same.npy")
        self.assertEqual(self.python(COMPARE), "True\n")

    def test_the_measured_camera_has_the_rays_of_the_script(self):
        self.assertIn("no errors", self.output_of("balcony check measured.cam"))
        self.run_line("balcony rays measured.cam --set height=0 --size 320x180 -o back.npy")
        same, largest = self.python(BACK).split()
        self.assertEqual(same, "True")
        # The weights of a pixel centre are 1 and 0 up to the rounding of its place.
        self.assertLess(float(largest), 1e-12)

    def test_the_photo_shows_every_direction(self):
        for line in ("balcony stmap", "balcony warp photo.png --from panorama --camera planet.cam"):
            self.assertIn("160000 of them in the photo", self.output_of(line))
        found = re.search(r"(\d+) x (\d+) pixels, (\d+) of", self.output_of(
            "balcony warp photo.png --from panorama --camera pinhole"))
        self.assertEqual(int(found[1]) * int(found[2]), int(found[3]))


if __name__ == "__main__":
    guide.main()
