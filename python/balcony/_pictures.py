# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Rendered pictures and their layers."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

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

    def __init__(self, film, exposure: float | None, camera: str, view: str, dither: bool):
        self._film, self._camera = film, camera
        self._exposure = film.exposure() if exposure is None else exposure
        self._view, self._dither = view, dither
        self._about = {"color": "linear light: red, green and blue, multiplied by alpha, and alpha",
                       **dict(film.layers())}
        self._arrays: dict[str, np.ndarray] = {}

    @property
    def width(self) -> int:
        """In pixels."""
        return self._film.size()[0]

    @property
    def height(self) -> int:
        return self._film.size()[1]

    @property
    def camera(self) -> str:
        """The name of the camera."""
        return self._camera

    @property
    def exposure(self) -> float:
        """In stops: how a display shows the light. It suits the picture, unless it was asked for."""
        return self._exposure

    @property
    def about(self) -> dict[str, str]:
        """What each layer is."""
        return dict(self._about)

    @property
    def objects(self) -> list[str]:
        """The names of the objects of the layer "object"."""
        return self._film.objects

    @property
    def materials(self) -> list[str]:
        return self._film.materials

    def __getitem__(self, name: str) -> np.ndarray:
        name = _OTHER_NAMES.get(name, name)
        if name not in self._about:
            import difflib  # It takes 10 ms to import, which most programs do not need.

            near = difflib.get_close_matches(str(name), self._about, 1)
            hint = f"did you mean '{near[0]}'?" if near else f"it has {', '.join(self._about)}"
            raise KeyError(f"the picture has no layer '{name}': {hint}")
        if name not in self._arrays:
            self._arrays[name] = (self._film.color() if name == "color"
                                  else self._film.layer(name))
        return self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._about)

    def __len__(self) -> int:
        return len(self._about)

    def pixels(self, exposure: float | None = None) -> np.ndarray:
        """(height, width, 3), uint8: sRGB, as a display shows the picture."""
        return self._film.pixels(*self._shown(exposure))

    def save(self, file: str | os.PathLike, exposure: float | None = None) -> None:
        """Writes a file by its extension: .exr has all layers, .png, .jpg, .webp and .tif what a display
        shows."""
        self._film.write(os.fspath(file), *self._shown(exposure))

    def _shown(self, exposure):
        return self._exposure if exposure is None else exposure, self._view, self._dither

    def __repr__(self):
        return f"<balcony.Picture {self.camera}, {self.width} x {self.height}: {', '.join(self)}>"

    def _repr_png_(self) -> bytes:
        return self._film.png(*self._shown(None))
