# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Scenes, and pictures of them."""

from __future__ import annotations

import os
from collections.abc import Callable

from . import _balcony, _progress
from ._cameras import Camera
from ._pictures import Picture
from ._scene_parts import Light, Material, Object, PartName

_edits = _balcony.edits


class Scene:
    """A scene that is loaded and lit. Options are those of `balcony render`, which its pictures then have
    unless they say otherwise:

        scene = balcony.load("room.glb", environment="sky.exr", lamp=["point 100 at 0,2,0"])

    Without a file it is empty, with y or z up by `axes`, until something is added:

        scene = balcony.Scene(axes="z_up")
        scene.add_mesh("floor", [[-1, -1, 0], [1, -1, 0], [0, 1, 0]], [[0, 1, 2]])

    A scene that is changed changes at all times. A camera that the scene places follows.
    """

    __slots__ = ("_scene", "_file")

    def __init__(self, file: str | os.PathLike | None = None, /, *, axes: str | None = None, **options):
        self._file = None if file is None else os.fspath(file)
        if self._file is None:
            self._scene = _balcony.Scene.empty(axes or "y_up", options)
        elif axes is None:
            self._scene = _balcony.Scene(self._file, options)
        else:
            raise TypeError("a file has its own axes: leave out 'axes'")

    def copy(self) -> Scene:
        """The same scene as it is now, for another thread, or to be changed by itself. It shares the
        memory of all that is the same."""
        made = object.__new__(type(self))
        made._file, made._scene = self._file, self._scene.copy()
        return made

    def __copy__(self):
        return self.copy()

    def __deepcopy__(self, memo):
        return self.copy()

    @property
    def objects(self) -> list[str]:
        """The names of its objects."""
        return self._scene.objects()

    @property
    def materials(self) -> list[str]:
        """The names of its materials."""
        return self._scene.materials()

    @property
    def lights(self) -> list[str]:
        """The names of its lights. Surfaces that emit light are none of them."""
        return self._scene.lights()

    def object(self, name: PartName) -> Object:
        """An object, to be moved or removed."""
        return Object(self._scene, name)

    def __getitem__(self, name: PartName) -> Object:
        """The same as `object`: `scene["chair"].move(0, 0, 1)`."""
        return Object(self._scene, name)

    __iter__ = None  # Numbers are no indices of a sequence.

    def material(self, name: PartName) -> Material:
        """A material, to be changed."""
        return Material(self._scene, name)

    def light(self, name: PartName) -> Light:
        """A light, to be changed or removed."""
        return Light(self._scene, name)

    def add_mesh(self, name: str, positions, triangles, normals=None, uv=None, colors=None, *,
                 material: PartName | dict | None = None, matrix=None) -> Object:
        """Adds an object that is a mesh of `positions` (n, 3) and `triangles` (m, 3), whose numbers are
        those of positions, from 0. They face where their corners run counterclockwise.

        `normals` (n, 3) make it look smooth. `uv` (n, 2) are places in the textures of its material,
        from the top left. `colors` (n, 3) or (n, 4) are linear, from 0 to 1, and multiply that of the
        material. A `material` is one of the scene, or the properties of a new one with the name of the
        mesh, matt and grey where they do not say otherwise:
        `material={"base_color": (0.8, 0.1, 0.1), "roughness": 0.3}`. `matrix` (4, 4) places the object.
        """
        _edits.add_object(self._scene, name, positions, triangles, normals, uv, colors,
                          {} if material is None else material, matrix)
        return Object(self._scene, name)

    def add_material(self, name: str, **properties) -> Material:
        """Adds a material, matt and grey where its properties do not say otherwise."""
        _edits.add_material(self._scene, name, properties)
        return Material(self._scene, name)

    def add_light(self, name: str, kind: str = "point", **properties) -> Light:
        """Adds a light, "point", "spot" or "sun":
        `scene.add_light("lamp", position=(0, 2, 0), intensity=100)`."""
        _edits.add_light(self._scene, name, kind, properties)
        return Light(self._scene, name)

    @property
    def cameras(self) -> list[str]:
        """The names of its own cameras: `scene.render("scene:NAME")`."""
        return self._scene.cameras()

    @property
    def axes(self) -> str:
        """"y_up" or "z_up"."""
        return self._scene.axes()

    @property
    def time(self) -> float:
        """In seconds; another time moves what is animated."""
        return self._scene.time()

    @time.setter
    def time(self, seconds: float) -> None:
        self._scene.set_time(seconds)

    def render(self, camera: Camera | str | os.PathLike | None = None, *,
               progress: bool | Callable[[float], object] = False, **options) -> Picture:
        """A picture through a camera: an object, the name of a built-in one, a file, "scene:NAME", or
        that of the scene.

        Options are those of `balcony render`, in which `_` stands for `-`:
        `scene.render(cam, size=(960, 480), samples=64, denoise=True)`. `layers="default,motion"` adds
        layers. `progress` draws a bar, or calls a function with the part that is done.
        """
        own, of_scene = chosen(camera)
        with _progress.shown(progress) as tell:
            return Picture(self._scene.render(own, options, of_scene, tell))

    def __repr__(self):
        return f"<balcony.Scene {self._file or 'without a file'}, {len(self.objects)} objects>"


def chosen(camera: Camera | str | os.PathLike | None):
    """A camera for the library, and the name of one of the scene, "scene:NAME": one of them, or neither."""
    if camera is None or isinstance(camera, Camera):
        return camera and camera._camera, ""
    name = os.fspath(camera)
    return (None, name) if name.startswith("scene:") else (Camera(name)._camera, "")


def load(file: str | os.PathLike, /, **options) -> Scene:
    """A scene, loaded once for many pictures: glTF, OBJ, PLY or STL. Options are as those of `Scene`."""
    return Scene(file, **options)


def render(scene: Scene | str | os.PathLike, camera: Camera | str | os.PathLike | None = None,
           **options) -> Picture:
    """A picture of a scene through a camera; see `Scene.render`. `load` a scene once that has many
    pictures.

        picture = balcony.render("room.glb", "panorama", size=(960, 480), samples=64)
        picture.save("room.png")
    """
    if isinstance(scene, Scene):
        return scene.render(camera, **options)
    progress = options.pop("progress", False)
    return Scene(scene, **options).render(camera, progress=progress)
