# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Rendered pictures and their layers."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from . import _balcony

if TYPE_CHECKING:
    import numpy as np

# What others call a layer.
_OTHER_NAMES = {"depth": "ray_length", "rgb": "color", "rgba": "color"}


class Picture(Mapping):
    """A rendered picture: its layers by name, as arrays of float32.

    `picture["color"]` is (height, width, 4): linear red, green and blue, multiplied by alpha, and alpha.
    `picture["ray_length"]`, or "depth", is (height, width): the distance along the ray, in scene units.
    `about` says what the others are. Numbers of objects are indices into `objects` plus 1; 0 is none.
    """

    def __init__(self, picture):
        self._picture = picture
        self._about = {"color": "linear light: red, green and blue, multiplied by alpha, and alpha",
                       **dict(picture.layers())}
        self._arrays: dict[str, np.ndarray] = {}

    @property
    def width(self) -> int:
        """In pixels."""
        return self._picture.size()[0]

    @property
    def height(self) -> int:
        return self._picture.size()[1]

    @property
    def camera(self) -> str:
        """The name of the camera."""
        return self._picture.camera

    @property
    def exposure(self) -> float:
        """In stops: how a display shows the light. It suits the picture, unless it was asked for."""
        return self._picture.exposure()

    @property
    def about(self) -> dict[str, str]:
        """What each layer is."""
        return dict(self._about)

    @property
    def objects(self) -> list[str]:
        """The names of the objects of the layer "object"."""
        return self._picture.objects()

    @property
    def materials(self) -> list[str]:
        return self._picture.materials()

    def __getitem__(self, name: str) -> np.ndarray:
        name = _OTHER_NAMES.get(name, name)
        if name not in self._about:
            hint = _balcony.suggestion(str(name), list(self), "the layers are")
            raise KeyError(f"the picture has no layer '{name}': {hint}")
        if name not in self._arrays:
            self._arrays[name] = (self._picture.color() if name == "color"
                                  else self._picture.layer(name))
        return self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._about)

    def __len__(self) -> int:
        return len(self._about)

    def pixels(self, exposure: float | None = None) -> np.ndarray:
        """(height, width, 3), uint8: sRGB, as a display shows the picture."""
        return self._picture.pixels(exposure)

    def save(self, file: str | os.PathLike, exposure: float | None = None) -> None:
        """Writes a file by its extension: .exr has all layers, .png, .jpg, .webp and .tif what a display
        shows."""
        self._picture.save(os.fspath(file), exposure)

    def __repr__(self):
        return f"<balcony.Picture {self.camera}, {self.width} x {self.height}: {', '.join(self)}>"

    def _repr_png_(self) -> bytes:
        return self._picture.png()
