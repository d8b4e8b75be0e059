# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Cameras, their rays, their inverse and their derivatives."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, NamedTuple, Union

from . import _balcony

if TYPE_CHECKING:
    import numpy as np

    from ._scenes import Scene

Value = Union[float, int, str, tuple, list]
"""Of a parameter: a number, in radians if it is an angle, an expression of the camera language, or a
tuple or a list of these."""
Size = Union[int, tuple[int, int]]
"""Of a picture in pixels: width and height, or the width alone."""


class Parameter(NamedTuple):
    """A parameter of a camera as it stands."""

    name: str
    value: float | None
    """In radians if it is an angle; None if it is no number, such as a tuple."""
    written: str
    """As the camera language has it: "180deg"."""
    is_angle: bool
    range: tuple[float, float]
    """The least and the greatest value that it may have."""


class Rays(tuple):
    """The rays of a picture or of points. It unpacks to `origins, directions, valid`.

    The leading axes of all arrays are those of the rays: (height, width) of a picture, from its top
    left, or (n,) of points. Where there is no ray, `valid` is False and all numbers are 0.
    """

    def __new__(cls, arrays):
        made = super().__new__(cls, arrays[:3])
        made._others = arrays[3:]
        return made

    @property
    def origins(self) -> np.ndarray:
        """(..., 3), float64: where the rays begin, in scene units."""
        return self[0]

    @property
    def directions(self) -> np.ndarray:
        """(..., 3), float64: of unit length."""
        return self[1]

    @property
    def valid(self) -> np.ndarray:
        """(...), bool: whether there is a ray."""
        return self[2]

    @property
    def parameters(self) -> np.ndarray:
        """(..., 2), float64: (u, v) of the eye object."""
        return self._others[0]

    @property
    def footprints(self) -> np.ndarray | None:
        """(..., 4, 3), float64: the exact derivatives per pixel of the origin by picture x and by
        picture y, and of the direction by x and by y; None unless they were asked for."""
        return self._others[1]

    @property
    def times(self) -> np.ndarray | None:
        """(...), float64: when each ray meets the scene, in seconds; None if all do at once."""
        return self._others[2]


class Sightings(NamedTuple):
    """Where a picture shows points: each sighting is one place. A point may have several, or none."""

    point: np.ndarray
    """(m,), int64: the index of the point among those that were given."""
    layer: np.ndarray
    """(m,), int64: the camera layer of the picture that shows it, from 0 at the back."""
    position: np.ndarray
    """(m, 2), float64: in pixels from the top left corner."""
    origin: np.ndarray
    """(m, 3), float64: where the ray begins."""
    distance: np.ndarray
    """(m,), float64: from there to the point, in scene units."""


class Located(NamedTuple):
    """Where a picture of a scene shows points, and what hides them: each sighting is one place."""

    point: np.ndarray
    """(m,), int64: as of `Sightings`, as are the next four."""
    layer: np.ndarray
    position: np.ndarray
    origin: np.ndarray
    distance: np.ndarray
    obstacle: np.ndarray
    """(m,), int64: the first opaque object on the way to the point, an index into `objects`; -1 if the
    point is seen."""
    obstacle_distance: np.ndarray
    """(m,), float64: from the origin of the ray to the obstacle; NaN without one."""
    objects: list[str]
    """The names of the objects of the scene."""

    @property
    def hidden(self) -> np.ndarray:
        """(m,), bool."""
        return self.obstacle >= 0

    @property
    def hidden_by(self) -> list[str | None]:
        """The name of each obstacle."""
        return [None if one < 0 else self.objects[one] for one in self.obstacle.tolist()]


class Jacobian(NamedTuple):
    """Derivatives by parameters of a camera; NaN where a point has no ray."""

    array: np.ndarray
    """(n, 2, k), float64, for points of space: of x and y of their position in pixels; or (n, 6, k)
    for positions in the picture: of the origin and the direction of their rays."""
    by: list[str]
    """The k parameters, in the order of the last axis."""


