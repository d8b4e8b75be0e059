# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Scenes, and pictures of them."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable

from . import _balcony
from ._cameras import Camera
from ._pictures import Picture


class Scene:
    """A scene that is loaded and lit. Options are those of `balcony render`, which its pictures then have
    unless they say otherwise: `balcony.load("room.glb", environment="sky.exr", lamp=["0,2,0"])`."""

    __slots__ = ("_scene", "_file")

    def __init__(self, file: str | os.PathLike, /, **options):
        self._file = os.fspath(file)
        self._scene = _balcony.Scene(self._file, options)

    @property
    def objects(self) -> list[str]:
        """The names of its objects."""
        return self._scene.objects()

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
        of_scene = ""
        if camera is not None and not isinstance(camera, Camera):
            name = os.fspath(camera)
            camera, of_scene = (None, name) if name.startswith("scene:") else (Camera(name), "")
        tell = _draw_bar if progress is True else progress or None
        try:
            made = self._scene.render(camera and camera._camera, options, of_scene, tell)
        finally:
            if progress is True:
                print(file=sys.stderr)
        return Picture(made)

    def __repr__(self):
        return f"<balcony.Scene {self._file}, {len(self.objects)} objects>"


def _draw_bar(done: float) -> None:
    print(f"\r[{'=' * round(40 * done):40}] {done:4.0%}", end="", file=sys.stderr, flush=True)


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
