# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The text of a camera file as HTML, highlighted by the grammar of editors/vscode."""

import html
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "editors"))

from cam_scopes import class_of, scopes  # noqa: E402 (found there)

# The classes of the page's style sheet, by the beginning of a scope.
CLASSES = {
    "comment": "comment",
    "string": "string",
    "constant.numeric": "number",
    "constant": "constant",
    "keyword.other.unit": "unit",
    "keyword.operator": "operator",
    "keyword": "keyword",
    "storage": "keyword",
    "entity": "name",
    "support": "name",
    "variable": "parameter",
}


def highlighted(text):
    parts = []
    for _, part, scope in scopes(text):
        inside = html.escape(part, quote=False)
        name = class_of(CLASSES, scope)
        parts.append(f'<span class="{name}">{inside}</span>' if name else inside)
    return "".join(parts)
