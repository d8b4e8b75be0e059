// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The colours of camera files, by the grammar of editors/vscode, whose words a test compares with the
// language's own tables. As in TextMate, at each place the first rule that matches there decides.

import { HighlightStyle, indentService, StreamLanguage, type StreamParser, type StringStream } from "@codemirror/language";
import { type Tag, tags } from "@lezer/highlight";
import grammar from "../../editors/vscode/syntaxes/balcony-camera.tmLanguage.json";

interface Rule {
    name?: string;
    match?: string;
    begin?: string;
    end?: string;
    captures?: Record<string, { name: string }>;
}

/** The names of the tags in `tokenTable`, by the beginning of a scope. */
const classes: [string, string][] = [
    ["comment", "comment"],
    ["string", "text"],
    ["storage", "item"],
    ["entity.name.type", "name"],
    ["entity.name.function", "stage"],
    ["support.function", "function"],
    ["variable.parameter", "parameter"],
    ["variable.other", "name"],
    ["keyword.control", "statement"],
    ["keyword.other.unit", "unit"],
    ["keyword.other", "statement"],
    ["keyword.operator", "operator"],
    ["constant.language", "constant"],
    ["constant.numeric", "number"],
];

const tokenTable: Record<string, Tag> = {
    comment: tags.comment,
    text: tags.string,
    item: tags.definitionKeyword,
    name: tags.className,
    stage: tags.function(tags.variableName),
    function: tags.standard(tags.variableName),
    parameter: tags.propertyName,
    statement: tags.keyword,
    unit: tags.unit,
    operator: tags.operator,
    constant: tags.atom,
    number: tags.number,
};

const classOf = (scope: string): string | null => classes.find(([begin]) => scope.startsWith(begin))?.[1] ?? null;

// A string ends with its line, so that only comments go on in the next one.
const rules = (grammar.patterns as Rule[]).map((rule) => ({
    rule,
    first: new RegExp(rule.match ?? rule.begin!, "dgm"),
    end: rule.end === undefined ? null : new RegExp(rule.end, "gm"),
}));

interface Place {
    /** Parts of this line behind the cursor that are known already, as [end, class]. */
    known: [number, string | null][];
    until: RegExp | null;
    class: string | null;
}

/** Passes over a part that goes on until `until`, to the end of the line if that does not come. */
function passOver(stream: StringStream, place: Place, until: RegExp): string | null {
    until.lastIndex = stream.pos;
    const end = until.exec(stream.string);
    if (end) stream.pos = end.index + end[0].length;
    else stream.skipToEnd();
    place.until = end ? null : until;
    return place.class;
}

function partsOf(match: RegExpExecArray, rule: Rule): [number, string | null][] {
    const end = match.index + match[0].length;
    if (!rule.captures) return [[end, classOf(rule.name!)]];
    const parts: [number, string | null][] = [];
    for (const [group, { name }] of Object.entries(rule.captures)) {
        const span = match.indices![Number(group)];
        if (span) parts.push([span[0], null], [span[1], classOf(name)]);
    }
    return [...parts, [end, null]];
}

function token(stream: StringStream, place: Place): string | null {
    while (place.known.length > 0) {
        const [end, found] = place.known.shift()!;
        if (end > stream.pos) {
            stream.pos = end;
            return found;
        }
    }
    if (place.until) return passOver(stream, place, place.until);
    let best: { match: RegExpExecArray; index: number } | null = null;
    for (const [index, { first }] of rules.entries()) {
        first.lastIndex = stream.pos;
        const match = first.exec(stream.string);
        if (match && match[0] !== "" && (!best || match.index < best.match.index)) best = { match, index };
    }
    if (!best) {
        stream.skipToEnd();
        return null;
    }
    const { rule, end } = rules[best.index]!;
    const begin = best.match.index;
    if (begin > stream.pos) {
        stream.pos = begin;
        return null; // The same match is found again from here.
    }
    if (end) {
        place.class = classOf(rule.name!);
        stream.pos += best.match[0].length;
        return passOver(stream, place, end);
    }
    place.known = partsOf(best.match, rule);
    return token(stream, place);
}

export const cameraTokens: StreamParser<Place> = {
    name: "balcony",
    startState: () => ({ known: [], until: null, class: null }),
    copyState: (place) => ({ ...place, known: [...place.known] }),
    token: (stream, place) => {
        if (stream.sol()) place.known = [];
        return token(stream, place);
    },
    tokenTable,
    languageData: {
        commentTokens: { line: "//", block: { open: "/*", close: "*/" } },
        closeBrackets: { brackets: ["(", "[", "{", '"'] },
        indentOnInput: /^\s*\}$/,
    },
};

export const cameraLanguage = StreamLanguage.define(cameraTokens);

/** A block is indented by one unit more than the line that opens it. */
export const cameraIndent = indentService.of((context, pos) => {
    const line = context.lineAt(pos);
    if (line.from === 0) return 0;
    const before = context.lineAt(line.from - 1, -1);
    const deeper = /\{\s*(\/\/.*)?$/.test(before.text) ? context.unit : 0;
    const shallower = /^\s*\}/.test(line.text) ? context.unit : 0;
    return Math.max(0, context.lineIndent(before.from, -1) + deeper - shallower);
});

export const cameraColours = HighlightStyle.define([
    { tag: tags.comment, color: "var(--cam-comment)", fontStyle: "italic" },
    { tag: tags.string, color: "var(--cam-text)" },
    { tag: [tags.definitionKeyword, tags.keyword], color: "var(--cam-keyword)" },
    { tag: tags.className, color: "var(--cam-name)", fontWeight: "600" },
    { tag: tags.function(tags.variableName), color: "var(--cam-stage)" },
    { tag: tags.standard(tags.variableName), color: "var(--cam-function)" },
    { tag: tags.propertyName, color: "var(--cam-parameter)" },
    { tag: [tags.number, tags.unit, tags.atom], color: "var(--cam-number)", cursor: "var(--cam-number-cursor)" },
    { tag: tags.operator, color: "var(--cam-operator)" },
]);
