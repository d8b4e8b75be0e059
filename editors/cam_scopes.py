# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The scopes of a camera file's text, by the grammar of editors/vscode, for pages that show it."""

import json
import re
from pathlib import Path

GRAMMAR = Path(__file__).parent / "vscode/syntaxes/balcony-camera.tmLanguage.json"


def rules():
    for rule in json.loads(GRAMMAR.read_text(encoding="utf-8"))["patterns"]:
        if "match" in rule:
            yield re.compile(rule["match"], re.MULTILINE), rule
        else:
            whole = f"(?s:{rule['begin']}.*?(?:{rule['end']}|\\Z))"
            yield re.compile(whole, re.MULTILINE), rule


def spans(match, rule):
    """The parts of a match that have a scope: (begin, end, scope)."""
    if "captures" not in rule:
        yield (*match.span(), rule["name"])
        return
    for group, capture in rule["captures"].items():
        if match[int(group)] is not None:
            yield (*match.span(int(group)), capture["name"])


def scopes(text):
    """The parts of a text in order, each as (begin, part, scope), without a scope as "". As in
    TextMate, at each place the first rule that matches there decides."""
    all_rules = list(rules())
    at = 0
    while at < len(text):
        found = [(match.start(), index, match) for index, (pattern, _) in enumerate(all_rules)
                 if (match := pattern.search(text, at)) and match.end() > at]
        if not found:
            break
        _, index, match = min(found, key=lambda one: one[:2])
        for begin, end, scope in spans(match, all_rules[index][1]):
            yield at, text[at:begin], ""
            yield begin, text[begin:end], scope
            at = end
        yield at, text[at:match.end()], ""
        at = match.end()
    yield at, text[at:], ""


def class_of(classes, scope):
    """What the first of `classes`, a dictionary by the beginning of a scope, says about a scope."""
    return next((name for begin, name in classes.items() if scope.startswith(begin)), None)
