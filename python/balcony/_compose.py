# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Cameras that are composed of stages."""

from __future__ import annotations

from typing import TYPE_CHECKING, Union

from . import _texts
from ._cameras import Camera

if TYPE_CHECKING:
    from .formulas import Expression
    from .stages import Stage

    Number = Union[float, str, Expression]
    Range = Union[tuple[Number, Number], str]


class Path:
    """An eye or a direction object with its own map, warps and moves."""

    def __init__(self, stage: Stage | str, *, map: tuple[Range, Range] | str | None = None,
                 warp: list[Stage | str] = (), move: list[Stage | str] = ()):
        self._stage, self._map, self._warp, self._move = stage, map, warp, move

    def written(self, writer: _texts.Writer, kind: str) -> str:
        lines = _map_lines(writer, self._map) + _list_lines(writer, "warp", "parameter transformer", self._warp)
        lines.append(f"object {writer.stage(self._stage, kind)}")
        lines += _list_lines(writer, "move", "object transformer", self._move)
        return "{\n" + "".join(f"        {line}\n" for line in lines) + "    }"


def path(stage: Stage | str, *, map: tuple[Range, Range] | str | None = None,
         warp: list[Stage | str] = (), move: list[Stage | str] = ()) -> Path:
    """An eye or a direction object with a map, warps and moves of its own, for `compose`."""
    return Path(stage, map=map, warp=warp, move=move)


def _map_lines(writer: _texts.Writer, map) -> list[str]:
    if map is None:
        return []
    if isinstance(map, str):
        return [f"map {map}"]
    if len(map) != 2:
        raise TypeError("'map' is a pair: the range of u, from left to right, and the range of v, from bottom to top")
    ranges = []
    for name, one in zip("uv", map):
        if isinstance(one, str):
            ranges.append(f"{name} = {one}")
        else:
            first, last = one
            ranges.append(f"{name} = {writer.number(first, name)} .. {writer.number(last, name)}")
    return [f"map {', '.join(ranges)}"]


def _list_lines(writer: _texts.Writer, word: str, kind: str, stages) -> list[str]:
    if isinstance(stages, str) or not isinstance(stages, (list, tuple)):
        stages = [stages]
    return [f"{word} {', '.join(writer.stage(one, kind) for one in stages)}"] if stages else []


def compose(name: str = "composed", *, eye: Stage | Path | str, toward: Stage | Path | str | None = None,
            look: Stage | str | None = None, map: tuple[Range, Range] | str | None = None,
            warp: list[Stage | str] = (), move: list[Stage | str] = (), stereo: Stage | str | None = None,
            lens: Stage | str | None = None, bend: Stage | str | None = None, time: Number | None = None,
            aspect: Number | tuple[Number, Number] | None = None, axes: str | None = None,
            arrange: list[Stage | str] = (), place: str | None = None, fit: str | None = None,
            comment: str = "", parameters: list[Expression] = ()) -> Camera:
    """A camera of stages. Its text, `cam.text`, is what it is in the camera language.

        radius = balcony.parameter("radius", 2, above=0)
        cam = balcony.compose(eye=stages.circle(radius), toward=stages.torus(5 * radius, 1),
                              map=((np.pi / 2, 0), (-np.pi, np.pi)), move=[stages.rotate("x", "30deg")])
        cam.radius = 3

    The words are the statements of the language (docs/language.md). `map` has the ranges of u, from the left
    to the right of the picture, and of v, from the bottom to the top; one of them may be "square".
    `path` gives an eye or a direction object a map, warps and moves of its own. Parameters of the camera are
    those that are used, in the order of their use, after those of `parameters`. In place of a stage or a
    value, any text of the language may stand.
    """
    writer = _texts.Writer()
    for one in parameters:
        writer.expression(one)
    lines = [f"{word} {value}" for word, value in (("place", place), ("axes", axes), ("fit", fit)) if value]
    lines += _list_lines(writer, "arrange", "picture arranger", arrange)
    if aspect is not None:
        lines.append(f"aspect {writer.number(aspect, 'aspect')}")
    lines += _map_lines(writer, map)
    lines += _list_lines(writer, "warp", "parameter transformer", warp)
    for word, kind, stage in (("eye", "object generator", eye), ("toward", "object generator", toward),
                              ("look", "direction rule", look), ("stereo", "stereo view", stereo),
                              ("lens", "lens", lens), ("bend", "bend", bend)):
        if stage is not None:
            text = writer.stage(stage, kind)
            # A stage with the name of its statement is all of it.
            lines.append(text if text.split("(")[0] == word else f"{word} {text}")
    if time is not None:
        lines.append(f"time = {writer.number(time, 'time')}")
    lines += _list_lines(writer, "move", "object transformer", move)
    return Camera(_text_of(name, comment, writer, lines), name)


def _text_of(name: str, comment: str, writer: _texts.Writer, lines: list[str]) -> str:
    declared = ", ".join(_declaration(writer, one) for one in writer.declared.values())
    parameters = f"({declared})" if declared else ""
    comments = "".join(f"// {line}\n" for line in comment.splitlines())
    body = "".join(f"    {line}\n" for line in [*writer.lets, *lines])
    return f"{comments}camera {name}{parameters} {{\n{body}}}\n"


def _declaration(writer: _texts.Writer, one) -> str:
    limits = "".join(f" {word} {value}" for word, value in one.limits)
    return f"{one.name} = {writer.number(one.default, one.name)}{limits}"