class Finding(NamedTuple):
    """What is wrong with a camera, or worth knowing."""

    camera: str
    name: str
    """In some words: "no ray", "fold"."""
    is_defect: bool
    message: str
    remedy: str
    at: tuple[float, float] | None
    """An example in the picture, in pixels."""


class Camera:
    """A camera: a function from a point of a picture to a ray.

    Its parameters are attributes: `cam.fov` is the value of the parameter fov, and `cam.fov = "90deg"`
    gives it another one. `help(cam)` tells what all cameras can do, and `print(cam)` what this one is.
    """

    __slots__ = ("_camera",)

    def __init__(self, camera: str | os.PathLike, /, name: str = "", **values: Value):
        text = os.fspath(camera)
        object.__setattr__(self, "_camera", _balcony.Camera(text, name, os.getcwd()))
        if values:
            self.set(**values)

    # -------------------------------------------------------------------------------- parameters

    @property
    def name(self) -> str:
        """Of the camera in its file."""
        return self._camera.name()

    @property
    def parameters(self) -> dict[str, Parameter]:
        """All parameters by name, as they stand."""
        return {one[0]: Parameter(*one[:5]) for one in self._camera.parameters()}

    @property
    def text(self) -> str:
        """The text of a camera file with this camera, its values written into it."""
        return self._camera.text()

    def save(self, file: str | os.PathLike) -> None:
        """Writes the text to a camera file."""
        with open(file, "w", encoding="utf-8") as text:
            text.write(self.text)

    def set(self, **values: Value) -> Camera:
        """Gives several parameters other values at once. Returns the camera."""
        self._camera.set(values)
        return self

    def copy(self, **values: Value) -> Camera:
        """The same camera, whose values may then differ."""
        made = object.__new__(type(self))
        object.__setattr__(made, "_camera", self._camera.copy())
        return made.set(**values) if values else made

    def placed(self, pose, axes: str = "balcony", *, world: str = "z_up") -> Camera:
        """The same camera in another place: moved from where its file has it by a matrix (3, 4) or (4, 4)
        from its axes to those of the world, which have y or z up. A scene does not place it then.

        `axes` are those of the camera: "balcony" is x ahead, y to the left, z up; "opencv" is x to the
        right, y down, z ahead; "opengl", also of Blender and nerfstudio, is x to the right, y up, z to the
        back. A camera that its file has at the origin, looking along x, stands and looks as the matrix
        says: built-in cameras do.
        """
        made = object.__new__(type(self))
        object.__setattr__(made, "_camera", self._camera.placed(pose, axes, world))
        return made

    def __getattr__(self, name: str):
        if name.startswith("_"):
            raise AttributeError(name)
        for one in self._camera.parameters():
            if one[0] == name:
                return one[2] if one[1] is None else one[1]
        hint = _balcony.suggestion(name, list(self.parameters), "its parameters are")
        raise AttributeError(f"the camera '{self.name}' has no parameter '{name}': {hint}")

    def __setattr__(self, name: str, value: Value):
        if name.startswith("_") or hasattr(type(self), name):
            raise AttributeError(f"'{name}' cannot be set")
        self.set(**{name: value})

    def __dir__(self):
        return [*super().__dir__(), *self.parameters]

    def __copy__(self):
        return self.copy()

    def __deepcopy__(self, memo):
        return self.copy()

    # A camera goes to another process as its text and its pose.
    def __reduce__(self):
        return _from_text, (self.text, self.name, self._camera.pose())

    # -------------------------------------------------------------------------------- rays

    def rays(self, width: int, height: int, *, layer: str = "", axes: str | None = None,
             time: float = 0.0, scene: Scene | None = None, footprints: bool = False) -> Rays:
        """The rays through the middles of all pixels of a picture.

        A picture with several layers needs the name or the number of one. Rays are in the axes of the
        camera, or of the scene if there is one, unless `axes` says "y_up" or "z_up". A scene places
        built-in cameras, as `balcony render` does.
        """
        return self._rays((width, height), layer, axes, time, scene, footprints, None)

    def rays_at(self, points, *, size: tuple[int, int], layer: str = "", axes: str | None = None,
                time: float = 0.0, scene: Scene | None = None, footprints: bool = False) -> Rays:
        """The rays at positions, an array (n, 2) in pixels, of a picture of this size."""
        return self._rays(size, layer, axes, time, scene, footprints, points)

    def _rays(self, size, layer, axes, time, scene, footprints, points):
        return Rays(_balcony.rays(self._camera, size, str(layer), axes, time, _object(scene),
                                  footprints, points))

    def project(self, points, *, size: tuple[int, int], axes: str | None = None, time: float = 0.0,
                scene: Scene | None = None) -> np.ndarray:
        """Where a picture of this size shows points of space, an array (n, 3): an array (n, 2) in pixels,
        NaN where it does not show them.

        If it shows a point in several places, this is the one in the front layer whose ray is shortest;
        `sightings` has all. What is in front of a point is not regarded.
        """
        return _balcony.project(self._camera, points, size, axes, time, _object(scene))

    def sightings(self, points, *, size: tuple[int, int], axes: str | None = None, time: float = 0.0,
                  scene: Scene | None = None) -> Sightings:
        """All places at which a picture of this size shows points of space, an array (n, 3)."""
        return Sightings(*_balcony.sightings(self._camera, points, size, axes, time, _object(scene)))

    def locate(self, points, scene: Scene, *, size: tuple[int, int]) -> Located:
        """All places at which a picture of a scene shows points, an array (n, 3) in its axes, and what hides
        them there, as `balcony locate` says it."""
        sightings, *obstacles = _balcony.locate(self._camera, points, size, scene._scene)
        return Located(*sightings, *obstacles)

    def jacobian(self, points, by: list[str] | None = None, *, size: tuple[int, int], layer: int = 0,
                 axes: str | None = None, time: float = 0.0,
                 scene: Scene | None = None) -> Jacobian:
        """Exact derivatives by parameters of the camera, by default by all that are numbers.

        For points of space, an array (n, 3): of the positions that `project` finds. For positions in the
        picture, an array (n, 2): of their rays. `layer` is a camera layer, from 0 at the back.
        """
        return Jacobian(*_balcony.jacobian(self._camera, points, by, size, layer, axes, time,
                                           _object(scene)))

    # -------------------------------------------------------------------------------- other programs

    def export(self, language: str, *, inverse: bool = False, single: bool = False,
               axes: str | None = None, size: tuple[int, int] = (1280, 720)) -> str:
        """The camera as a function or a shader of another language, one of `export_languages`.

        `inverse` adds a function from points to positions, `single` asks for single precision, which
        is judged in a picture of the size.
        """
        return _balcony.export_camera(self._camera, language, inverse, single, axes, size)

    def save_rays(self, file: str | os.PathLike, width: int, height: int, *, layer: str = "",
                  axes: str | None = None, time: float = 0.0, scene: Scene | None = None,
                  footprints: bool = False) -> None:
        """Writes a ray map: .exr with 32-bit floats, or .npy."""
        _balcony.save_rays(self._camera, os.fspath(file), (width, height), str(layer), axes, time,
                           _object(scene), footprints)

    def stmap(self, source: Camera | str | os.PathLike, *, size: Size | None = None, layer: str = "",
              time: float = 0.0, photo_size: tuple[int, int] | None = None,
              allow_parallax: bool = False) -> np.ndarray:
        """From which place of a photo each pixel comes if the camera `source` took it: the numbers of an
        STMap, an array (height, width, 4) of float32.

        The first two are the place: from 0 at the left to 1 at the right, and from 0 at the bottom to 1 at
        the top. The last is 1 where the photo shows the pixel; the others are 0 elsewhere. `size` is that of
        this camera's picture: width and height, or the width. `photo_size` matters to cameras that adapt to
        it. `warp` applies such a map to a photo.
        """
        return _balcony.st_map(self._camera, camera_of(source)._camera, sides_of(size), str(layer), time,
                               photo_size, allow_parallax)

    def save_stmap(self, file: str | os.PathLike, source: Camera | str | os.PathLike, *,
                   size: Size | None = None, layer: str = "", time: float = 0.0,
                   photo_size: tuple[int, int] | None = None, allow_parallax: bool = False) -> None:
        """Writes an STMap, as `balcony stmap` does: .exr with 32-bit floats."""
        _balcony.save_st_map(self._camera, camera_of(source)._camera, os.fspath(file), sides_of(size),
                             str(layer), time, photo_size, allow_parallax)

    # -------------------------------------------------------------------------------- studies

    def check(self, scene: Scene | None = None, *,
              size: tuple[int, int] = (1280, 720)) -> list[Finding]:
        """What is wrong with the camera, or worth knowing, defects first: folds, seams, parts without
        rays and, in a scene, objects that it never shows or begins in."""
        found = [Finding(camera, name.replace("_", " "), *others)
                 for camera, name, *others in self._camera.check(size, _object(scene))]
        return sorted(found, key=lambda one: not one.is_defect)

    def __repr__(self):
        values = "".join(f", {one[0]}={one[2]!r}" for one in self._camera.parameters())
        return f"<balcony.Camera {self.name}{values}>"

    def __str__(self):
        lines = [self.name]
        if comment := self._camera.comment():
            lines += [comment, ""]
        for one in self._camera.parameters():
            lines.append(f"  {one[0]} = {one[2]}" + (f"  ({one[5]})" if one[5] else ""))
        return "\n".join(lines)

    def _repr_svg_(self) -> str:
        return self._camera.drawing()


