// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Below the picture: the time that it shows, by frames as `balcony animate` counts them, and what plays it.

import { html, LitElement } from "lit";

/** Where nothing tells how long a film is, in seconds. */
const usual = 5;
const longest = 3600;

export class TimeLine extends LitElement {
    static override properties = {
        rate: { attribute: false },
        animation: { attribute: false },
        shown: { attribute: false },
        seconds: { state: true },
        frame: { state: true },
        isPlaying: { state: true },
    };
    /** Frames a second. */
    declare rate: number;
    /** How long the scene's animations are, in seconds; 0 if nothing of it moves. */
    declare animation: number;
    /** The change that the picture shows. */
    declare shown: number;
    /** Length that was chosen; null for that of the scene. */
    declare seconds: number | null;
    /** From 1, at the time 0. */
    declare frame: number;
    declare isPlaying: boolean;
    /** Shows a time. The number of the change, or null without a connection. */
    onmove: (time: number) => Promise<number | null> = async () => null;
    private sent = 0;
    private isSending = false;
    private began = 0;

    constructor() {
        super();
        this.rate = 24;
        this.animation = 0;
        this.shown = 0;
        this.seconds = null;
        this.frame = 1;
        this.isPlaying = false;
    }

    override createRenderRoot() {
        return this;
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        this.isPlaying = false;
    }

    get time(): number {
        return (this.frame - 1) / this.rate;
    }

    get frames(): number {
        return Math.max(1, Math.floor((this.seconds ?? (this.animation || usual)) * this.rate + 1e-6) + (this.seconds === null && this.animation > 0 ? 1 : 0));
    }

    async go(frame: number): Promise<void> {
        this.frame = Math.min(Math.max(1, frame), this.frames);
        this.isSending = true;
        this.sent = (await this.onmove(this.time)) ?? this.sent;
        this.isSending = false;
    }

    toggle(): void {
        this.isPlaying = !this.isPlaying;
        if (!this.isPlaying) return;
        if (this.frame >= this.frames) this.frame = 1;
        this.began = performance.now() - this.time * 1000;
        requestAnimationFrame(() => this.play());
    }

    /** Frames that the picture cannot follow are left out, so that time goes on as it does in a film. */
    private play(): void {
        if (!this.isPlaying) return;
        requestAnimationFrame(() => this.play());
        if (this.isSending || this.shown < this.sent) return;
        const frame = Math.floor(((performance.now() - this.began) / 1000) * this.rate + 1e-6) + 1;
        if (frame > this.frames) this.began = performance.now();
        const next = frame > this.frames ? 1 : frame;
        if (next !== this.frame) void this.go(next);
    }

    private scrub(event: Event): void {
        this.isPlaying = false;
        void this.go(Number((event.target as HTMLInputElement).value));
    }

    private chooseLength(event: Event): void {
        const seconds = Number((event.target as HTMLInputElement).value);
        this.seconds = seconds > 0 ? Math.min(seconds, longest) : null;
        if (this.frame > this.frames) void this.go(this.frames);
    }

    override render() {
        const { frame, frames } = this;
        return html`
            <button id="play" aria-pressed=${this.isPlaying} @click=${() => this.toggle()}>${this.isPlaying ? "Pause" : "Play"}</button>
            <input
                type="range"
                min="1"
                max=${frames}
                .value=${String(frame)}
                aria-label="Frame"
                aria-valuetext="frame ${frame}, ${this.time.toFixed(2)} seconds"
                @input=${(event: Event) => this.scrub(event)}
            />
            <span class="number">${this.time.toFixed(2)} s</span>
            <span class="quiet number">frame ${frame} of ${frames}</span>
            <label class="choice">
                <span>Length</span>
                <input type="number" min="0.1" max=${longest} step="0.1" .value=${(frames / this.rate).toFixed(2)}
                    aria-label="Length in seconds" @change=${(event: Event) => this.chooseLength(event)} />
            </label>
        `;
    }
}

customElements.define("time-line", TimeLine);
