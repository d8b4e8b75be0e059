# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Arrays of NumPy that remember how they were computed, for derivatives: what the stand-ins of PyTorch
and of Dr.Jit are made of."""

import numpy as np

# Neither of them warns of results that are no numbers.
np.seterr(all="ignore")

# Functions of one number, and their derivatives by it at x with the value y.
ELEMENTARY = {
    "negative": (np.negative, lambda x, y: -np.ones_like(x)),
    "abs": (np.abs, lambda x, y: np.sign(x)),
    "sign": (np.sign, lambda x, y: np.zeros_like(x)),
    "floor": (np.floor, lambda x, y: np.zeros_like(x)),
    "sqrt": (np.sqrt, lambda x, y: 0.5 / y),
    "exp": (np.exp, lambda x, y: y),
    "log": (np.log, lambda x, y: 1 / x),
    "sin": (np.sin, lambda x, y: np.cos(x)),
    "cos": (np.cos, lambda x, y: -np.sin(x)),
    "tan": (np.tan, lambda x, y: 1 + y * y),
    "arcsin": (np.arcsin, lambda x, y: 1 / np.sqrt(1 - x * x)),
    "arccos": (np.arccos, lambda x, y: -1 / np.sqrt(1 - x * x)),
    "arctan": (np.arctan, lambda x, y: 1 / (1 + x * x)),
    "sinh": (np.sinh, lambda x, y: np.cosh(x)),
    "cosh": (np.cosh, lambda x, y: np.sinh(x)),
    "tanh": (np.tanh, lambda x, y: 1 - y * y),
    "arcsinh": (np.arcsinh, lambda x, y: 1 / np.sqrt(x * x + 1)),
    "arccosh": (np.arccosh, lambda x, y: 1 / np.sqrt(x * x - 1)),
    "arctanh": (np.arctanh, lambda x, y: 1 / (1 - x * x)),
}


def _by_exponent(a, b, y):
    return np.where((a == 0) & (b >= 0), np.zeros_like(y), y * np.log(a))


def _by_base(a, b, y):
    return np.where(b == 0, np.zeros_like(y), b * np.power(a, b - 1))


# Functions of two numbers, and their derivatives by each.
BINARY = {
    "add": (np.add, lambda a, b, y: np.ones_like(y), lambda a, b, y: np.ones_like(y)),
    "subtract": (np.subtract, lambda a, b, y: np.ones_like(y), lambda a, b, y: -np.ones_like(y)),
    "multiply": (np.multiply, lambda a, b, y: b, lambda a, b, y: a),
    "divide": (np.divide, lambda a, b, y: 1 / b, lambda a, b, y: -y / b),
    "power": (np.power, _by_base, _by_exponent),
    "arctan2": (np.arctan2, lambda a, b, y: b / (a * a + b * b), lambda a, b, y: -a / (a * a + b * b)),
    "hypot": (np.hypot, lambda a, b, y: a / y, lambda a, b, y: b / y),
    "remainder": (np.remainder, lambda a, b, y: np.ones_like(y), lambda a, b, y: -np.floor(a / b)),
    "floor_divide": (np.floor_divide, lambda a, b, y: np.zeros_like(y), lambda a, b, y: np.zeros_like(y)),
}


def reduced(gradient, shape):
    """A gradient of a broadcast array as one of the array."""
    gradient = gradient.sum(axis=tuple(range(gradient.ndim - len(shape))))
    axes = tuple(i for i, n in enumerate(shape) if n == 1 and gradient.shape[i] != 1)
    return gradient.sum(axis=axes, keepdims=True) if axes else gradient


class Taped:
    """An array; `parents` are pairs of an array that it is made of, and of what becomes of a gradient
    there: a factor, or a function."""

    def __init__(self, value, parents=()):
        self.value = np.asarray(value)
        self.parents = parents
        self.learns = bool(parents)
        self.gradient = None


def topological(root):
    """The arrays that one is made of, itself last."""
    order, seen, stack = [], set(), [(root, False)]
    while stack:
        node, done = stack.pop()
        if done:
            order.append(node)
        elif id(node) not in seen:
            seen.add(id(node))
            stack.append((node, True))
            stack += [(parent, False) for parent, _ in node.parents]
    return order


def gradients(root, seed, product):
    """The gradients of a root by the arrays that it is made of, as (array, gradient); product(g, d)
    multiplies a gradient by a derivative."""
    found = {id(root): np.asarray(seed)}
    order = topological(root)
    for node in reversed(order):
        gradient = found.get(id(node))
        if gradient is None:
            continue
        for parent, factor in node.parents:
            part = factor(gradient) if callable(factor) else product(gradient, factor)
            part = reduced(np.asarray(part), parent.value.shape)
            old = found.get(id(parent))
            found[id(parent)] = part if old is None else old + part
    return [(node, found[id(node)]) for node in order if id(node) in found]
