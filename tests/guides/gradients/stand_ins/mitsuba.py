# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The calls of Mitsuba 3 that exported sensors make and that its users make of them, on NumPy. For tests, as
Debian has no Mitsuba; it is not a part of Balcony."""

import enum

import numpy as np
from drjit import Array, Vector


class Float(Array):
    pass


class UInt32(Array):
    KIND, TYPE = "u", np.uint32


class Bool(Array):
    KIND, TYPE, FLOAT = "b", np.bool_, Float


Array.BOOL, Vector.FLOAT = Bool, Float


class Point2f(Vector):
    NAMES = "xy"


class Point3f(Vector):
    pass


class Vector3f(Vector):
    pass


class Spectrum(Vector):
    NAMES = "rgb"


class SurfaceInteraction3f:
    pass


class ScalarBoundingBox3f:
    pass


def set_variant(name):
    Float.TYPE = np.float64 if name.endswith("_double") else np.float32


class Ray3f:
    def __init__(self, o, d=None, time=0.0, wavelengths=None):
        self.o, self.d, self.time, self.wavelengths = (
            (o.o, o.d, o.time, o.wavelengths) if isinstance(o, Ray3f) else (o, d, time, wavelengths))


class RayDifferential3f(Ray3f):
    has_differentials = False


class Transform:
    """A matrix of 3 x 4 numbers."""

    def __init__(self, matrix=None):
        self.matrix = np.eye(3, 4) if matrix is None else matrix

    def __matmul__(self, v):
        shift = self.matrix[:, 3] * isinstance(v, Point3f)
        return type(v)(*(v.x * row[0] + v.y * row[1] + v.z * row[2] + float(add)
                         for row, add in zip(self.matrix, shift)))

    def look_at(self, origin, target, up):
        """z leads to the target, y is up as far as it can be, and x to the left."""
        z = np.subtract(target, origin) / np.linalg.norm(np.subtract(target, origin))
        x = np.cross(up, z) / np.linalg.norm(np.cross(up, z))
        return Transform(np.stack([x, np.cross(z, x), z, np.asarray(origin, float)], axis=1))

    def has_scale(self):
        turn = self.matrix[:, :3]
        return not np.allclose(turn @ turn.T, np.eye(3), atol=1e-6)


ScalarTransform4f = Transform


class Film:
    """size, crop_size and crop_offset are pairs."""

    def __init__(self, size, crop=None, offset=(0, 0)):
        self.all = size, crop or size, offset

    def size(self):
        return self.all[0]

    def crop_size(self):
        return self.all[1]

    def crop_offset(self):
        return self.all[2]


class ParamFlags(enum.IntFlag):
    Differentiable, NonDifferentiable = 0, 1


class Sensor:
    m_needs_sample_3 = False

    def __init__(self, props):
        film = props.get("film")
        self.m_film = Film((film["width"], film["height"])) if isinstance(film, dict) else film
        self.m_to_world = props.get("to_world", Transform())

    def film(self):
        return self.m_film

    def world_transform(self):
        return self.m_to_world

    def needs_aperture_sample(self):
        return self.m_needs_sample_3

    def sample_wavelengths(self, si, sample, active=True):
        assert isinstance(si, SurfaceInteraction3f)
        return None, Spectrum(1.0)

    def traverse(self, callback):
        pass

    def parameters_changed(self, keys=()):
        pass


_sensors = {}


def register_sensor(name, constructor):
    _sensors[name] = constructor


def load_dict(description):
    return _sensors[description["type"]](description)


class SceneParameters(dict):
    """What an object tells of itself, by name; a new value takes the place of the old one within the object."""

    def __init__(self, node):
        super().__init__()
        self.node, self.flags, self.changed = node, {}, []
        node.traverse(self)

    def put(self, name, value, flags):
        super().__setitem__(name, value)
        self.flags[name] = flags

    def __setitem__(self, name, value):
        old = self[name]
        old.__dict__.update(type(old)(value).__dict__ if isinstance(old, Float) else value.__dict__)
        self.changed.append(name)

    def update(self):
        self.node.parameters_changed(self.changed)
        self.changed = []


def traverse(node):
    return SceneParameters(node)
