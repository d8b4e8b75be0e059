// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The camera in space, beside its picture.

import { html, LitElement, nothing } from "lit";
import type { Lattice } from "./lattice";
import type { PicturePlace, Triple } from "./protocol";
import type { Colour, SpaceScene } from "./space_scene";

export class CameraSpace extends LitElement {
    static override properties = {
        lattice: { attribute: false },
        colours: { attribute: false },
        seen: { attribute: false },
        up: { attribute: false },
    };
    declare lattice: Lattice | null;
    declare colours: Colour[];
    /** The pixel under the hand. */
    declare seen: PicturePlace | null;
    declare up: Triple | null;
    /** A point of the scene was clicked. */
    onpick: (point: Triple) => void = () => {};
    private space: SpaceScene | null = null;
    private failure = "";
    private isFresh = false;

    constructor() {
        super();
        this.lattice = null;
        this.colours = [];
        this.seen = null;
        this.up = null;
    }

    override createRenderRoot() {
        return this;
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        this.space?.dispose();
        this.space = null;
    }

    override async firstUpdated(): Promise<void> {
        const canvas = this.querySelector("canvas")!;
        try {
            const { SpaceScene } = await import("./space_scene");
            this.space = new SpaceScene(canvas, this.up ?? [0, 1, 0]);
        } catch (failure) {
            this.failure = failure instanceof Error ? failure.message : String(failure);
            this.requestUpdate();
            return;
        }
        new ResizeObserver(() => this.space?.resize(this.clientWidth, this.clientHeight)).observe(this);
        this.isFresh = false;
        this.requestUpdate();
    }

    override willUpdate(changed: Map<string, unknown>): void {
        if (changed.has("lattice")) this.isFresh = false;
    }

    override updated(changed: Map<string, unknown>): void {
        if (!this.space) return;
        if (!this.isFresh && this.lattice) {
            this.space.show(this.lattice, this.colours);
            this.isFresh = true;
        }
        if (changed.has("seen")) this.space.hover(this.seen);
    }

    private clicked(event: MouseEvent): void {
        const { left, top, width, height } = this.getBoundingClientRect();
        const x = ((event.clientX - left) / width) * 2 - 1;
        const point = this.space?.pick(x, 1 - ((event.clientY - top) / height) * 2);
        if (point) this.onpick(point);
    }

    override render() {
        return html`
            <canvas
                tabindex="0"
                role="img"
                aria-label="The camera in space: points that it sees, and its rays"
                ?hidden=${this.failure !== ""}
                @dblclick=${(event: MouseEvent) => this.clicked(event)}
            ></canvas>
            ${this.failure
                ? html`<p class="none quiet">This browser cannot draw in space: it has no WebGL. The rest of the page needs none.</p>`
                : nothing}
            ${this.lattice || this.failure ? nothing : html`<span class="spinner"></span>`}
        `;
    }
}

customElements.define("camera-space", CameraSpace);
