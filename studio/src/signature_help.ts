// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// While a call is typed, its parameters are shown above it.

import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { EditorView, keymap, showTooltip, type Tooltip, ViewPlugin, type ViewUpdate } from "@codemirror/view";
import { type Ask, signatureAt } from "./language_server";

const setSignature = StateEffect.define<Tooltip | null>();

const shown = StateField.define<Tooltip | null>({
    create: () => null,
    update(value, transaction) {
        for (const effect of transaction.effects) if (effect.is(setSignature)) return effect.value;
        return value && transaction.docChanged ? { ...value, pos: transaction.changes.mapPos(value.pos) } : value;
    },
    provide: (field) => showTooltip.from(field),
});

const pause = 60;

export function signatureHelp(ask: Ask): Extension {
    const plugin = ViewPlugin.fromClass(
        class {
            private timer = 0;
            private asked = 0;

            constructor(private readonly view: EditorView) {}

            update(update: ViewUpdate): void {
                const typed = update.transactions.some((one) => one.isUserEvent("input"));
                const isShown = update.state.field(shown) !== null;
                if (typed || (isShown && (update.selectionSet || update.docChanged))) this.later();
                if (update.focusChanged && !this.view.hasFocus && isShown) this.later();
            }

            destroy(): void {
                clearTimeout(this.timer);
                ++this.asked;
            }

            private later(): void {
                clearTimeout(this.timer);
                this.timer = window.setTimeout(() => void this.show(), pause);
            }

            private async show(): Promise<void> {
                const asked = ++this.asked;
                const { view } = this;
                const { state } = view;
                const found = view.hasFocus
                    ? await signatureAt(ask, state, state.selection.main.head).catch(() => null)
                    : null;
                if (asked === this.asked && view.state.doc === state.doc) {
                    view.dispatch({ effects: setSignature.of(found) });
                }
            }
        },
    );
    const close = (view: EditorView): boolean => {
        if (!view.state.field(shown)) return false;
        view.dispatch({ effects: setSignature.of(null) });
        return true;
    };
    return [shown, plugin, keymap.of([{ key: "Escape", run: close }])];
}
