# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The text of a camera file as HTML, highlighted by the grammar of editors/vscode."""

import html
import json
import re
from pathlib import Path

GRAMMAR = Path("editors/vscode/syntaxes/balcony-camera.tmLanguage.json")

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


def class_of(scope):
    return next((name for begin, name in CLASSES.items() if scope.startswith(begin)), None)


def rules():
    for rule in json.loads(GRAMMAR.read_text(encoding="utf-8"))["patterns"]:
        if "match" in rule:
            yield re.compile(rule["match"], re.MULTILINE), rule
        else:
            whole = f"(?s:{rule['begin']}.*?(?:{rule['end']}|\\Z))"
            yield re.compile(whole, re.MULTILINE), rule


def spans(match, rule):
    """The highlighted parts of a match: (begin, end, scope)."""
    if "captures" not in rule:
        yield (*match.span(), rule["name"])
        return
    for group, capture in rule["captures"].items():
        if match[int(group)] is not None:
            yield (*match.span(int(group)), capture["name"])


def highlighted(text):
    """As TextMate does: at each place the first rule that matches there."""
    all_rules = list(rules())
    parts = []
    at = 0
    while at < len(text):
        found = [(match.start(), index, match) for index, (pattern, _) in enumerate(all_rules)
                 if (match := pattern.search(text, at)) and match.end() > at]
        if not found:
            break
        _, index, match = min(found, key=lambda one: one[:2])
        for begin, end, scope in spans(match, all_rules[index][1]):
            parts.append(html.escape(text[at:begin], quote=False))
            inside = html.escape(text[begin:end], quote=False)
            name = class_of(scope)
            parts.append(f'<span class="{name}">{inside}</span>' if name else inside)
            at = end
        parts.append(html.escape(text[at:match.end()], quote=False))
        at = match.end()
    parts.append(html.escape(text[at:], quote=False))
    return "".join(parts)
