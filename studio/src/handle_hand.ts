// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A hand that holds a handle. Each of its places becomes an edit of the text, the newest one first;
// all of them are one step of undo.

import type { Handle, HandleMove, TextEdit } from "./protocol";

export interface HandleText {
    /** The edits that move a handle, which was at an index of an older text, in the newest one. */
    edits(index: number, handle: Handle, moves: HandleMove[]): Promise<TextEdit[]>;
    hold(edits: TextEdit[]): void;
    release(): void;
    failed(why: unknown): void;
}

export class HandleHand {
    private held: { index: number; handle: Handle } | null = null;
    private wanted: HandleMove[] | null = null;
    private isBusy = false;
    private isAway = false;

    constructor(private readonly text: HandleText) {}

    hold(index: number, handle: Handle): void {
        this.text.release();
        this.held = { index, handle };
        this.isAway = false;
    }

    move(moves: HandleMove[]): void {
        this.wanted = moves;
        void this.follow();
    }

    rest(): void {
        this.isAway = true;
        void this.follow();
    }

    private async follow(): Promise<void> {
        if (this.isBusy) return;
        this.isBusy = true;
        while (this.wanted && this.held) {
            const { index, handle } = this.held;
            const moves = this.wanted;
            this.wanted = null;
            try {
                if (moves.length > 0) this.text.hold(await this.text.edits(index, handle, moves));
            } catch (failure) {
                this.text.failed(failure);
            }
        }
        this.isBusy = false;
        if (!this.isAway) return;
        this.held = null;
        this.text.release();
    }
}
