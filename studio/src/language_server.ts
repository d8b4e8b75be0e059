// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Questions of the editor about its text, and their answers in CodeMirror's terms.

import {
    type Completion,
    type CompletionContext,
    type CompletionResult,
    snippet,
} from "@codemirror/autocomplete";
import type { Diagnostic } from "@codemirror/lint";
import { type ChangeSpec, type EditorState, type Text } from "@codemirror/state";
import type { EditorView, Tooltip } from "@codemirror/view";
import type { CodeAction, DocumentSymbol, FileDiagnostic, Position, Range, TextEdit } from "./protocol";

/** What asks the server, about the text that the editor has now. */
export type Ask = <Result>(method: string, params: object) => Promise<Result>;

export function offsetOf(text: Text, position: Position): number {
    if (position.line >= text.lines) return text.length;
    const line = text.line(position.line + 1);
    return Math.min(line.from + position.character, line.to);
}

export function positionOf(text: Text, offset: number): Position {
    const line = text.lineAt(offset);
    return { line: line.number - 1, character: offset - line.from };
}

/** The changes of a list of edits, without what an edit leaves as it is. */
export function changesOf(text: Text, edits: TextEdit[]): ChangeSpec[] {
    return edits.map(({ range, newText }) => {
        let from = offsetOf(text, range.start);
        let to = offsetOf(text, range.end);
        const old = text.sliceString(from, to);
        let begin = 0;
        while (begin < Math.min(old.length, newText.length) && old[begin] === newText[begin]) ++begin;
        let end = 0;
        const most = Math.min(old.length, newText.length) - begin;
        while (end < most && old.at(-1 - end) === newText.at(-1 - end)) ++end;
        from += begin;
        to -= end;
        return { from, to, insert: newText.slice(begin, newText.length - end) };
    });
}

interface CompletionItem {
    label: string;
    kind: number;
    detail?: string;
    documentation?: string;
    insertTextFormat: 1 | 2;
    textEdit: TextEdit;
}

/** Icons of CodeMirror by the protocol's kinds of completions. */
const types: Record<number, string> = {
    3: "function",
    6: "variable",
    7: "class",
    10: "property",
    14: "keyword",
    20: "enum",
};

/** The protocol's blanks as CodeMirror's: `${1:x}` alike, `$0` as an empty one, other signs escaped. */
export function blanksOf(template: string): string {
    let made = "";
    for (let i = 0; i < template.length; ++i) {
        const c = template[i]!;
        if (c === "\\") made += /[{}]/.test(template[++i] ?? "") ? `\\${template[i]}` : (template[i] ?? "");
        else if (template.startsWith("${", i)) {
            made += "${";
            ++i;
        } else if (template.startsWith("$0", i)) {
            made += "${}";
            ++i;
        } else made += c;
    }
    return made;
}

// At the end of a list, so that the keyboard leaves the call with the last blank.
function completionOf(item: CompletionItem, index: number): Completion {
    return {
        label: item.label,
        type: types[item.kind] ?? "text",
        boost: Math.max(-99, 99 - index),
        ...(item.detail ? { detail: item.detail } : {}),
        ...(item.documentation ? { info: item.documentation } : {}),
        apply: item.insertTextFormat === 2 ? snippet(blanksOf(item.textEdit.newText)) : item.textEdit.newText,
    };
}

/** Where a list opens by itself: in a word, behind ( , = and behind the word that begins a statement. */
const opening = /[A-Za-z_]\w*$|[(,=]\s*$|^\s*[a-z]+ $/;

export const completions =
    (ask: Ask) =>
    async (context: CompletionContext): Promise<CompletionResult | null> => {
        const line = context.state.doc.lineAt(context.pos);
        const before = line.text.slice(0, context.pos - line.from);
        if (!context.explicit && !opening.test(before)) return null;
        const { doc } = context.state;
        const found = await ask<{ items: CompletionItem[] }>("textDocument/completion", {
            position: positionOf(doc, context.pos),
        });
        const first = found.items[0];
        if (!first || context.aborted) return null;
        return {
            from: offsetOf(doc, first.textEdit.range.start),
            options: found.items.map(completionOf),
            validFor: /^\w*$/,
        };
    };

/** The help of a word: blocks of code between lines of text. */
function helpDom(markdown: string): HTMLElement {
    const dom = document.createElement("div");
    dom.className = "cam-help";
    for (const [index, part] of markdown.split(/^```.*\n?/m).entries()) {
        const text = part.trim();
        if (text === "") continue;
        const element = dom.appendChild(document.createElement(index % 2 === 1 ? "pre" : "p"));
        element.textContent = text;
    }
    return dom;
}

export const help =
    (ask: Ask) =>
    async (view: EditorView, pos: number): Promise<Tooltip | null> => {
        const { doc } = view.state;
        const told = await ask<{ contents: { value: string }; range: Range } | null>("textDocument/hover", {
            position: positionOf(doc, pos),
        });
        if (!told) return null;
        return {
            pos: offsetOf(doc, told.range.start),
            end: offsetOf(doc, told.range.end),
            above: true,
            create: () => ({ dom: helpDom(told.contents.value) }),
        };
    };

interface SignatureHelp {
    signatures: {
        label: string;
        documentation?: string;
        parameters: { label: [number, number]; documentation?: string }[];
    }[];
    activeParameter: number;
}

/** The call around a place, with the parameter that stands there. */
export async function signatureAt(ask: Ask, state: EditorState, pos: number): Promise<Tooltip | null> {
    const found = await ask<SignatureHelp | null>("textDocument/signatureHelp", {
        position: positionOf(state.doc, pos),
    });
    const signature = found?.signatures[0];
    if (!found || !signature) return null;
    const active = signature.parameters[found.activeParameter];
    return {
        pos,
        above: true,
        create: () => {
            const dom = document.createElement("div");
            dom.className = "cam-help cam-signature";
            const code = dom.appendChild(document.createElement("pre"));
            const [begin, end] = active?.label ?? [0, 0];
            const strong = document.createElement("strong");
            strong.textContent = signature.label.slice(begin, end);
            code.append(signature.label.slice(0, begin), strong, signature.label.slice(end));
            if (active?.documentation) {
                dom.appendChild(document.createElement("p")).textContent = active.documentation;
            }
            return { dom };
        },
    };
}

/** A mistake with its place, and what mends it. */
export interface Problem extends Diagnostic {
    line: number;
    fixes: { title: string; changes: ChangeSpec[] }[];
}

export function problemsOf(text: Text, found: FileDiagnostic[], actions: CodeAction[], uri: string): Problem[] {
    return found.map((one) => {
        const from = offsetOf(text, one.range.start);
        const fixes = actions
            .filter(({ diagnostics }) => diagnostics.some((other) => JSON.stringify(other) === JSON.stringify(one)))
            .map(({ title, edit }) => ({ title, changes: changesOf(text, edit.changes[uri] ?? []) }));
        return {
            from,
            to: Math.max(from, offsetOf(text, one.range.end)),
            severity: one.severity === 1 ? "error" : "warning",
            message: one.message,
            line: one.range.start.line + 1,
            fixes,
        };
    });
}

/** The protocol's kinds of declared names. */
export enum SymbolKind {
    camera = 5,
    parameter = 7,
}

export const namesIn = (symbols: DocumentSymbol[], kind: SymbolKind): string[] =>
    symbols.filter((one) => one.kind === kind).map(({ name }) => name);
