// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A number of the text is dragged with Ctrl held: to the right it grows. The whole way is one step of undo.

import type { Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { OneStep } from "./one_step";
import { rounded } from "./parameter_range";

const number = /(?<!\w)(?<!(?<!\.)\.)(\d+(?:\.(?!\.)\d*)?|\.\d+)(?:[eE][+-]?\d+)?/g;

export interface DraggedNumber {
    from: number;
    to: number;
    value: number;
    /** What it changes by in a pixel. */
    step: number;
}

/** By how much a pixel of a hand changes a number: by its third digit. */
export const handStep = (value: number): number =>
    10 ** (Math.floor(Math.log10(Math.max(Math.abs(value), 0.1))) - 2);

/** The number of a line at an offset of it; a sign before it that is no difference belongs to it. */
export function numberAt(line: string, offset: number): DraggedNumber | null {
    for (const match of line.matchAll(number)) {
        const to = match.index + match[0].length;
        if (offset < match.index || offset > to) continue;
        const isNegative = /(^|[(,=[]|\.\.)\s*-$/.test(line.slice(0, match.index));
        const from = match.index - (isNegative ? 1 : 0);
        const value = Number(line.slice(from, to));
        return { from, to, value, step: handStep(value) };
    }
    return null;
}

function drag(view: EditorView, begin: MouseEvent): boolean {
    const offset = view.posAtCoords(begin);
    if (!(begin.ctrlKey || begin.metaKey) || begin.button !== 0 || offset === null || view.state.readOnly) return false;
    const line = view.state.doc.lineAt(offset);
    const found = numberAt(line.text, offset - line.from);
    if (!found) return false;
    const from = line.from + found.from;
    const written = line.text.slice(found.from, found.to);
    const step = new OneStep(view);
    let shown = written;
    const move = (event: MouseEvent): void => {
        const size = found.step * (event.shiftKey ? 10 : 1);
        const text = String(rounded(found.value + size * Math.round(event.clientX - begin.clientX), found.step));
        if (text === shown) return;
        step.change({ from, to: from + shown.length, insert: text });
        shown = text;
    };
    const end = (): void => {
        removeEventListener("mousemove", move);
        removeEventListener("mouseup", end);
        step.end();
    };
    addEventListener("mousemove", move);
    addEventListener("mouseup", end);
    begin.preventDefault();
    return true;
}

/** Numbers look as if they can be dragged while Ctrl is held. */
function showKey(view: EditorView, event: KeyboardEvent | MouseEvent): boolean {
    view.dom.classList.toggle("cam-drags", event.ctrlKey || event.metaKey);
    return false;
}

export const numberDrag: Extension = EditorView.domEventHandlers({
    mousedown: (event, view) => drag(view, event),
    mousemove: (event, view) => showKey(view, event),
    keydown: (event, view) => showKey(view, event),
    keyup: (event, view) => showKey(view, event),
});
