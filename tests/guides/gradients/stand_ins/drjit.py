# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The calls of Dr.Jit that exported sensors make, on NumPy, and its gradients, in which 0 times infinity is
0. For tests, as Debian has no Dr.Jit; it is not a part of Balcony."""

import numpy as np
from taped import BINARY, ELEMENTARY, Taped, gradients


def _binary(name):
    function, *derivatives = BINARY[name]

    def call(*operands):
        kind = next(type(a) for a in (*(a for a in operands if isinstance(a, Array) and a.KIND == "f"),
                                      *operands) if isinstance(a, Array))
        values = [kind.of(a) for a in operands]
        y = function(*values)
        return kind(y, [(a, d(*values, y)) for a, d in zip(operands, derivatives)
                        if isinstance(a, Array) and a.learns])
    return lambda a, b: NotImplemented if isinstance(b, Vector) else call(a, b)


def _comparison(function):
    def call(a, b):
        return a.BOOL(function(_value(a), _value(b)))
    return call


def _swapped(call):
    return lambda a, b: call(b, a)


def _value(a):
    return a.value if isinstance(a, Array) else a


class Array(Taped):
    """An array of numbers of one type; KIND is that of NumPy, TYPE the whole type."""

    KIND, TYPE, BOOL = "f", np.float32, None

    def __init__(self, value=0, parents=()):
        if isinstance(value, Array):
            parents = [(value, lambda g: g)] if value.learns else ()
        super().__init__(type(self).of(value), tuple(parents))

    @classmethod
    def of(cls, a):
        return np.asarray(_value(a)).astype(cls.TYPE)

    __add__ = __radd__ = _binary("add")
    __mul__ = __rmul__ = _binary("multiply")
    __sub__, __truediv__ = _binary("subtract"), _binary("divide")
    __rsub__, __rtruediv__ = _swapped(_binary("subtract")), _swapped(_binary("divide"))
    __lt__, __le__ = _comparison(np.less), _comparison(np.less_equal)
    __gt__, __ge__ = _comparison(np.greater), _comparison(np.greater_equal)
    __eq__, __ne__ = _comparison(np.equal), _comparison(np.not_equal)
    __and__ = __rand__ = _comparison(np.logical_and)
    __or__ = __ror__ = _comparison(np.logical_or)
    __xor__ = __rxor__ = _comparison(np.logical_xor)
    __hash__ = object.__hash__

    def __neg__(self):
        return _unary("negative")(self)


class Vector:
    """Components by name."""

    NAMES = "xyz"

    def __init__(self, *components):
        if len(components) == 1:
            one = components[0]
            components = one.all if isinstance(one, Vector) else [one] * len(self.NAMES)
        self.all = [c if isinstance(c, Array) else self.FLOAT(c) for c in components]

    def __getattr__(self, name):
        if name in self.NAMES:
            return self.all[self.NAMES.index(name)]
        raise AttributeError(name)

    def __add__(self, other):
        return type(self)(*(a + b for a, b in zip(self.all, other.all, strict=True)))

    def __mul__(self, factor):
        return type(self)(*(a * factor for a in self.all))

    __rmul__ = __mul__


def _unary(name):
    function, derivative = ELEMENTARY[name]

    def call(a):
        if not isinstance(a, Array):
            return float(function(a))
        y = function(a.value)
        return type(a)(y, [(a, derivative(a.value, y))] if a.learns else ())
    return call


for _ours, _theirs in {"arcsin": "asin", "arccos": "acos", "arctan": "atan", "arcsinh": "asinh",
                       "arccosh": "acosh", "arctanh": "atanh"}.items():
    globals()[_theirs] = _unary(_ours)
for _name in ("abs", "floor", "sqrt", "exp", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh"):
    globals()[_name] = _unary(_name)


def power(a, b):
    return _binary("power")(a, b)


def atan2(a, b):
    return _binary("arctan2")(a, b)


def minimum(a, b):
    return select(b < a, b, a)


def isfinite(a):
    return a.BOOL(np.isfinite(a.value))


def select(condition, a, b):
    vector = next((one for one in (a, b) if isinstance(one, Vector)), None)
    if vector is not None:
        a, b = (one if isinstance(one, Vector) else type(vector)(one) for one in (a, b))
        return type(vector)(*(select(condition, p, q) for p, q in zip(a.all, b.all, strict=True)))
    if not isinstance(condition, Array):
        return a if condition else b
    kind = next(type(one) for one in (a, b, condition.FLOAT()) if isinstance(one, Array))
    c = condition.value
    return kind(np.where(c, kind.of(a), kind.of(b)),
                [(one, lambda g, where=where: np.where(where, g, 0))
                 for one, where in ((a, c), (b, ~c)) if isinstance(one, Array) and one.learns])


def gather(kind, source, index):
    return kind(source.value[index.value])


def normalize(v):
    length = sqrt(sum((c * c for c in v.all[1:]), v.all[0] * v.all[0]))
    return type(v)(*(c / length for c in v.all))


def zeros(kind):
    return kind()


def make_opaque(*arrays):
    assert all(isinstance(a, Array) for a in arrays)


def enable_grad(a):
    a.learns = True


def disable_grad(a):
    a.learns = False


def grad(a):
    return a.gradient


def backward(a):
    """Where a gradient is 0, so is its product with anything."""
    def product(g, d):
        return np.where(g == 0, 0, g * d)

    for node, gradient in gradients(a, np.ones_like(a.value), product):
        if not node.parents and node.learns:
            node.gradient = type(node)(gradient)
