# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The layer that tells how what is seen moves from frame to frame."""

import support

# Follows a point that leaves the picture at once.
RUSHING = """
camera rushing {
    axes y_up
    map  u = -1 .. 1, v = square
    eye  surface(u, v) = [u + 100*t, v, 5]
    toward surface(u, v) = [u + 100*t, v, 0]
    look relative
}
"""


class MotionLayer(support.CommandTest):
    WORDS = ("render", "scene.obj", "--integrator", "preview", "--samples", "1", "--size", "20x20",
             "--layers", "motion", "-o", "p.exr")

    def test_frames_per_second_are_a_number_above_0(self):
        for text in ("0", "-24", "nan", "inf", "often"):
            self.refused(*self.WORDS, f"--fps={text}", code=2, says="--fps", helps="such as 24")

    def test_unknown_motion_is_counted(self):
        (self.folder / "rushing.cam").write_text(RUSHING)
        _, err = self.run_command(*self.WORDS, "-c", "rushing.cam")
        self.assertIn("the motion of 400 pixels is 0", err)
        # A thousandth of a pixel a frame.
        _, err = self.run_command(*self.WORDS, "-c", "rushing.cam", "--fps", "1e6")
        self.assertEqual(err, "")

    def test_it_is_not_computed_unless_asked_for(self):
        words = [word for word in self.WORDS if word not in ("--layers", "motion")]
        (self.folder / "rushing.cam").write_text(RUSHING)
        _, err = self.run_command(*words, "-c", "rushing.cam")
        self.assertEqual(err, "")


if __name__ == "__main__":
    support.main()
