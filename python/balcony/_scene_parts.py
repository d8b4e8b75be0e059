# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The parts of a scene, to be changed: objects, materials and lights."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Union

from . import _balcony

if TYPE_CHECKING:
    import numpy as np

PartName = Union[str, int]
"""The name of a part, or its number, as in `scene.objects`, if others have the same name or it has none."""

_edits = _balcony.edits


class Property(NamedTuple):
    """A property of a material or a light as it stands."""

    meaning: str
    value: bool | float | tuple[float, float, float]
    range: tuple[float, float]
    """The least and the greatest number that it may have."""


class _Part:
    """Found by its name again each time, so that it is an error once the scene does not have it."""

    __slots__ = ("_scene", "_name")

    def __init__(self, scene, name: PartName):
        object.__setattr__(self, "_scene", scene)
        object.__setattr__(self, "_name", name)

    @property
    def name(self) -> PartName:
        """By which it was asked for."""
        return self._name

    def __repr__(self):
        return f"<balcony.{type(self).__name__} {self._name!r}>"


class Object(_Part):
    """An object of a scene: `scene["chair"]`.

    Matrices are for column vectors in the axes of the scene: the last column of `matrix` is where the
    origin of the object's mesh is.
    """

    __slots__ = ()

    def __init__(self, scene, name: PartName):
        super().__init__(scene, name)
        _edits.object(scene, name)  # There is such an object.

    @property
    def matrix(self) -> np.ndarray:
        """(4, 4), float64: from the mesh to the scene. An object that gets another one stands there at
        all times, also if its file moves it."""
        return _edits.matrix(self._scene, self._name)

    @matrix.setter
    def matrix(self, matrix) -> None:
        _edits.place(self._scene, self._name, matrix)

    @property
    def bounds(self) -> np.ndarray:
        """(2, 3), float64: the least and the greatest coordinates of its vertices."""
        return _edits.bounds(self._scene, self._name)

    def transform(self, matrix) -> Object:
        """Transforms it in the scene by a matrix (4, 4). If its file moves it, its path is transformed."""
        _edits.transform(self._scene, self._name, matrix)
        return self

    def move(self, dx: float, dy: float, dz: float) -> Object:
        """Moves it along the axes of the scene, in scene units. If its file moves it, its path is moved."""
        return self.transform([[1, 0, 0, dx], [0, 1, 0, dy], [0, 0, 1, dz], [0, 0, 0, 1]])

    def remove(self) -> None:
        """Removes it from the scene. The numbers of the objects behind it become less by one."""
        _edits.remove_object(self._scene, self._name)

    def __setattr__(self, name: str, value):
        if name != "matrix":
            raise AttributeError(f"'{name}' cannot be set")
        object.__setattr__(self, name, value)


class _PartWithProperties(_Part):
    __slots__ = ()

    def _told(self) -> list:
        raise NotImplementedError

    def _set(self, values: dict) -> None:
        raise NotImplementedError

    def __init__(self, scene, name: PartName):
        super().__init__(scene, name)
        self._told()  # There is such a part.

    @property
    def properties(self) -> dict[str, Property]:
        """All properties by name, as they stand."""
        return {name: Property(*others) for name, *others in self._told()}

    def set(self, **values):
        """Gives several properties other values at once. Returns the part."""
        self._set(values)
        return self

    def __getattr__(self, name: str):
        if name.startswith("_"):
            raise AttributeError(name)
        known = self.properties
        if name in known:
            return known[name].value
        hint = _balcony.suggestion(name, list(known), "its properties are")
        raise AttributeError(f"{self!r} has no property '{name}': {hint}")

    def __setattr__(self, name: str, value):
        if name.startswith("_") or hasattr(type(self), name):
            raise AttributeError(f"'{name}' cannot be set")
        self._set({name: value})

    def __dir__(self):
        return [*super().__dir__(), *self.properties]


class Material(_PartWithProperties):
    """A material of a scene: `scene.material("wood").roughness = 0.4`. All meshes that have it change.

    Its properties are attributes; `properties` says what they mean. Colours are linear red, green and
    blue, or one number for a grey. Numbers are factors of the textures that the material has.
    """

    __slots__ = ()

    def _told(self) -> list:
        return _edits.material(self._scene, self._name)

    def _set(self, values: dict) -> None:
        _edits.set_material(self._scene, self._name, values)


class Light(_PartWithProperties):
    """A light of a scene: `scene.light("lamp").position = (0, 2, 0)`.

    Its properties are attributes; `properties` says what they mean. A light that gets a position or a
    direction keeps it at all times, also if its file moves it.
    """

    __slots__ = ()

    def _told(self) -> list:
        return _edits.light(self._scene, self._name)

    def _set(self, values: dict) -> None:
        _edits.set_light(self._scene, self._name, values)

    @property
    def kind(self) -> str:
        """"point", "spot" or "sun"."""
        return _edits.light_kind(self._scene, self._name)

    def remove(self) -> None:
        """Removes it from the scene. The numbers of the lights behind it become less by one."""
        _edits.remove_light(self._scene, self._name)