def camera_of(camera: Camera | str | os.PathLike) -> Camera:
    """A camera that is named or given."""
    return camera if isinstance(camera, Camera) else Camera(camera)


def sides_of(size: Size | None) -> tuple[int | None, int | None]:
    """Width and height of a size; None for what follows from the aspect."""
    sides = tuple(size) if isinstance(size, (tuple, list)) else (size, None)
    if len(sides) != 2 or not all(one is None or hasattr(one, "__index__") for one in sides):
        raise TypeError(f"'size' is {size!r}, but a width or (width, height) is needed, in pixels")
    return sides


def _object(scene: Scene | None):
    return None if scene is None else scene._scene


def _from_text(text: str, name: str, pose: list | None) -> Camera:
    made = Camera(text, name)
    return made if pose is None else made.placed(pose)


def camera(camera: str | os.PathLike, /, name: str = "", **values: Value) -> Camera:
    """A camera: a built-in one by its name, one of a file ("my.cam", or "my.cam:NAME"), or one of a text
    in the camera language, with values for its parameters.

        balcony.camera("panorama", fov="180deg")
        balcony.camera("camera eye(a = 1) { eye point(0, 0, 0) toward sphere(a) }")

    Of a file or a text with several cameras, it is that of the name or, without one, the last.
    """
    return Camera(camera, name, **values)


def cameras(words: str = "") -> list[str]:
    """The names of the built-in cameras, or of those that words lead to, the best first."""
    return _balcony.search_cameras(words) if words else list(_balcony.built_in_cameras())


def export_languages() -> dict[str, str]:
    """The languages of `Camera.export`, and what each is."""
    return dict(_balcony.export_languages())


class Solution(NamedTuple):
    """A camera that was found from what its picture is to show."""

    camera: Camera
    values: dict[str, float]
    """By parameter; in radians if it is an angle."""
    deviations: dict[str, float]
    """Their standard deviations; infinite for what the marks do not determine."""
    error: float | None
    """The root mean square of what marks miss their positions by, in pixels."""


def solve(camera: str | os.PathLike, marks: str | os.PathLike, *, starts: int = 1,
          **values: str) -> Solution:
    """Finds the parameters of a camera file or a built-in camera from a file of marks, as `balcony solve`
    does; values are those at which the search begins, as texts."""
    text, name, found, error = _balcony.solve(
        os.fspath(camera), os.fspath(marks), [f"{name}={value}" for name, value in values.items()],
        starts)
    return Solution(Camera(text, name), {one[0]: one[1] for one in found},
                    {one[0]: one[2] for one in found}, error)
