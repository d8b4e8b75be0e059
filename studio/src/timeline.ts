// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Below the picture: the time that it shows, by frames as `balcony animate` counts them, and what plays it.

import { html, LitElement, nothing } from "lit";
import type { FilmTime } from "./film_time";

/** Where nothing tells how long a film is, in seconds. */
const usual = 5;
const longest = 3600;

export class TimeLine extends LitElement {
    static override properties = {
        film: { attribute: false, hasChanged: () => true },
        animation: { attribute: false },
        shown: { attribute: false },
        seconds: { state: true },
        frame: { state: true },
        isPlaying: { state: true },
    };
    /** What it shows and moves. */
    declare film: FilmTime;
    /** How long the scene's animations are, in seconds; 0 if nothing of it moves. */
    declare animation: number;
    /** The change that the picture shows. */
    declare shown: number;
    /** Length that was chosen; null for that of the scene. */
    declare seconds: number | null;
    /** From 1, at the time 0. */
    declare frame: number;
    declare isPlaying: boolean;
    failed: (why: unknown) => void = () => {};
    onfilm: (frames: number) => void = () => {};
    private sent = 0;
    private isSending = false;
    private began = 0;

    constructor() {
        super();
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
        this.film.isKeying = false;
    }

    get time(): number {
        return (this.frame - 1) / this.film.rate;
    }

    get frames(): number {
        return Math.max(1, Math.floor((this.seconds ?? (this.animation || usual)) * this.film.rate + 1e-6) + (this.seconds === null && this.animation > 0 ? 1 : 0));
    }

    async go(frame: number): Promise<void> {
        this.frame = Math.min(Math.max(1, frame), this.frames);
        this.isSending = true;
        this.sent = (await this.film.show(this.time)) ?? this.sent;
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
        const frame = Math.floor(((performance.now() - this.began) / 1000) * this.film.rate + 1e-6) + 1;
        if (frame > this.frames) this.began = performance.now();
        const next = frame > this.frames ? 1 : frame;
        if (next !== this.frame) void this.go(next);
    }

    private scrub(event: Event): void {
        this.jump(Number((event.target as HTMLInputElement).value));
    }

    private chooseLength(event: Event): void {
        const seconds = Number((event.target as HTMLInputElement).value);
        this.seconds = seconds > 0 ? Math.min(seconds, longest) : null;
        if (this.frame > this.frames) void this.go(this.frames);
    }

    private unkey(): void {
        this.film.remove().catch((why: unknown) => this.failed(why));
    }

    private key(at: number, names: string[]) {
        const part = this.frames > 1 ? (at - 1) / (this.frames - 1) : 0;
        return html`<button
            class="key ${at === this.frame ? "here" : ""}"
            data-part=${part}
            title="Frame ${at}: ${names.join(", ")}"
            aria-label="Key at frame ${at}"
            @click=${() => this.jump(at)}
        ></button>`;
    }

    private jump(frame: number): void {
        this.isPlaying = false;
        void this.go(frame);
    }

    // The page has no styles in attributes.
    override updated(): void {
        for (const key of this.querySelectorAll<HTMLElement>(".key")) key.style.setProperty("--part", key.dataset.part!);
    }

    override render() {
        const { frame, frames } = this;
        const keys = this.film.keyFrames;
        return html`
            <button id="play" aria-pressed=${this.isPlaying} @click=${() => this.toggle()}>${this.isPlaying ? "Pause" : "Play"}</button>
            ${this.film.hasKeys
                ? html`<button
                      id="keying"
                      aria-pressed=${this.film.isKeying}
                      title="A number that a slider moves gets a key at this frame"
                      @click=${() => this.film.toggleKeying()}
                  >
                      ◆ Keys
                  </button>`
                : nothing}
            <div class="track">
                ${[...keys].filter(([at]) => at >= 1 && at <= frames).map(([at, names]) => this.key(at, names))}
                <input
                    type="range"
                    min="1"
                    max=${frames}
                    .value=${String(frame)}
                    aria-label="Frame"
                    aria-valuetext="frame ${frame}, ${this.time.toFixed(2)} seconds"
                    @input=${(event: Event) => this.scrub(event)}
                />
            </div>
            ${this.film.hasKeys && keys.has(frame)
                ? html`<button id="unkey" title="Keys of ${keys.get(frame)!.join(", ")}" @click=${() => this.unkey()}>
                      Remove key
                  </button>`
                : nothing}
            <span class="number">${this.time.toFixed(2)} s</span>
            <span class="quiet number">frame ${frame} of ${frames}</span>
            <label class="choice">
                <span>Length</span>
                <input type="number" min="0.1" max=${longest} step="0.1" .value=${(frames / this.film.rate).toFixed(2)}
                    aria-label="Length in seconds" @change=${(event: Event) => this.chooseLength(event)} />
            </label>
            ${this.film.formats.length > 0
                ? html`<button id="film" title="Render all frames as a film" @click=${() => this.onfilm(frames)}>Film…</button>`
                : nothing}
        `;
    }
}

customElements.define("time-line", TimeLine);
