# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""How far something is."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator


@contextlib.contextmanager
def shown(progress: bool | Callable[[float], object]) -> Iterator[Callable[[float], object] | None]:
    """What is to be called with the part that is done: a function, what draws a bar for True, or nothing."""
    if progress is not True:
        yield progress or None
        return
    try:
        yield _draw_bar
    finally:
        print(file=sys.stderr)


def _draw_bar(done: float) -> None:
    print(f"\r[{'=' * round(40 * done):40}] {done:4.0%}", end="", file=sys.stderr, flush=True)
