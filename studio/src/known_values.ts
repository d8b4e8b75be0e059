// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Behind a line, the value of what is not written as a number there.

import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, WidgetType } from "@codemirror/view";
import { offsetOf } from "./language_server";
import type { Position } from "./protocol";

export interface KnownValue {
    position: Position;
    label: string;
}

class ValueWidget extends WidgetType {
    constructor(private readonly label: string) {
        super();
    }

    override eq(other: ValueWidget): boolean {
        return other.label === this.label;
    }

    toDOM(): HTMLElement {
        const dom = document.createElement("span");
        dom.className = "cam-value";
        dom.textContent = this.label;
        return dom;
    }
}

export const setKnownValues = StateEffect.define<KnownValue[]>();

export const knownValues: Extension = StateField.define<DecorationSet>({
    create: () => Decoration.none,
    update(value, transaction) {
        for (const effect of transaction.effects) {
            if (effect.is(setKnownValues)) {
                const widgets = effect.value.map(({ position, label }) =>
                    Decoration.widget({ widget: new ValueWidget(label), side: 1 }).range(
                        offsetOf(transaction.newDoc, position),
                    ),
                );
                return Decoration.set(widgets, true);
            }
        }
        return value.map(transaction.changes);
    },
    provide: (field) => EditorView.decorations.from(field),
});
