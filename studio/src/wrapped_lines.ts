// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Lines that are longer than the editor is wide go on below, indented more than their beginning.

import { type Extension, RangeSetBuilder } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, ViewPlugin, type ViewUpdate } from "@codemirror/view";

const more = 4;
const most = 24;

// Classes, as the content security policy forbids inline styles.
const columns = [...Array(most + 1).keys()];
const lines = columns.map((count) => Decoration.line({ class: `cam-indent-${count}` }));
const theme = EditorView.theme(
    Object.fromEntries(
        columns.map((count) => [
            `.cm-line.cam-indent-${count}`,
            { paddingLeft: `calc(4px + ${count}ch)`, textIndent: `-${count}ch` },
        ]),
    ),
);

function indents(view: EditorView): DecorationSet {
    const made = new RangeSetBuilder<Decoration>();
    for (const { from, to } of view.visibleRanges) {
        for (let at = from; at <= to; ) {
            const line = view.state.doc.lineAt(at);
            const count = Math.min(most, line.text.search(/\S|$/) + more);
            made.add(line.from, line.from, lines[count]!);
            at = line.to + 1;
        }
    }
    return made.finish();
}

const plugin = ViewPlugin.fromClass(
    class {
        decorations: DecorationSet;

        constructor(view: EditorView) {
            this.decorations = indents(view);
        }

        update(update: ViewUpdate): void {
            if (update.docChanged || update.viewportChanged) this.decorations = indents(update.view);
        }
    },
    { decorations: (plugin) => plugin.decorations },
);

export const wrappedLines: Extension = [EditorView.lineWrapping, theme, plugin];
