// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The time that the picture shows, and the keys between which the camera's numbers change.

import type { ParameterKeys } from "./protocol";
import type { Page, Session } from "./session";

export class FilmTime {
    /** In seconds, of the line in this page; null if it has none and the time is that of the server. */
    chosen: number | null = null;
    /** Whether a number that a slider moves gets a key at this time. */
    isKeying = false;
    /** Those of the camera that is chosen, in the text that the server has. */
    keys: ParameterKeys[] = [];

    constructor(
        private readonly session: Session,
        private readonly page: Page,
    ) {}

    /** Frames a second. */
    get rate(): number {
        return this.session.about?.frameRate ?? 24;
    }

    private get isReadOnly(): boolean {
        return this.session.about?.readOnly ?? true;
    }

    /** Whether keys can be written. */
    get hasKeys(): boolean {
        return !this.isReadOnly && this.session.can("text/unkey");
    }

    /** The extensions of films that can be made here: ".mp4". */
    get formats(): string[] {
        return this.isReadOnly || !this.session.can("render/start") ? [] : (this.session.about?.films ?? []);
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

    /** What the server has to know to write values: the line's time, even if the picture has yet to follow it. */
    get asked(): object {
        return { time: this.chosen ?? this.session.camera?.time ?? 0, frame: this.frame, keys: this.isKeying };
    }

    /** Shows a time in seconds. The number of the change; null without a connection. */
    async show(time: number): Promise<number | null> {
        this.chosen = time;
        if (this.session.link !== "open") return null;
        this.session.isAtRest = false;
        try {
            return (await this.session.connection.request<{ change: number }>("view/change", { time })).change;
        } catch {
            return null; // Of a lost connection.
        }
    }

    /** Shows the time of the command line again, when the line is closed. */
    async leave(): Promise<void> {
        const time = this.session.about?.time ?? 0;
        await this.show(time);
        if (this.chosen === time) this.chosen = null;
    }

    toggleKeying(): void {
        this.isKeying = !this.isKeying;
        this.page.changed();
    }

    /** After a change of the text. */
    async learn(): Promise<void> {
        if (!this.session.can("keys")) return;
        try {
            const asked = { camera: this.session.chosen };
            this.keys = (await this.session.connection.request<{ keys: ParameterKeys[] }>("keys", asked)).keys;
        } catch {
            this.keys = []; // The text has no such camera, which is said by its mistakes.
        }
        this.page.changed();
    }

    /** Takes the keys at this time away, as one step of undo. */
    async remove(): Promise<void> {
        this.page.edit(await this.session.editsOf("text/unkey", () => this.asked));
    }
}
