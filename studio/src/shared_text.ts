// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The text that this page shares with the server and with other pages. The server numbers its
// versions and takes an edit only if it is of the newest one. One edit is on its way at a time; what is
// typed meanwhile waits.

import { ChangeSet, Text } from "@codemirror/state";

export const textOf = (text: string): Text => Text.of(text.split(/\r\n?|\n/));

/** The change from one text to another, as one replacement. */
export function difference(before: string, after: string): ChangeSet {
    const shorter = Math.min(before.length, after.length);
    let begin = 0;
    while (begin < shorter && before[begin] === after[begin]) ++begin;
    let end = 0;
    while (end < shorter - begin && before[before.length - 1 - end] === after[after.length - 1 - end]) ++end;
    const insert = after.slice(begin, after.length - end);
    return ChangeSet.of({ from: begin, to: before.length - end, insert: textOf(insert) }, before.length);
}

export class SharedText {
    version = 0;
    private agreed = Text.empty;
    private sent: { changes: ChangeSet; text: Text } | null = null;
    private unsent: ChangeSet | null = null;
    private isConnected = false;
    private readonly settled: (() => void)[] = [];

    /** `send` resolves when the server has handled the edit, taken or not. */
    constructor(private readonly send: (version: number, text: string) => Promise<void>) {}

    /** Whether the server has all that was typed. */
    get isSettled(): boolean {
        return !this.sent && !this.unsent;
    }

    /** Resolves when the server has been sent all that was typed. */
    async whenSent(): Promise<void> {
        while (this.unsent && this.isConnected) await new Promise<void>((resolve) => this.settled.push(resolve));
    }

    async whenSettled(): Promise<void> {
        while (!this.isSettled && this.isConnected) await new Promise<void>((resolve) => this.settled.push(resolve));
    }

    begin(version: number, text: string): void {
        [this.version, this.agreed, this.sent, this.unsent] = [version, textOf(text), null, null];
        this.isConnected = true;
    }

    made(changes: ChangeSet): void {
        this.unsent = this.unsent ? this.unsent.compose(changes) : changes;
        void this.pump();
    }

    disconnected(): void {
        this.isConnected = false;
        this.tell();
    }

    /** After a lost connection to the same server. Returns what changes in the editor. */
    reconnected(version: number, text: string): ChangeSet | null {
        this.isConnected = true;
        // Whether the last edit had arrived is to be seen by the text.
        if (version === this.version + 1 && this.sent?.text.eq(textOf(text))) this.accept(this.sent);
        this.takeBack();
        const changes = version === this.version ? null : this.merge(version, text);
        void this.pump();
        return changes;
    }

    /** A new server has what is on the disk; it gets the text of this page. */
    restarted(version: number, text: string, mine: string): void {
        this.begin(version, text);
        if (textOf(text).toString() !== mine) this.made(difference(this.agreed.toString(), mine));
    }

    /** Another page has changed the text. Returns what changes in the editor. */
    told(version: number, text: string): ChangeSet | null {
        if (version <= this.version) return null;
        const sent = this.sent;
        // Each version is one page's edit, and all others are told: if the next one is skipped, it was ours.
        if (sent && version > this.version + 1) this.accept(sent);
        this.takeBack();
        const changes = this.merge(version, text);
        void this.pump();
        return changes;
    }

    private accept({ text }: { text: Text }): void {
        this.version += 1;
        this.agreed = text;
        this.sent = null;
    }

    private takeBack(): void {
        if (!this.sent) return;
        const { changes } = this.sent;
        this.unsent = this.unsent ? changes.compose(this.unsent) : changes;
        this.sent = null;
    }

    private merge(version: number, text: string): ChangeSet | null {
        const theirs = difference(this.agreed.toString(), textOf(text).toString());
        const mine = this.unsent;
        this.version = version;
        this.agreed = textOf(text);
        if (mine) this.unsent = mine.map(theirs, true);
        const changes = mine ? theirs.map(mine) : theirs;
        return changes.empty ? null : changes;
    }

    private async pump(): Promise<void> {
        if (this.sent || !this.unsent || !this.isConnected) return;
        const sent = { changes: this.unsent, text: this.unsent.apply(this.agreed) };
        this.sent = sent;
        this.unsent = null;
        try {
            const handled = this.send(this.version + 1, sent.text.toString());
            this.tell();
            await handled;
        } catch {
            return; // Lost: reconnected() decides about it.
        }
        if (this.sent !== sent) return;
        this.accept(sent);
        this.tell();
        await this.pump();
    }

    private tell(): void {
        for (const resolve of this.settled.splice(0)) resolve();
    }
}
