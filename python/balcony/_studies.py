# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Photos in the pictures of cameras, and animations."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from . import _balcony, _progress
from ._cameras import Camera, camera_of, sides_of
from ._pictures import Picture
from ._scenes import Scene, chosen

if TYPE_CHECKING:
    import numpy as np

    from ._cameras import Size


def warp(photo: str | os.PathLike | np.ndarray | Picture, source: Camera | str | os.PathLike,
         camera: Camera | str | os.PathLike, *, size: Size | None = None, layer: str = "",
         time: float = 0.0, allow_parallax: bool = False,
         output: str | os.PathLike | None = None) -> np.ndarray | None:
    """A photo that the camera `source` took, as the camera `camera` shows it: an array (height, width, 4)
    of red, green, blue and alpha, or a file with `output`, as `balcony warp` writes it.

        view = balcony.warp("photo.jpg", "panorama", balcony.camera("pinhole", yaw="30deg"), size=(960, 540))

    The photo is a file, a picture, or an array (height, width) or (height, width, channels) of 1 to 4
    channels. Whole numbers, uint8 or uint16, are sRGB with straight alpha; floats are linear light,
    multiplied by alpha. The array that is returned has the type of the photo. `size` is that of the
    new picture: width and height, or the width.

    Both cameras have a single viewpoint, which is taken to be the same place; `allow_parallax` uses
    the directions of others alone.
    """
    if isinstance(photo, Picture):
        photo = photo["color"]
    elif isinstance(photo, (str, os.PathLike)):
        photo = os.fspath(photo)
    arguments = (photo, camera_of(camera)._camera, camera_of(source)._camera, sides_of(size),
                 str(layer), time, allow_parallax)
    if output is None:
        return _balcony.warp(*arguments)
    _balcony.save_warped(*arguments, os.fspath(output))
    return None


def animate(scene: Scene | str | os.PathLike, camera: Camera | str | os.PathLike | None,
            output: str | os.PathLike, frames: int | str | Iterable[int] | None = None, *,
            progress: bool | Callable[[float], object] = False, **options) -> list[str]:
    """Renders the frames of a film or a sequence, as `balcony animate` does, and returns their files.

        balcony.animate("room.glb", cam, "turn.mp4", 120, turntable=True, size=(640, 360))
        balcony.animate(scene, cam, "walk.####.exr", range(1, 49), samples=64)

    The camera and `progress` are as those of `Scene.render`; without a camera, it is that of the scene.
    `output` is the name of a film, or of a sequence with # for the digits of the number. `frames` is a
    number, a text such as "1-240x10", or several numbers; without it, there are as many as the animations
    of the scene need. Other options are those of `balcony animate`, with `_` for `-`.

    The same call continues after a stop: finished frames are kept, unless `overwrite=True`. Frames of
    another camera, of other options or files, or of a scene that was changed otherwise, are refused.
    """
    if not isinstance(scene, Scene):
        scene = Scene(scene, **{name: options.pop(name) for name in list(options)
                                if _balcony.is_scene_option(name)})
    own, of_scene = chosen(camera)
    if frames is not None:
        is_word = isinstance(frames, (str, int))
        options["frames"] = frames if is_word else ",".join(str(one) for one in frames)
    with _progress.shown(progress) as tell:
        return _balcony.animate(scene._scene, own, {**options, "output": os.fspath(output)}, of_scene, tell)
