# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes values and functions of Python as the camera language has them."""

from __future__ import annotations

import math
import re

from . import _balcony, formulas
from .formulas import Expression

# Beyond these, an expression is written in parts: the language reads 200 levels of parentheses.
_MOST_OPERATIONS = 400
_DEEPEST = 50
_MOST_LEVELS = 380


class Writer:
    """Writes the parts of one camera, and gathers the parameters and functions that they use."""

    def __init__(self):
        self.declared: dict[str, formulas.Declaration] = {}
        self.lets: list[str] = []

    # --------------------------------------------------------------------------------- values

    def value(self, value, parameter: dict) -> str:
        """A value for a parameter of a stage."""
        form, *details = parameter["form"]
        if form == "formula":
            names, may_have_fewer = details
            return self.formula(parameter["name"], value, names, may_have_fewer)
        if form in ("stage", "stages"):
            return self.stage(value, details[0])
        value = _plain(value)
        if isinstance(value, str):
            is_name = form == "name" or (form in ("points", "angles") and not value.lstrip().startswith("["))
            return quoted(value) if is_name else value
        if isinstance(value, list) and form not in ("points", "angles"):
            value = tuple(value)
        return self.number(value, parameter["name"], form in ("angle", "angles"))

    def number(self, value, name: str, is_angle: bool = False) -> str:
        """A number, a text, or a tuple or a list of these."""
        value = _plain(value)
        if isinstance(value, str):
            return value
        if isinstance(value, Expression):
            return self.expression(value)
        if isinstance(value, (tuple, list)):
            parts = ", ".join(self.number(one, name, is_angle) for one in value)
            return f"({parts})" if isinstance(value, tuple) else f"[{parts}]"
        if isinstance(value, bool) or not hasattr(value, "__float__"):
            raise TypeError(f"'{name}' is {value!r}, but a number, a text or a tuple of numbers is needed")
        try:
            return _angle_text(float(value)) if is_angle else formulas.text_of(formulas.as_expression(value))
        except ValueError:
            raise ValueError(f"'{name}' is {value!r}, but a finite number is needed") from None

    def stage(self, value, kind: str) -> str:
        """A stage, a function that makes one without arguments, a text, or a number for a focus."""
        if isinstance(value, (list, tuple)) and not isinstance(value, str):
            return ", ".join(self.stage(one, kind) for one in value)
        if isinstance(value, str):
            return value
        if callable(value) and getattr(value, "__module__", "") == "balcony.stages":
            value = value()
        if hasattr(value, "written"):
            return value.written(self, kind)
        if isinstance(value, Expression) or hasattr(value, "__float__"):
            return self.number(value, kind)
        raise TypeError(f"a {kind} is needed, but this is {value!r}")

    # --------------------------------------------------------------------------------- formulas

    def declare(self, one: formulas.Declaration) -> None:
        known = self.declared.setdefault(one.name, one)
        if known != one:
            raise ValueError(f"two parameters have the name '{one.name}' and differ")

    def _names_in(self, roots: list[Expression]) -> set[str]:
        names = set()
        for node in formulas.in_order(roots):
            if node._declared is not None:
                self.declare(node._declared)
                names.add(node._text)
            elif node._operation == "text":
                names.update(re.findall(r"[A-Za-z_]\w*", node._text))
        return names

    def expression(self, one: Expression) -> str:
        return self._results([one], [], self._names_in([one]))

    def formula(self, name: str, function, names: list[str], may_have_fewer: bool = False) -> str:
        """name(u, v) = [x, y, z], of a function of Python or a text."""
        if isinstance(function, str):
            return function if "=" in function else f"{name}({', '.join(names)}) = [{function}]"
        if not callable(function):
            raise TypeError(f"'{name}' is {function!r}, but a function of {', '.join(names)} is needed")
        names = names[:_count_of(function, len(names))] if may_have_fewer else names
        results = self._traced(name, function, names)
        taken = self._names_in(results)
        if taken & set(names):
            # The symbols of the formula would hide those outside that have the same name.
            names = [_free(one, taken) for one in names]
            results = self._traced(name, function, names)
        return f"{name}({', '.join(names)}) = [{self._results(results, names, taken)}]"

    @staticmethod
    def _traced(name: str, function, names: list[str]) -> list[Expression]:
        made = _plain(function(*(Expression("name", text=one) for one in names)))
        parts = made if isinstance(made, (tuple, list)) else [made]
        try:
            return [formulas.as_expression(_plain(one)) for one in parts]
        except TypeError as error:
            raise TypeError(f"the function of '{name}' returns {made!r}: {error}") from None

    def _results(self, results: list[Expression], names: list[str], taken: set[str]) -> str:
        """The results; if they are long, by functions that call each other: each computes once what is used
        several times, and passes it on."""
        levels = [] if _is_short(results) else _levels(results)
        if not levels:
            return ", ".join(formulas.text_of(one) for one in results)
        if len(levels) > _MOST_LEVELS:
            raise ValueError(f"the formula has {len(levels)} steps that need each other, and the language "
                             f"reads {_MOST_LEVELS}: make it shorter")
        function = _free("formula", taken | set(names)) + f"_{len(self.lets) + 1}"
        needed = _needed_after(levels, results)
        known: dict[int, str] = {}
        passed: list[str] = list(names)
        call = f"{function}_0({', '.join(names)})"
        for number, level in enumerate(levels):
            keep = [one for one in known if one in needed[number]]
            new = {id(one): _free(f"s{number}_{i}", taken | set(names)) for i, one in enumerate(level)}
            computed = [formulas.text_of(one, known) for one in level]
            arguments = ", ".join([*names, *(known[one] for one in keep), *computed])
            if passed:
                self.lets.append(f"let {function}_{number}({', '.join(passed)}) = {function}_{number + 1}({arguments})")
            else:
                call = f"{function}_1({arguments})"
            known = {**{one: known[one] for one in keep}, **new}
            passed = [*names, *known.values()]
        values = ", ".join(formulas.text_of(one, known) for one in results)
        values = f"({values})" if len(results) > 1 else values
        self.lets.append(f"let {function}_{len(levels)}({', '.join(passed)}) = {values}")
        return call


