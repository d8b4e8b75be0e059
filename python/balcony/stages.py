# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""All stages of the camera language as functions: `stages.circle(radius=2)`.

A stage of Python writes itself in the camera language and computes nothing; `balcony.compose` makes a
camera of stages. `help(stages.helix)` says what a stage is, `kinds()` lists all.

    from balcony import stages

    stages.product(stages.circle, stages.bezier([(1, 0), (0.4, 1), (1, 2)]))

Numbers are in radians if they are angles; a text is an expression of the language, "30deg"; tuples and
lists have these. Choices and axes are texts, "inward" or "-z", and so are names of files and objects. A
formula is a function of Python: see `balcony.formulas`. Where Python has a name for itself, a parameter
has an underscore: `stages.arc_length(curve, from_=0, to=1)`.
"""

from __future__ import annotations

import functools
import keyword
import textwrap

from . import _balcony, _texts

__all__ = ["Stage", "kinds"]  # And the stages: see __dir__.


class Stage:
    """A stage with its arguments. Its text is what the camera language has: `str(stages.circle(2))`."""

    __slots__ = ("_name", "_arguments", "_named")

    def __init__(self, name: str, arguments: tuple = (), named: dict | None = None):
        self._name = name
        self._arguments = arguments
        self._named = named or {}

    @property
    def name(self) -> str:
        return self._name

    def written(self, writer: _texts.Writer, kind: str | None = None) -> str:
        """The text as a stage of a kind, or as the first that takes the arguments."""
        row = self._row(kind)
        if row["shape"] is not None:
            if len(self._arguments) != 1 or self._named:
                raise TypeError(f"{self._name}() takes a function of {', '.join(row['shape'])}")
            return writer.formula(self._name, self._arguments[0], row["shape"])
        parameters = row["parameters"]
        if len(self._arguments) > len(parameters) and not _takes_several(parameters):
            raise TypeError(f"{row['call']} is given {len(self._arguments)} arguments")
        parts = []
        for index, value in enumerate(self._arguments):
            parameter = parameters[min(index, len(parameters) - 1)]
            parts.append(writer.value(value, parameter))
        by_name = {one["name"]: one for one in parameters}
        for name, value in self._named.items():
            if value is None:
                continue
            name = _in_language(name)
            parameter = by_name[name]
            text = writer.value(value, parameter)
            parts.append(text if parameter["form"][0] in ("formula", "stages") else f"{name} = {text}")
        return f"{self._name}({', '.join(parts)})" if parts else self._name

    def _row(self, kind: str | None) -> dict:
        rows = [one for one in _rows()[self._name] if kind in (None, one["kind"])]
        if not rows:
            kinds_of = " or ".join(one["kind"] for one in _rows()[self._name])
            raise TypeError(f"a {kind} is needed, but {self._name} is a stage of another kind: {kinds_of}")
        for row in rows:
            if self._fits(row):
                return row
        self._refuse(rows)

    def _fits(self, row: dict) -> bool:
        if row["shape"] is not None:
            return not self._named
        names = [one["name"] for one in row["parameters"]]
        return (set(map(_in_language, self._named)) <= set(names)
                and (len(self._arguments) <= len(names) or _takes_several(row["parameters"])))

    def _refuse(self, rows: list[dict]):
        names = [one["name"] for row in rows for one in row["parameters"]]
        for name in self._named:
            if _in_language(name) not in names:
                hint = _balcony.suggestion(name, names, "its parameters are")
                raise TypeError(f"{self._name} has no parameter '{name}': {hint}")
        raise TypeError(f"{self._name} takes other arguments: {' or '.join(row['call'] for row in rows)}")

    def __str__(self):
        return self.written(_texts.Writer())

    def __repr__(self):
        return f"<balcony stage {self}>"


def _in_python(name: str) -> str:
    return f"{name}_" if keyword.iskeyword(name) else name


def _in_language(name: str) -> str:
    return name[:-1] if keyword.iskeyword(name[:-1]) else name


def _takes_several(parameters: list[dict]) -> bool:
    return bool(parameters) and parameters[-1]["form"][0] == "stages"


@functools.cache
def _rows() -> dict[str, list[dict]]:
    rows: dict[str, list[dict]] = {}
    for row in _balcony.stage_rows():
        rows.setdefault(row["name"], []).append(row)
    return rows


def kinds() -> dict[str, dict[str, str]]:
    """All stages by kind: of each, its name and what it is."""
    made: dict[str, dict[str, str]] = {}
    for row in _balcony.stage_rows():
        made.setdefault(row["kind"], {})[row["name"]] = row["meaning"]
    return made


def _parameter_text(one: dict) -> str:
    facts = [one["type"]]
    if one["default"]:
        facts.append(f"default {one['default']}")
    elif one["optional"]:
        facts.append("may be left out")
    if one["range"]:
        facts.append(one["range"])
    return f"{one['name']}: {', '.join(facts)}\n" + textwrap.indent(_filled(one["meaning"], 92), "    ")


def _filled(text: str, width: int) -> str:
    return textwrap.fill(text, width, break_on_hyphens=False, break_long_words=False)


def _text_of(row: dict) -> str:
    parts = [f"{row['kind']}: {row['call']}"]
    parts.append(_filled(row["meaning"], 96))
    if row["parameters"]:
        parts.append("\n".join(_parameter_text(one) for one in row["parameters"]))
    parts.append(textwrap.indent(row["formula"], "    "))
    if example := row["example"].strip():
        parts.append("Example:\n\n" + textwrap.indent(example, "    "))
    return "\n\n".join(parts)


class _Shown(str):
    """A default as the language has it."""

    __slots__ = ()

    def __repr__(self):
        return str(self)


def _signature(row: dict):
    import inspect  # Slow to import.

    if row["shape"] is not None:
        return inspect.Signature([inspect.Parameter("function", inspect.Parameter.POSITIONAL_ONLY)])
    made: list[inspect.Parameter] = []
    is_required = False  # Whether one that follows has to be given.
    for one in reversed(row["parameters"]):
        is_several = one["form"][0] == "stages"
        has_default = one["default"] or one["optional"]
        is_required = is_required or not (has_default or is_several)
        default = inspect.Parameter.empty if is_required or is_several else _Shown(one["default"] or "None")
        kind = inspect.Parameter.VAR_POSITIONAL if is_several else inspect.Parameter.POSITIONAL_OR_KEYWORD
        made.insert(0, inspect.Parameter(_in_python(one["name"]), kind, default=default))
    return inspect.Signature(made)


def __getattr__(name: str):
    rows = _rows().get(name)
    if rows is None:
        hint = "" if name.startswith("__") else _balcony.suggestion(name, list(_rows()), "the stages are")
        raise AttributeError(f"there is no stage '{name}': {hint}")

    def made(*arguments, **named) -> Stage:
        stage = Stage(name, arguments, named)
        stage._row(None)
        return stage

    made.__name__ = made.__qualname__ = name
    made.__module__ = __name__
    made.__doc__ = "\n\n".join(_text_of(row) for row in rows)
    made.__signature__ = _signature(rows[0])
    globals()[name] = made
    return made


def __dir__():
    return sorted([*__all__, *_rows()])
