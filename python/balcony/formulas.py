# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Formulas of the camera language, written in Python.

A function of Python becomes a formula: it is called once with symbols, and what it computes with them is
written down. So its derivatives, its inverse and its exports are exact, as those of all formulas.

    import balcony
    import numpy as np
    from balcony import stages

    def ripple(u, v):
        return u, v, 0.1 * np.sin(8 * np.hypot(u, v))

    cam = balcony.compose(eye=stages.surface(ripple), map=((1, -1), "square"), look="normal")

Operators, the functions of this module and those of NumPy that the language has, such as `np.sin`,
`np.where` and `np.hypot`, compute with symbols, also in arrays of them. A function that has to know a
value, by `if`, `float()` or `math.sin`, raises a TypeError: `select` and `np.where` choose instead.

`parameter` is a parameter of the camera, `expression` any expression of the language, `t` the time in
seconds, `pi` the number. `deg` and `rad` are angles: `30 * deg` is one, and `u / rad` is a number.
"""

from __future__ import annotations

import math
import numbers
import re
from collections.abc import Callable

from . import _balcony

_SUM, _PRODUCT, _PREFIX, _POWER, _ATOM = 4, 5, 6, 7, 8
# Symbol: its precedence, as docs/language.md has them. Comparisons cannot be chained.
_INFIX = {"||": 1, "&&": 2, "==": 3, "!=": 3, "<": 3, "<=": 3, ">": 3, ">=": 3, "+": _SUM, "-": _SUM,
          "*": _PRODUCT, "/": _PRODUCT, "^": _POWER}
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


class Expression:
    """A number that is known when the camera is used: of symbols, parameters and time."""

    __slots__ = ("_operation", "_arguments", "_text", "_declared")

    def __init__(self, operation: str, arguments: tuple = (), text: str = "", declared=None):
        self._operation = operation
        self._arguments = arguments
        self._text = text          # Of what has no arguments.
        self._declared = declared  # The declaration of a parameter.

    def __add__(self, other): return _apply("+", self, other)
    def __radd__(self, other): return _apply("+", other, self)
    def __sub__(self, other): return _apply("-", self, other)
    def __rsub__(self, other): return _apply("-", other, self)
    def __mul__(self, other): return _apply("*", self, other)
    def __rmul__(self, other): return _apply("*", other, self)
    def __truediv__(self, other): return _apply("/", self, other)
    def __rtruediv__(self, other): return _apply("/", other, self)
    def __pow__(self, other): return _apply("^", self, other)
    def __rpow__(self, other): return _apply("^", other, self)
    def __mod__(self, other): return _apply("mod", self, other)
    def __rmod__(self, other): return _apply("mod", other, self)
    def __floordiv__(self, other): return _apply("floor", _apply("/", self, other))
    def __rfloordiv__(self, other): return _apply("floor", _apply("/", other, self))
    def __neg__(self): return _apply("negate", self)
    def __pos__(self): return self
    def __abs__(self): return _apply("abs", self)
    def __lt__(self, other): return _apply("<", self, other)
    def __le__(self, other): return _apply("<=", self, other)
    def __gt__(self, other): return _apply(">", self, other)
    def __ge__(self, other): return _apply(">=", self, other)
    def __eq__(self, other): return _apply("==", self, other)
    def __ne__(self, other): return _apply("!=", self, other)
    def __and__(self, other): return _apply("&&", self, other)
    def __rand__(self, other): return _apply("&&", other, self)
    def __or__(self, other): return _apply("||", self, other)
    def __ror__(self, other): return _apply("||", other, self)
    def __invert__(self): return _apply("!", self)

    __hash__ = object.__hash__

    def __bool__(self):
        raise TypeError("a formula does not know whether this is true: choose by select(condition, a, b) "
                        "or np.where, and join conditions by & and |")

    def __float__(self):
        raise TypeError("a formula does not know this number: use a function of balcony.formulas or of "
                        "NumPy in place of one of math")

    __int__ = __index__ = __complex__ = __float__

    def __array_ufunc__(self, ufunc, method, *inputs, **options):
        if method != "__call__" or any(value is not None for value in options.values()):
            return NotImplemented
        from . import _numpy_functions
        return _numpy_functions.of_ufunc(ufunc, inputs)

    def __array_function__(self, function, types, arguments, options):
        from . import _numpy_functions
        return _numpy_functions.of_function(function, arguments, options)

    def __getattr__(self, name: str):
        # Functions of NumPy ask the elements of arrays for these.
        if not name.startswith("_"):
            from . import _numpy_functions
            if method := _numpy_functions.method(name):
                return lambda *others: method(self, *others)
        raise AttributeError(f"an expression of the camera language has no attribute '{name}'")

    def __repr__(self):
        count = len(in_order([self]))
        return text_of(self) if count <= 200 else f"<an expression of {count} operations>"


def as_expression(value) -> Expression:
    """A number or a text of the language as an expression."""
    if isinstance(value, Expression):
        return value
    if isinstance(value, str):
        return expression(value)
    if isinstance(value, (bool, numbers.Integral)) or type(value).__name__ == "bool_":
        return Expression("number", text=str(int(value)))
    if not isinstance(value, numbers.Real) and getattr(value, "ndim", None) != 0:
        raise TypeError(f"a formula has numbers, but this is {value!r}")
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"a formula has finite numbers, but this is {number}")
    return Expression("number", text=_balcony.literal(number, False))


def _apply(operation: str, *arguments) -> Expression:
    try:
        return Expression(operation, tuple(as_expression(one) for one in arguments))
    except TypeError:
        # NumPy's arrays, which take the operation to their elements.
        if any(getattr(one, "ndim", 0) for one in arguments):
            return NotImplemented
        raise


def expression(text: str) -> Expression:
    """An expression of the language as it stands: `expression("keys((0, 1), (5, 2), ease = smooth)")`."""
    text = text.strip()
    is_word = _NAME.fullmatch(text) or re.fullmatch(r"[0-9.]+(deg|rad)?", text)
    return Expression("text", text=text if is_word else f"({text})")


class Declaration:
    """A parameter of a camera."""

    def __init__(self, name, default, limits):
        self.name, self.default, self.limits = name, default, limits

    def __eq__(self, other):
        return (isinstance(other, Declaration) and self.name == other.name
                and repr(self.default) == repr(other.default) and self.limits == other.limits)

    __hash__ = None


def parameter(name: str, default, *, above=None, at_least=None, at_most=None) -> Expression:
    """A parameter of the camera that is composed with it: a number in stages and formulas, which the
    camera has as an attribute.

        radius = balcony.parameter("radius", 2, above=0)
        fov = balcony.parameter("fov", "90deg", at_most="179deg")
    """
    if not _NAME.fullmatch(name):
        raise ValueError(f"'{name}' is no name: it has letters, digits and _, and does not begin with a digit")
    if above is not None and at_least is not None:
        raise ValueError("above and at_least exclude each other")
    limits = [(word, text_of(as_expression(one))) for word, one in
              (("above", above), ("from", at_least), ("to", at_most)) if one is not None]
    return Expression("name", text=name, declared=Declaration(name, default, limits))


def _function(name: str, count: int, meaning: str) -> Callable[..., Expression]:
    def made(*arguments):
        if len(arguments) != count:
            raise TypeError(f"{name}() takes {count} arguments, but {len(arguments)} are given")
        result = _apply(name, *arguments)
        if result is NotImplemented:
            raise TypeError(f"{name}() takes numbers, not arrays: the function of NumPy takes both")
        return result

    made.__name__ = made.__qualname__ = name
    made.__module__ = __name__
    made.__doc__ = f"{meaning}."
    return made


_FUNCTIONS = [(name, count, meaning) for name, count, meaning in _balcony.operation_rows()]
_FUNCTIONS.append(("spow", 2, "the signed power, sign(x) |x|^p"))
globals().update({name: _function(name, count, meaning) for name, count, meaning in _FUNCTIONS})

t = Expression("name", text="t")
pi = Expression("name", text="pi")
deg = Expression("number", text="1deg")
rad = Expression("number", text="1rad")

__all__ = ["Expression", "deg", "expression", "parameter", "pi", "rad", "t",
           *(name for name, _, _ in _FUNCTIONS)]


# ------------------------------------------------------------------------------------- writing

def _precedence(one: Expression) -> int:
    if one._operation == "number":
        return _PREFIX if one._text.startswith("-") else _ATOM
    if one._operation in ("negate", "!"):
        return _PREFIX
    return _INFIX.get(one._operation, _ATOM)


def _in_parentheses(text: str, needed: bool) -> str:
    return f"({text})" if needed else text


def text_of(one: Expression, known: dict[int, str] | None = None) -> str:
    """The text in the language; `known` names expressions that stand elsewhere, by their ids."""
    known = known or {}
    if id(one) in known:
        return known[id(one)]
    written: dict[int, str] = {}

    def part(argument, least):
        is_atom = id(argument) in known
        return _in_parentheses(known.get(id(argument)) or written[id(argument)],
                               not is_atom and _precedence(argument) < least)

    def write(node):
        operation, arguments = node._operation, node._arguments
        if not arguments:
            return node._text
        if operation in ("negate", "!"):
            return ("-" if operation == "negate" else "!") + part(arguments[0], _POWER)
        if operation == "^":
            return f"{part(arguments[0], _ATOM)}^{part(arguments[1], _PREFIX)}"
        if operation in _INFIX:
            own = _INFIX[operation]
            space = "" if own == _PRODUCT else " "
            left = part(arguments[0], own if own >= _SUM else own + 1)
            return f"{left}{space}{operation}{space}{part(arguments[1], own + 1)}"
        return f"{operation}({', '.join(part(argument, 0) for argument in arguments)})"

    for node in in_order([one], known):
        written[id(node)] = write(node)
    return written[id(one)]


def in_order(roots: list[Expression], known: dict[int, str] | None = None) -> list[Expression]:
    """All expressions that these consist of, each once, arguments first."""
    known = known or {}
    order, seen = [], set()
    for root in roots:
        stack = [(root, False)]
        while stack:
            node, is_done = stack.pop()
            if is_done:
                order.append(node)
            elif id(node) not in seen:
                seen.add(id(node))
                stack.append((node, True))
                stack.extend((one, False) for one in node._arguments if id(one) not in known)
    return order
