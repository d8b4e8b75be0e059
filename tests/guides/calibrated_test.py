# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs docs/calibrated.md, and compares all models that OpenCV has with OpenCV itself, and those of
mrcal with mrcal, if it is installed."""

import re
import shutil
from pathlib import Path

import guide

PYTHON = guide.python_with("numpy", "cv2")
if PYTHON is None:
    guide.skip("no Python has numpy and OpenCV")

# Of a picture of some 1000 pixels: Balcony's rays are good to 1e-12 of it, and some roundings of
# OpenCV's own come to that.
TOLERANCE = 2e-9

COMPARE = """
import sys, cv2, numpy
model = sys.argv[1]
K = numpy.array([[610.3, 0, 651.2], [0, 608.9, 485.4], [0, 0, 1]])
D = {
    "pinhole4": [-0.2, 0.05, 1e-3, -7e-4],
    "pinhole5": [-0.2, 0.05, 1e-3, -7e-4, -0.004],
    "pinhole8": [0.31, 0.03, 1e-3, -7e-4, 6e-4, 0.47, 0.09, 0.0042],
    "pinhole12": [-0.2, 0.05, 1e-3, -7e-4, -0.004, 0, 0, 0, 1e-3, -2e-4, -2e-3, 3e-4],
    "pinhole14": [-0.2, 0.05, 1e-3, -7e-4, -0.004, 0, 0, 0, 1e-3, -2e-4, -2e-3, 3e-4, 0.03, -0.02],
    "fisheye": [0.03, -0.01, 0.003, -4e-4],
    "omnidir": [-0.1, 0.02, 7e-4, -4e-4],
}[model]
D = numpy.array([D])
if len(sys.argv) == 2:
    file = cv2.FileStorage(model + ".yml", cv2.FILE_STORAGE_WRITE)
    file.write("image_width", 1280)
    file.write("image_height", 960)
    if model == "fisheye":
        file.write("fisheye_model", 1)
    if model == "omnidir":
        file.write("xi", 0.9)
    file.write("camera_matrix", K)
    file.write("distortion_coefficients", D)
    file.release()
else:
    rays = numpy.load(sys.argv[2]).reshape(960 * 1280, -1)
    y, x = numpy.mgrid[:960, :1280]
    valid = rays[:, 6] > 0
    # OpenCV's fisheye has no points behind the camera.
    valid &= (rays[:, 3] > 0.01) | (model == "omnidir")
    points = numpy.stack([-rays[:, 4], -rays[:, 5], rays[:, 3]], axis=1)[valid][None]
    zero = numpy.zeros(3)
    if model == "fisheye":
        made, _ = cv2.fisheye.projectPoints(points, zero, zero, K, D[0])
    elif model == "omnidir":
        made, _ = cv2.omnidir.projectPoints(points, zero, zero, K, 0.9, D)
    else:
        made, _ = cv2.projectPoints(points, zero, zero, K, D)
    pixels = numpy.stack([x.ravel(), y.ravel()], axis=1)[valid]
    print(valid.mean(), numpy.abs(made.reshape(-1, 2) - pixels).max())
"""

MRCAL_PYTHON = guide.python_with("numpy", "mrcal")
COMPARE_MRCAL = """
import sys, mrcal, numpy
name, file = sys.argv[1:3]
terms = [0.31, 0.03, 1e-3, -7e-4, 6e-4, 0.47, 0.09, 0.0042, 1e-3, -2e-4, -2e-3, 3e-4]
if name == "splined":
    lens = mrcal.cameramodel(file)
elif len(sys.argv) == 3:
    count = int(name)
    lens = mrcal.cameramodel(intrinsics=(
        f"LENSMODEL_OPENCV{count}" if count else "LENSMODEL_PINHOLE",
        numpy.array([610.3, 608.9, 651.2, 485.4] + terms[:count])), imagersize=(1280, 960))
    lens.write(file)
else:
    lens = mrcal.cameramodel(file)
if len(sys.argv) == 4:
    width, height = lens.imagersize()
    rays = numpy.load(sys.argv[3]).reshape(height, width, -1)
    y, x = numpy.mgrid[2:height:16, 2:width:16]
    rays = rays[y, x]
    valid = rays[..., 6] > 0
    points = numpy.stack([-rays[..., 4], -rays[..., 5], rays[..., 3]], axis=-1)[valid]
    made = mrcal.project(points, *lens.intrinsics())
    print(valid.mean(), numpy.abs(made - numpy.stack([x, y], axis=-1)[valid]).max())
"""


class CalibratedGuide(guide.GuideTest):
    PAGE = "calibrated.md"
    PATH = f"{Path(PYTHON).parent}:{guide.GuideTest.PATH}"

    def test_rays_arrive_at_their_pixels(self):
        off = re.search(r"(\S+) pixels", self.output_of("python3 project.py"))
        self.assertLess(float(off[1]), TOLERANCE)

    def test_every_model_is_that_of_opencv(self):
        (self.folder / "compare.py").write_text(COMPARE)
        for model in ("pinhole4", "pinhole5", "pinhole8", "pinhole12", "pinhole14", "fisheye",
                      "omnidir"):
            with self.subTest(model=model):
                self.run_line(f"python3 compare.py {model}")
                (self.folder / "one.cam").write_text(
                    f'camera one {{\n    eye opencv("{model}.yml")\n}}\n')
                self.run_line("balcony rays one.cam --size 1280x960 -o one.npy")
                share, off = map(float, self.run_line(f"python3 compare.py {model} one.npy").split())
                self.assertLess(off, TOLERANCE)
                self.assertGreater(share, 0.9)

    def test_models_of_mrcal_are_those_of_mrcal(self):
        if MRCAL_PYTHON is None:
            self.skipTest("no Python has mrcal")
        (self.folder / "compare_mrcal.py").write_text(COMPARE_MRCAL)
        compare = f"{MRCAL_PYTHON} compare_mrcal.py"
        for name in ("0", "4", "5", "8", "12", "splined"):
            with self.subTest(name=name):
                file = "drone.cameramodel" if name == "splined" else f"{name}.cameramodel"
                if name == "splined":
                    shutil.copy(guide.REPOSITORY / "cameras" / "data" / file, self.folder)
                else:
                    self.run_line(f"{compare} {name} {file}")
                (self.folder / "one.cam").write_text(f'camera one {{\n    eye mrcal("{file}")\n}}\n')
                size = "1600x1200" if name == "splined" else "1280x960"
                self.run_line(f"balcony rays one.cam --size {size} -o one.npy")
                share, off = map(float, self.run_line(f"{compare} {name} {file} one.npy").split())
                self.assertLess(off, TOLERANCE)
                self.assertGreater(share, 0.9)


if __name__ == "__main__":
    guide.main()
