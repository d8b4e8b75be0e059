// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Changes that a hand makes on its way. They are shown at once, and are one step of undo in the end.

import { isolateHistory } from "@codemirror/commands";
import { type ChangeSet, type ChangeSpec, type Text, Transaction } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";

const outsideOfHistory = Transaction.addToHistory.of(false);

export class OneStep {
    private before: Text | null = null;
    private made: ChangeSet | null = null;

    constructor(private readonly view: EditorView) {}

    change(changes: ChangeSpec): void {
        const { state } = this.view;
        const transaction = state.update({ changes, annotations: outsideOfHistory });
        this.before ??= state.doc;
        this.made = this.made ? this.made.compose(transaction.changes) : transaction.changes;
        this.view.dispatch(transaction);
    }

    end(): void {
        const { before, made } = this;
        [this.before, this.made] = [null, null];
        if (!before || !made || before.eq(this.view.state.doc)) return;
        const back = this.view.state.update({ changes: made.invert(before), annotations: outsideOfHistory });
        const again = back.state.update({ changes: made, annotations: isolateHistory.of("full") });
        this.view.update([back, again]);
    }
}
