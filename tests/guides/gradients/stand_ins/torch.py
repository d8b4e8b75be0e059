# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The calls of PyTorch that exported cameras make, on NumPy: its promotion of types, gradients in reverse,
and 0 times infinity in them. For tests where PyTorch is not installed; it is not a part of Balcony."""

import functools
from math import inf, nan  # noqa: F401 (as torch has them)

import numpy as np
from taped import BINARY, ELEMENTARY, Taped, gradients

float64, float32, int64 = np.dtype("float64"), np.dtype("float32"), np.dtype("int64")
bool = np.dtype("bool")  # noqa: A001 (as torch has it)
_learning = [True]


class _Learning:
    """A context and a decorator that turns gradients on or off."""

    def __init__(self, on):
        self.on = on

    def __enter__(self):
        _learning.append(self.on)

    def __exit__(self, *_):
        _learning.pop()

    def __call__(self, function):
        @functools.wraps(function)
        def decorated(*given, **named):
            with _Learning(self.on):
                return function(*given, **named)
        return decorated


def no_grad():
    return _Learning(False)


def is_grad_enabled():
    return _learning[-1]


def get_default_dtype():
    return float32


def promote_types(a, b):
    return np.promote_types(a, b)


def _category(dtype):
    return "bif".index(dtype.kind)


def _common(operands):
    """The dtype of a result: tensors with dimensions decide, then those without, then numbers; the latter
    only if they are of a higher category."""
    first, *others = operands
    if is_tensor(first) and all(is_tensor(a) and a.dtype == first.dtype for a in others):
        return first.dtype
    tensors = [a for a in operands if is_tensor(a)]
    numbers = [{"b": bool, "i": int64, "f": float32}[np.asarray(a).dtype.kind]
               for a in operands if not is_tensor(a)]
    best = None
    for group in ([a.dtype for a in tensors if a.ndim], [a.dtype for a in tensors if not a.ndim], numbers):
        if group:
            dtype = functools.reduce(np.promote_types, group)
            if best is None or _category(dtype) > _category(best):
                best = dtype
    return best


def _made(value, parents=()):
    if not parents or not _learning[-1]:
        return Tensor(value)
    return Tensor(value, tuple((a, factor) for a, factor in parents if is_tensor(a) and a.learns))


def _values(operands, dtype):
    return [(a.value if is_tensor(a) else np.asarray(a)).astype(dtype, copy=False) for a in operands]


def _alike(a, b):
    """The values of two operands as they are, or None: two tensors of one dtype, or one of floats with a
    number, as most operands are."""
    if type(a) is Tensor:
        x = a.value
        if type(b) is Tensor:
            return (x, b.value) if x.dtype == b.value.dtype else None
        return (x, np.asarray(b, x.dtype)) if x.dtype.kind == "f" and type(b) in (float, int) else None
    if type(a) in (float, int) and type(b) is Tensor and b.value.dtype.kind == "f":
        return np.asarray(a, b.value.dtype), b.value
    return None


def _floating(dtype):
    return dtype if dtype.kind == "f" else float32


def _unary(name):
    function, derivative = ELEMENTARY[name]

    def call(a):
        x = a.value if name in ("negative", "abs") else a.value.astype(_floating(a.dtype), copy=False)
        y = function(x)
        return _made(y, [(a, derivative(x, y))] if a.learns else [])
    return call


def _binary(name):
    function, *derivatives = BINARY[name]

    def call(*operands):
        values = _alike(*operands)
        if values is None or (name == "divide" and values[0].dtype.kind != "f"):
            dtype = _common(operands)
            values = _values(operands, _floating(dtype) if name == "divide" else dtype)
        y = function(*values)
        if not _learning[-1]:
            return Tensor(y)
        return _made(y, [(a, d(*values, y)) for a, d in zip(operands, derivatives)
                         if is_tensor(a) and a.learns])
    return call


def _comparison(function):
    def call(a, b):
        return Tensor(function(*(_alike(a, b) or _values((a, b), _common((a, b))))))
    return call


def _swapped(call):
    return lambda a, b: call(b, a)


class Tensor(Taped):
    dtype = property(lambda self: self.value.dtype)
    shape = property(lambda self: self.value.shape)
    ndim = property(lambda self: self.value.ndim)
    device = "cpu"
    requires_grad = property(lambda self: self.learns)
    grad = property(lambda self: None if self.gradient is None else Tensor(self.gradient.value))

    __add__ = __radd__ = _binary("add")
    __mul__ = __rmul__ = _binary("multiply")
    __sub__, __truediv__ = _binary("subtract"), _binary("divide")
    __rsub__, __rtruediv__ = _swapped(_binary("subtract")), _swapped(_binary("divide"))
    __mod__, __floordiv__ = _binary("remainder"), _binary("floor_divide")
    __pow__ = _binary("power")
    __neg__ = _unary("negative")
    __lt__, __le__ = _comparison(np.less), _comparison(np.less_equal)
    __gt__, __ge__ = _comparison(np.greater), _comparison(np.greater_equal)
    __eq__, __ne__ = _comparison(np.equal), _comparison(np.not_equal)
    __and__ = __rand__ = _comparison(np.logical_and)
    __or__ = __ror__ = _comparison(np.logical_or)
    __hash__ = object.__hash__

    def __invert__(self):
        return Tensor(~self.value)

    def __len__(self):
        return len(self.value)

    def __bool__(self):
        return self.value.__bool__()

    def __float__(self):
        return float(self.value)

    def __format__(self, how):
        return format(self.value.item(), how) if self.ndim == 0 else str(self.value)

    def __array__(self, dtype=None):
        return self.value.astype(dtype or self.dtype)

    def __getitem__(self, at):
        at = _index(at)
        whole = self.value.shape

        def spread(gradient):
            made = np.zeros(whole, gradient.dtype)
            np.add.at(made, at, gradient)
            return made
        return _made(self.value[at], [(self, spread)])

    def __setitem__(self, at, value):
        self.value[_index(at)] = value.value if is_tensor(value) else value

    def dim(self):
        return self.ndim

    def is_floating_point(self):
        return self.dtype.kind == "f"

    def to(self, other):
        dtype = other.dtype if is_tensor(other) else other
        return _made(self.value.astype(dtype), [(self, lambda g: g.astype(self.dtype))])

    def double(self):
        return self.to(float64)

    def long(self):
        return Tensor(self.value.astype(int64))

    def detach(self):
        return Tensor(self.value)

    def clone(self):
        return _made(self.value.copy(), [(self, lambda g: g)])

    def numpy(self):
        return self.value

    def item(self):
        return self.value.item()

    def tolist(self):
        return self.value.tolist()

    def reshape(self, *shape):
        shape = shape[0] if len(shape) == 1 and not isinstance(shape[0], int) else shape
        own = self.value.shape
        return _made(self.value.reshape(shape), [(self, lambda g: g.reshape(own))])

    def clip(self, low, high):
        return Tensor(np.minimum(np.maximum(self.value, low), high))

    def all(self, dim):
        return Tensor(self.value.all(dim))

    def sum(self, dim=None):
        def spread(gradient):
            gradient = gradient if dim is None else np.expand_dims(gradient, dim)
            return np.broadcast_to(gradient, self.value.shape)
        return _made(self.value.sum(dim, dtype=self.dtype), [(self, spread)])

    def mean(self):
        return self.sum() / self.value.size

    def index_put(self, at, values):
        at = _index(at)
        made = self.value.copy()
        made[at] = values.value

        def rest(gradient):
            gradient = gradient.copy()
            gradient[at] = 0
            return gradient
        return _made(made, [(self, rest), (values, lambda g: g[at])])

    def requires_grad_(self):
        self.learns = True
        return self

    @grad.setter
    def grad(self, value):
        self.gradient = value

    def backward(self, retain_graph=False):  # noqa: ARG002 (it always is)
        for node, gradient in gradients(self, np.ones_like(self.value), np.multiply):
            if not node.parents and node.learns:
                old = 0 if node.gradient is None else node.gradient.value
                node.gradient = Tensor(gradient + old)


def _index(at):
    at = at if isinstance(at, tuple) else (at,)
    return tuple(a.value if is_tensor(a) else a for a in at)


def is_tensor(a):
    return isinstance(a, Tensor)


def tensor(values, dtype=None, requires_grad=False):
    made = np.array(values)
    made = Tensor(made.astype(dtype or (float32 if made.dtype.kind == "f" else made.dtype)))
    return made.requires_grad_() if requires_grad else made


def as_tensor(a, dtype=None, device=None):  # noqa: ARG001 (there is one device)
    if is_tensor(a):
        return a if dtype in (None, a.dtype) else a.to(dtype)
    if isinstance(a, (np.ndarray, np.generic)):
        return Tensor(a.astype(dtype or a.dtype))
    return tensor(a, dtype)


def arange(n, dtype=None, device=None):  # noqa: ARG001
    return Tensor(np.arange(n, dtype=dtype or int64))


def meshgrid(*axes, indexing):
    return [Tensor(a) for a in np.meshgrid(*(a.value for a in axes), indexing=indexing)]


def full_like(a, value):
    return Tensor(np.full_like(a.value, value))


def zeros_like(a):
    return Tensor(np.zeros_like(a.value))


def where(condition, a, b):
    values = _values((a, b), _common((a, b)))
    c = condition.value
    return _made(np.where(c, *values), [(a, lambda g: np.where(c, g, np.zeros_like(g))),
                                        (b, lambda g: np.where(c, np.zeros_like(g), g))])


def stack(tensors, dim=0):
    dtype = _common(tensors)
    axis = dim % (tensors[0].ndim + 1)
    return _made(np.stack(_values(tensors, dtype), axis),
                 [(a, functools.partial(np.take, indices=i, axis=axis)) for i, a in enumerate(tensors)])


def broadcast_tensors(*tensors):
    shape = np.broadcast_shapes(*(a.shape for a in tensors))
    return [_made(np.broadcast_to(a.value, shape), [(a, lambda g: g)]) for a in tensors]


def nonzero(a, as_tuple):
    assert as_tuple
    return tuple(Tensor(one) for one in a.value.nonzero())


def sort(a, dim, stable):
    assert stable
    order = np.argsort(a.value, axis=dim, kind="stable")
    return Tensor(np.take_along_axis(a.value, order, dim)), Tensor(order)


def isfinite(a):
    return Tensor(np.isfinite(a.value))


def isnan(a):
    return Tensor(np.isnan(a.value))


def logical_not(a):
    return Tensor(np.logical_not(a.value))


def nan_to_num(a):
    return Tensor(a.value if np.isfinite(a.value).all() else np.nan_to_num(a.value))


def hypot(a, b):
    return _binary("hypot")(a, b)


def sign(a):
    """As in PyTorch, that of what is not a number is 0."""
    return Tensor(np.nan_to_num(np.sign(a.value)))


def pow(a, b):  # noqa: A001 (as torch has it)
    return _binary("power")(a, b)


def arctan2(a, b):
    return _binary("arctan2")(a, b)


for _name in ("abs", "floor", "sqrt", "exp", "log", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh",
              "cosh", "tanh", "arcsinh", "arccosh", "arctanh"):
    globals()[_name] = _unary(_name)


class optim:  # noqa: N801 (a module in torch)
    class Adam:
        def __init__(self, parameters, lr):
            self.parameters, self.rate, self.steps = list(parameters), lr, 0
            self.means = [(0.0, 0.0) for _ in self.parameters]

        def zero_grad(self):
            for one in self.parameters:
                one.gradient = None

        def step(self):
            self.steps += 1
            for i, one in enumerate(self.parameters):
                g = one.gradient.value
                mean = 0.9 * self.means[i][0] + 0.1 * g
                square = 0.999 * self.means[i][1] + 0.001 * g * g
                self.means[i] = mean, square
                mean, square = mean / (1 - 0.9**self.steps), square / (1 - 0.999**self.steps)
                one.value = one.value - (self.rate * mean / (np.sqrt(square) + 1e-8)).astype(one.dtype)