def _needed_after(levels: list[list[Expression]], results: list[Expression]) -> list[set[int]]:
    """Of each level, the ids of what later ones need of it or of earlier ones."""
    shared = {id(one) for level in levels for one in level}

    def met(parts):
        found, seen, stack = set(), set(), list(parts)
        while stack:
            one = stack.pop()
            if id(one) in shared:
                found.add(id(one))
            elif id(one) not in seen:
                seen.add(id(one))
                stack.extend(one._arguments)
        return found

    still = met(results)
    needed = []
    for level in reversed(levels):
        needed.append(still)
        still = (still - {id(one) for one in level}) | met(part for one in level for part in one._arguments)
    return needed[::-1]


def _levels(results: list[Expression]) -> list[list[Expression]]:
    """What is to be computed once, in the order of need: all of a level needs earlier levels alone."""
    order = formulas.in_order(results)
    uses: dict[int, int] = {}
    for node in order:
        for one in node._arguments:
            uses[id(one)] = uses.get(id(one), 0) + 1
    height: dict[int, int] = {}
    level: dict[int, int] = {}
    levels: list[list[Expression]] = []
    for node in order:
        if not node._arguments:
            height[id(node)], level[id(node)] = 0, -1
            continue
        height[id(node)] = 1 + max(height[id(one)] for one in node._arguments)
        level[id(node)] = max(level[id(one)] for one in node._arguments)
        if uses.get(id(node), 0) > 1 or height[id(node)] >= _DEEPEST:
            height[id(node)] = 0
            level[id(node)] += 1
            if level[id(node)] == len(levels):
                levels.append([])
            levels[level[id(node)]].append(node)
    return levels


def _is_short(results: list[Expression]) -> bool:
    size: dict[int, int] = {}
    height: dict[int, int] = {}
    for node in formulas.in_order(results):
        size[id(node)] = 1 + sum(size[id(one)] for one in node._arguments)
        height[id(node)] = 1 + max((height[id(one)] for one in node._arguments), default=0)
    return (sum(size[id(one)] for one in results) <= _MOST_OPERATIONS
            and max(height[id(one)] for one in results) <= _DEEPEST)


def _angle_text(radians: float) -> str:
    if not math.isfinite(radians):
        raise ValueError(radians)
    return min(_balcony.literal(radians, True), _balcony.literal(radians, True, "1rad"), key=len)


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    return name


def _count_of(function, most: int) -> int:
    import inspect  # Slow to import.

    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return most
    if any(one.kind == one.VAR_POSITIONAL for one in parameters):
        return most
    return min(most, sum(one.kind in (one.POSITIONAL_ONLY, one.POSITIONAL_OR_KEYWORD) for one in parameters))


def _plain(value):
    """Arrays as lists, numbers of NumPy as numbers, and what has a path as that."""
    if isinstance(value, Expression):
        return value
    if hasattr(value, "__fspath__"):
        return value.__fspath__()
    if hasattr(value, "tolist"):
        made = value.tolist()
        # The rows of an array are points.
        return [tuple(one) if isinstance(one, list) else one for one in made] if isinstance(made, list) else made
    return value


def quoted(text: str) -> str:
    """A name in quotation marks."""
    if '"' in text or "\n" in text:
        raise ValueError(f"the camera language cannot write {text!r}, which has a quotation mark or a line feed")
    return f'"{text}"'
