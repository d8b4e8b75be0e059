// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The picture, and over it what keeps it from following the text.

import { html, LitElement, nothing } from "lit";
import type { Problem } from "./language_server";
import type { Lattice } from "./lattice";
import { bitmapOf } from "./picture_bytes";
import type { FrameHead } from "./protocol";

export class LivePicture extends LitElement {
    static override properties = {
        problem: { attribute: false },
        waiting: {},
        isBusy: { type: Boolean },
        label: {},
        ratio: { type: Number },
        over: { attribute: false },
        words: { attribute: false },
    };
    declare problem: Problem | null;
    /** What is waited for, or why there is no picture; nothing if there is one. */
    declare waiting: string;
    declare isBusy: boolean;
    declare label: string;
    /** Width / height of the picture at rest; a coarse one may differ by a pixel. */
    declare ratio: number;
    /** What stands over the picture, in the same size. */
    declare over: unknown;
    /** What stands at the border of its room. */
    declare words: unknown;
    /** Makes a mistake go away, or shows it. */
    onfix: (problem: Problem, fix: number) => void = () => {};
    onplace: (problem: Problem) => void = () => {};
    private received = 0;
    private drawn = 0;
    private hasPicture = false;

    constructor() {
        super();
        this.problem = null;
        this.waiting = "";
        this.isBusy = true;
        this.label = "";
        this.ratio = 16 / 9;
        this.over = nothing;
        this.words = nothing;
    }

    /** The style sheet of the page holds for it. */
    override createRenderRoot() {
        return this;
    }

    /** The room of the picture in pixels of the screen. */
    get room(): [number, number] {
        const { clientWidth, clientHeight } = this;
        return [clientWidth * devicePixelRatio, clientHeight * devicePixelRatio];
    }

    /** Resolves when it is on the canvas, to false if a newer one came first. */
    async show(head: FrameHead, bytes: Uint8Array): Promise<boolean> {
        const order = ++this.received;
        const image = await bitmapOf(head, bytes);
        if (order < this.drawn) {
            image.close();
            return false;
        }
        this.drawn = order;
        const canvas = this.querySelector("canvas")!;
        if (canvas.width !== head.width || canvas.height !== head.height) {
            canvas.width = head.width;
            canvas.height = head.height;
        }
        canvas.getContext("2d", { alpha: false })!.drawImage(image, 0, 0);
        image.close();
        if (!this.hasPicture) {
            this.hasPicture = true;
            this.requestUpdate();
        }
        return true;
    }

    /** What the picture shows at the points of a lattice. */
    coloursOf({ columns, rows }: Lattice): [number, number, number][] {
        const canvas = this.querySelector("canvas")!;
        const { width, height } = canvas;
        const { data } = canvas.getContext("2d", { alpha: false })!.getImageData(0, 0, width, height);
        return Array.from({ length: columns * rows }, (_, index) => {
            const x = Math.floor((((index % columns) + 0.5) / columns) * width);
            const y = Math.floor(((Math.floor(index / columns) + 0.5) / rows) * height);
            const at = 4 * (y * width + x);
            return [data[at]!, data[at + 1]!, data[at + 2]!];
        });
    }

    override updated(): void {
        this.style.setProperty("--ratio", String(this.ratio));
    }

    override render() {
        const { problem } = this;
        return html`
            <div class="frame ${problem ? "stale" : ""} ${this.hasPicture ? "" : "empty"}">
                <canvas role="img" aria-label=${this.label} width="16" height="9"></canvas>
                ${this.over}
            </div>
            ${this.words} ${problem ? this.message(problem) : nothing}
            ${this.waiting && !problem
                ? html`<div class="waiting">
                      ${this.isBusy ? html`<span class="spinner"></span>` : nothing}<span>${this.waiting}</span>
                  </div>`
                : nothing}
        `;
    }

    private message(problem: Problem) {
        const [said, ...remedy] = problem.message.split("\n");
        return html`
            <div class="message" role="alert">
                <p><strong>${said}</strong></p>
                ${remedy.length > 0 ? html`<p class="quiet">${remedy.join("\n")}</p>` : nothing}
                <p class="actions">
                    ${problem.fixes.map(
                        ({ title }, index) =>
                            html`<button class="main" @click=${() => this.onfix(problem, index)}>${title}</button>`,
                    )}
                    <button @click=${() => this.onplace(problem)}>Go to line ${problem.line}</button>
                </p>
                ${this.hasPicture ? html`<p class="quiet">The picture is that of the last good text.</p>` : nothing}
            </div>
        `;
    }
}

customElements.define("live-picture", LivePicture);
