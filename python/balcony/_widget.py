# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""A picture with sliders, for notebooks."""

from __future__ import annotations

import math
import os
from pathlib import Path

from ._cameras import Camera, Parameter, camera_of
from ._scenes import Scene
from .errors import Error


class View:
    """A picture of a scene through a camera of its own, whose parameters sliders change."""

    def __init__(self, scene: Scene, camera: Camera, options: dict):
        self._scene, self._camera, self._options = scene, camera.copy(), options
        self._units = {one.name: math.pi / 180 if one.is_angle else 1.0
                       for one in camera.parameters.values() if one.value is not None}

    @property
    def sliders(self) -> list[dict]:
        """Of each parameter that is a number: its name, value, least and greatest value, and unit."""
        return [self._slider(one) for one in self._camera.parameters.values() if one.value is not None]

    def _slider(self, one: Parameter) -> dict:
        # Where nothing limits a parameter, what is near.
        reach = math.pi if one.is_angle else 2 * max(1.0, abs(one.value))
        least, most = one.range
        least = least if math.isfinite(least) else min(one.value, most) - reach
        most = most if math.isfinite(most) else max(one.value, least) + reach
        unit = self._units[one.name]
        return {"name": one.name, "value": one.value / unit, "least": least / unit, "most": most / unit,
                "unit": "°" if one.is_angle else ""}

    def picture(self, values: dict[str, float] | None = None) -> tuple[bytes, str]:
        """The picture with values of sliders as PNG, and an empty text; or an error, after which nothing
        has changed."""
        try:
            if values:
                self._camera.set(**{name: value * self._units[name] for name, value in values.items()})
            return self._scene.render(self._camera, **self._options)._repr_png_(), ""
        except Error as error:
            return b"", error.message


def widget(scene: Scene | str | os.PathLike, camera: Camera | str | os.PathLike, *,
           size: tuple[int, int] = (480, 270), samples: int = 4, **options):
    """A picture with a slider for each parameter of the camera, for notebooks. It needs the package anywidget.

        balcony.widget("room.glb", "fisheye")

    Options are those of `Scene.render`. The camera that is given stays as it is; `widget.values` are the
    values of the sliders.
    """
    try:
        import anywidget
        import traitlets
    except ImportError as error:
        raise ImportError("balcony.widget needs the package anywidget: pip install anywidget") from error

    scene = scene if isinstance(scene, Scene) else Scene(scene)
    view = View(scene, camera_of(camera), {"size": size, "samples": samples, **options})

    class Viewer(anywidget.AnyWidget):
        _esm = Path(__file__).with_name("_widget.js")
        sliders = traitlets.List().tag(sync=True)
        values = traitlets.Dict().tag(sync=True)
        picture = traitlets.Bytes().tag(sync=True)
        message = traitlets.Unicode().tag(sync=True)
        done = traitlets.Int().tag(sync=True)

        @traitlets.observe("values")
        def _changed(self, change):
            picture, self.message = view.picture(change["new"])
            self.picture = picture or self.picture
            self.done += 1

    picture, message = view.picture()
    return Viewer(sliders=view.sliders, picture=picture, message=message)
