# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Data sets: pictures of scenes through cameras in many poses, with their rays, depths and ids."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from . import _balcony, _progress

if TYPE_CHECKING:
    import numpy as np


class Frame(Mapping):
    """A frame of a data set. Its layers are arrays, which are read when they are asked for:
    `frame["rgb"]`, `frame["depth"]`, ... docs/datasets.md describes them."""

    __slots__ = ("_about", "_folder")

    def __init__(self, about: dict, folder: Path):
        self._about = about
        self._folder = folder

    @property
    def index(self) -> int:
        """Its number in the data set, from 0."""
        return self._about["index"]

    @property
    def name(self) -> str:
        """That of its files, without folder and ending."""
        return self._about["name"]

    @property
    def scene(self) -> str:
        return self._about["scene"]

    @property
    def camera(self) -> str:
        return self._about["camera"]

    @property
    def next(self) -> int | None:
        """The number of the frame to which its flow goes, if there is one."""
        return self._about["next"]

    @property
    def matrix(self) -> np.ndarray:
        """4 x 4, from the camera in the axes of the manifest to the world of the scene."""
        import numpy
        return numpy.array(self._about["matrix"])

    @property
    def files(self) -> dict[str, Path]:
        """By layer."""
        return {layer: self._folder / file for layer, file in self._about["files"].items()}

    @property
    def is_finished(self) -> bool:
        """Whether all its files are there. Those of another shard may not be."""
        return all(file.exists() for file in self.files.values())

    def __getitem__(self, layer: str) -> np.ndarray:
        import numpy
        if layer not in self._about["files"]:
            raise KeyError(f"the frame has no layer '{layer}'; "
                           + _balcony.suggestion(layer, list(self._about["files"]), "it has"))
        file = self.files[layer]
        if file.suffix == ".npy":
            return numpy.load(file)
        return _balcony.picture_in(os.fspath(file))

    def __iter__(self) -> Iterator[str]:
        return iter(self._about["files"])

    def __len__(self) -> int:
        return len(self._about["files"])

    def __repr__(self):
        return f"<balcony.Frame {self.index}: {self.scene}/{self.name}>"


class Dataset:
    """The frames of a data set in a folder: `balcony.Dataset("out")[0]["depth"]`."""

    __slots__ = ("folder", "manifest")

    def __init__(self, folder: str | os.PathLike, /):
        self.folder = Path(folder)
        #: What manifest.json has: axes, scenes, cameras with their intrinsics, frames.
        self.manifest = json.loads((self.folder / "manifest.json").read_text(encoding="utf-8"))

    def __len__(self) -> int:
        return len(self.manifest["frames"])

    def __getitem__(self, index: int) -> Frame:
        return Frame(self.manifest["frames"][index], self.folder)

    def __iter__(self) -> Iterator[Frame]:
        return (self[i] for i in range(len(self)))

    def camera(self, frame: Frame) -> dict:
        """What the manifest says about the camera of a frame: its size, its text, its intrinsics."""
        for scene in self.manifest["scenes"]:
            for camera in scene["cameras"]:
                if (scene["name"], camera["name"]) == (frame.scene, frame.camera):
                    return camera
        raise KeyError(frame.camera)

    def __repr__(self):
        return f"<balcony.Dataset {os.fspath(self.folder)}, {len(self)} frames>"


def dataset(recipe: str | os.PathLike | dict, folder: str | os.PathLike, *,
            progress: bool | Callable[[float], object] = False,
            shard: tuple[int, int] | None = None, overwrite: bool = False) -> Dataset:
    """Renders a data set into a folder, as `balcony dataset` does, and opens it.

    The recipe is a file in TOML, or a dictionary with the same entries. Frames that are finished are
    kept. `progress` draws a bar, or calls a function with the part that is done; `shard=(2, 5)`
    renders every fifth frame, from the second on.

        made = balcony.dataset({"scenes": ["room.glb"], "cameras": ["fisheye"],
                                "poses": [{"random": 20}], "render": {"size": (256, 256)}}, "out")
        made[0]["depth"]
    """
    file, text = ("", _toml_of(recipe)) if isinstance(recipe, dict) else (os.fspath(recipe), "")
    with _progress.shown(progress) as tell:
        _balcony.make_dataset(file, text, os.fspath(folder), shard, overwrite, tell)
    return Dataset(folder)


def _toml_of(recipe: dict) -> str:
    """A line for each entry, so that mistakes have a place that can be found."""
    return "".join(f"{_key(name)} = {_value(value, name)}\n"
                   for name, value in recipe.items() if value is not None)


def _key(name: object) -> str:
    if not isinstance(name, str):
        raise TypeError(f"{name!r} is no name of an entry of a recipe")
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else _quoted(name)


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: object, name: object) -> str:
    if hasattr(value, "tolist"):
        value = value.tolist()
    if hasattr(value, "__fspath__"):
        value = value.__fspath__()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_key(key)} = {_value(one, key)}"
                               for key, one in value.items() if one is not None) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(one, name) for one in value) + "]"
    raise TypeError(f"'{name}' is {value!r}, but a text, a number, a list or a dictionary is needed")
