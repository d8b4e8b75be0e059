// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The time that the picture shows, and the keys between which the camera's numbers change.

import type { Connection } from "./connection";
import type { About, ParameterKeys, TextEdit } from "./protocol";

/** What it needs of the session. */
export interface FilmText {
    readonly about: About | null;
    readonly link: string;
    isAtRest: boolean;
    readonly connection: Connection;
    readonly chosen: string;
    can(request: string): boolean;
    editsOf(method: string, asked: () => object): Promise<TextEdit[]>;
    edit(edits: TextEdit[]): void;
    changed(): void;
}

export class FilmTime {
    /** In seconds. */
    time = 0;
    /** Whether a number that a slider moves gets a key at this time. */
    isKeying = false;
    /** Those of the camera that is chosen, in the text that the server has. */
    keys: ParameterKeys[] = [];

    constructor(private readonly text: FilmText) {}

    /** Frames a second. */
    get rate(): number {
        return this.text.about?.frameRate ?? 24;
    }

    private get isReadOnly(): boolean {
        return this.text.about?.readOnly ?? true;
    }

    /** Whether keys can be written. */
    get hasKeys(): boolean {
        return !this.isReadOnly && this.text.can("text/unkey");
    }

    /** The extensions of films that can be made here: ".mp4". */
    get formats(): string[] {
        return this.isReadOnly || !this.text.can("render/start") ? [] : (this.text.about?.films ?? []);
    }

    private get frame(): number {
        return 1 / this.rate;
    }

    /** The frames that have keys, from 1 at the time 0, and whose. */
    get keyFrames(): Map<number, string[]> {
        const found = new Map<number, string[]>();
        for (const { parameter, times } of this.keys) {
            for (const time of times) {
                const frame = Math.round(time / this.frame) + 1;
                found.set(frame, [...(found.get(frame) ?? []), parameter]);
            }
        }
        return found;
    }

    /** What the server has to know to write values. */
    get asked(): object {
        return { time: this.time, frame: this.frame, keys: this.isKeying };
    }

    /** Shows a time in seconds. The number of the change; null without a connection. */
    async show(time: number): Promise<number | null> {
        this.time = time;
        if (this.text.link !== "open") return null;
        this.text.isAtRest = false;
        try {
            return (await this.text.connection.request<{ change: number }>("view/change", { time })).change;
        } catch {
            return null; // Of a lost connection.
        }
    }

    toggleKeying(): void {
        this.isKeying = !this.isKeying;
        this.text.changed();
    }

    /** After a change of the text. */
    async learn(): Promise<void> {
        if (!this.text.can("keys")) return;
        try {
            const asked = { camera: this.text.chosen };
            this.keys = (await this.text.connection.request<{ keys: ParameterKeys[] }>("keys", asked)).keys;
        } catch {
            this.keys = []; // The text has no such camera, which is said by its mistakes.
        }
        this.text.changed();
    }

    /** Takes the keys at this time away, as one step of undo. */
    async remove(): Promise<void> {
        this.text.edit(await this.text.editsOf("text/unkey", () => this.asked));
    }
}
