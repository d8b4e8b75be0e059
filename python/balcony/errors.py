# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Exceptions and warnings of Balcony."""

from __future__ import annotations

import re
import warnings
from typing import NamedTuple


class Diagnostic(NamedTuple):
    """What is wrong, where, and how to correct it."""

    message: str
    remedy: str = ""
    file: str | None = None
    line: int | None = None
    column: int | None = None
    text: str = ""
    """All of it, with the line of the file and its part that is meant."""


class Error(Exception):
    """An error of Balcony. Its text has all diagnostics."""

    def __init__(self, diagnostics: list[Diagnostic]):
        super().__init__("\n".join(one.text for one in diagnostics))
        self.diagnostics = diagnostics

    @property
    def message(self) -> str:
        """What is wrong, in one sentence."""
        return self.diagnostics[0].message

    @property
    def remedy(self) -> str:
        """How to correct it; empty if nothing is known."""
        return self.diagnostics[0].remedy

    @property
    def file(self) -> str | None:
        """Where it is wrong, if that is in a file or a text."""
        return self.diagnostics[0].file

    @property
    def line(self) -> int | None:
        return self.diagnostics[0].line

    @property
    def column(self) -> int | None:
        return self.diagnostics[0].column

    def __reduce__(self):
        return type(self), (self.diagnostics,)


class InputError(Error, ValueError):
    """A file, a camera or a value is wrong."""


class UsageError(Error, ValueError):
    """What was asked for cannot be done."""


class MachineError(Error, OSError):
    """The machine lacks something: space on a disk, memory, a library, a program."""

    # OSError would take two arguments for a number and a text.
    def __new__(cls, diagnostics):
        return super().__new__(cls, "\n".join(one.text for one in diagnostics))

    def __str__(self):
        return self.args[0]


class Interrupted(Error):
    """The work was stopped."""


class InternalError(Error, RuntimeError):
    """A defect of Balcony."""


class BalconyWarning(UserWarning):
    """What is worth knowing about something that was done."""


_BY_KIND = {"input": InputError, "usage": UsageError, "environment": MachineError,
            "interrupted": Interrupted, "internal": InternalError}
_OPTION = re.compile(r"(?<![\w-])--([a-z][a-z-]*)")


def _in_python(text: str) -> str:
    """Options of the command by their names here: film_memory for --film-memory."""
    return _OPTION.sub(lambda match: match[1].replace("-", "_"), text)


def _diagnostic(told: dict) -> Diagnostic:
    words = {name: _in_python(told[name]) for name in ("message", "remedy", "text")}
    return Diagnostic(**words, **{name: told.get(name) for name in ("file", "line", "column")})


def tell(told: list[dict]) -> None:
    """Warns of the warnings, and raises the errors as one exception of the first one's kind."""
    for one in told:
        if not one["is_error"]:
            warnings.warn(_diagnostic(one).text.strip(), BalconyWarning, stacklevel=3)
    wrong = [one for one in told if one["is_error"]]
    if wrong:
        raise _BY_KIND[wrong[0]["kind"]]([_diagnostic(one) for one in wrong])
