# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Extended cameras: their rays, their inverse, their derivatives, and pictures through them.

    import balcony

    cam = balcony.camera("panorama", fov="180deg")
    origins, directions, valid = cam.rays(960, 480)
    pixels = cam.project([[0, 3, 1], [2, 5, 0]], size=(960, 480))
    picture = balcony.render("room.glb", cam, size=(960, 480), samples=64)
    picture["normal"]

Angles are in radians; a text such as "180deg" is an expression of the camera language. Positions in
a picture are in pixels from its top left corner: the middle of the first pixel is (0.5, 0.5).
Functions may be called by any thread, and release the lock of Python while they work. Ctrl-C stops
them.
"""

import atexit as _atexit

from . import _balcony, formulas, stages
from ._cameras import (Camera, Finding, Jacobian, Located, Parameter, Rays, Sightings, Solution, camera,
                       cameras, export_languages, solve)
from ._compose import compose, path
from ._datasets import Dataset, Frame, dataset
from ._pictures import Picture
from ._sampled import Sampled, from_rays
from ._scene_parts import Light, Material, Object, Property
from ._scenes import Scene, load, render
from ._studies import animate, warp
from ._widget import widget
from .formulas import parameter
from .errors import (BalconyWarning, Error, InputError, InternalError, Interrupted, MachineError,
                     UsageError)

__version__ = _balcony.version
__all__ = ["BalconyWarning", "Camera", "Dataset", "Error", "Finding", "Frame", "InputError",
           "InternalError", "Interrupted", "Jacobian", "Light", "Located", "MachineError", "Material",
           "Object", "Parameter", "Picture", "Property", "Rays", "Sampled", "Scene", "Sightings",
           "Solution", "UsageError", "animate", "camera", "cameras", "compose", "dataset",
           "export_languages", "formulas", "from_rays", "load", "parameter", "path", "render", "solve",
           "stages", "warp", "widget"]

_atexit.register(_balcony.stop_all)
