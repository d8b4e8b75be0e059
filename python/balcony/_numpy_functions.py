# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The functions of NumPy that compute with expressions of formulas."""

from __future__ import annotations

import operator

import numpy as np

from . import formulas as f


def _radians(function):
    """The language has angles where NumPy has numbers."""
    return lambda *arguments: function(*arguments) / f.rad


def _log(base: float):
    return lambda x: f.log(x) / float(np.log(base))


# By the names of NumPy's functions.
_ELEMENTWISE = {
    "absolute": f.abs, "add": operator.add, "arccos": _radians(f.acos), "arccosh": f.acosh, "arcsin": _radians(f.asin),
    "arcsinh": f.asinh, "arctan": _radians(f.atan), "arctan2": _radians(f.atan2), "arctanh": f.atanh,
    "cbrt": lambda x: f.spow(x, 1 / 3), "ceil": lambda x: -f.floor(-x), "cos": f.cos, "cosh": f.cosh,
    "deg2rad": lambda x: x * float(np.pi / 180), "degrees": lambda x: x * float(180 / np.pi),
    "divide": operator.truediv, "equal": operator.eq, "exp": f.exp, "exp2": lambda x: 2**x,
    "expm1": lambda x: f.exp(x) - 1, "fabs": f.abs, "float_power": operator.pow, "floor": f.floor,
    "floor_divide": operator.floordiv, "fmax": f.max, "fmin": f.min, "greater": operator.gt,
    "greater_equal": operator.ge, "hypot": lambda x, y: f.sqrt(x**2 + y**2), "isfinite": f.is_finite,
    "less": operator.lt, "less_equal": operator.le, "log": f.log, "log10": _log(10),
    "log1p": lambda x: f.log(1 + x), "log2": _log(2), "logical_and": operator.and_,
    "logical_not": operator.invert, "logical_or": operator.or_, "maximum": f.max, "minimum": f.min,
    "mod": operator.mod, "multiply": operator.mul, "negative": operator.neg, "not_equal": operator.ne,
    "positive": operator.pos, "power": operator.pow, "rad2deg": lambda x: x * float(180 / np.pi),
    "radians": lambda x: x * float(np.pi / 180), "reciprocal": lambda x: 1 / x, "remainder": operator.mod,
    "sign": f.sign, "sin": f.sin, "sinh": f.sinh, "sqrt": f.sqrt,
    "square": lambda x: x**2, "subtract": operator.sub, "tan": f.tan, "tanh": f.tanh,
    "true_divide": operator.truediv, "bitwise_and": operator.and_, "bitwise_or": operator.or_,
    "invert": operator.invert,
    "clip": lambda x, least, most: f.min(f.max(x, least), most),
}


def method(name: str):
    """The function that has the name of an attribute; None without one."""
    return _ELEMENTWISE.get(name)


def _each(function, inputs):
    """The function of numbers and expressions, or of the elements of arrays."""
    if not any(isinstance(one, (np.ndarray, list, tuple)) and np.ndim(one) for one in inputs):
        # Beside an expression, what NumPy knows as a number is one.
        return function(*(one if isinstance(one, f.Expression) else f.as_expression(one) for one in inputs))
    boxes = []
    for one in inputs:
        box = np.empty((), object)
        box[()] = one
        boxes.append(box if isinstance(one, f.Expression) else np.asarray(one, object))
    return np.frompyfunc(lambda *parts: function(*map(f.as_expression, parts)), len(boxes), 1)(*boxes)


def _refuse(name: str):
    raise TypeError(f"the camera language has nothing for numpy.{name}: write it with other functions of "
                    "NumPy or of balcony.formulas")


def of_ufunc(ufunc, inputs):
    """A universal function of NumPy with expressions among its inputs."""
    function = _ELEMENTWISE.get(ufunc.__name__)
    return _each(function, inputs) if function else _refuse(ufunc.__name__)


def _where(condition, a, b):
    return _each(f.select, (condition, a, b))


def _clip(value, least, most):
    return _each(_ELEMENTWISE["clip"], (value, least, most))


_OTHERS = {"where": _where, "clip": _clip}


def of_function(function, arguments, options):
    """Another function of NumPy with expressions among its arguments."""
    made = _OTHERS.get(function.__name__)
    if made is None or options:
        _refuse(function.__name__)
    return made(*arguments)
