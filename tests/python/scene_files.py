# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Files of tests."""

import tempfile
import unittest
from pathlib import Path

# A room of 6 x 2.5 x 4 with y up, its middle at the origin of x and z.
ROOM = """
v -3 0 2
v 3 0 2
v 3 0 -2
v -3 0 -2
v -3 2.5 2
v 3 2.5 2
v 3 2.5 -2
v -3 2.5 -2
o floor
f 1 2 3 4
o ceiling
f 8 7 6 5
o walls
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""

# Looks along x, in axes with z up.
AIMED = """
// Looks around.
camera aimed(yaw = 0deg, fov = 90deg from 1deg to 170deg, spot = (0, 0, 0)) {
    let half = tan(fov/2)
    map u = half .. -half, v = square
    eye point(0, 0, 0)
    toward plane((1, 0, 0))
    move rotate(z, yaw), translate(spot)
}
"""


class RoomTest(unittest.TestCase):
    """Has a folder, and the file of the room in it."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.room = cls.folder / "room.obj"
        cls.room.write_text(ROOM)
