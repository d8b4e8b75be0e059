// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The picture as a thing to touch, and the marks of what is held.

import { html, LitElement, nothing, svg } from "lit";
import { followPointer } from "./follow_pointer";
import type { Pair } from "./handle_marks";
import type { Grip, PictureHand } from "./picture_hand";

/** From so many pixels of the screen on, a press is a drag. */
const slack = 4;

export class PictureTouch extends LitElement {
    static override properties = {
        pixels: { attribute: false },
        hand: { attribute: false },
        canDrag: { type: Boolean },
        grips: { attribute: false },
        crosses: { attribute: false },
    };
    declare pixels: Pair;
    declare hand: PictureHand;
    declare canDrag: boolean;
    declare grips: Grip[];
    /** Places that are marked. */
    declare crosses: Pair[];

    constructor() {
        super();
        this.pixels = [16, 9];
        this.canDrag = false;
        this.grips = [];
        this.crosses = [];
    }

    override createRenderRoot() {
        return this;
    }

    override connectedCallback(): void {
        super.connectedCallback();
        new ResizeObserver(() => this.requestUpdate()).observe(this);
    }

    /** The pixel of the full size under a pointer. */
    private placeOf(event: PointerEvent): Pair {
        const { left, top, width, height } = this.getBoundingClientRect();
        const x = ((event.clientX - left) / width) * this.pixels[0];
        const y = ((event.clientY - top) / height) * this.pixels[1];
        const last = (size: number): number => size - 0.5;
        return [Math.min(Math.max(x, 0), last(this.pixels[0])), Math.min(Math.max(y, 0), last(this.pixels[1]))];
    }

    private pressed(begin: PointerEvent): void {
        if (begin.button !== 0) return;
        const from = this.placeOf(begin);
        let isDrag = false;
        const move = (event: PointerEvent): void => {
            const far = Math.hypot(event.clientX - begin.clientX, event.clientY - begin.clientY) > slack;
            if (!isDrag && far && this.canDrag) {
                isDrag = true;
                void this.hand.take(from);
            }
            if (isDrag) this.hand.pull(this.placeOf(event));
        };
        const cancel = (event: KeyboardEvent): void => {
            if (event.key === "Escape") this.hand.cancel();
        };
        const end = (event: Event): void => {
            removeEventListener("keydown", cancel, { capture: true });
            if (isDrag) void this.hand.release();
            else if (begin.shiftKey && this.canDrag) void this.hand.pin(from);
            else void this.hand.keep(this.hand.isKept ? null : from);
            event.stopPropagation();
        };
        followPointer(begin, move, end);
        addEventListener("keydown", cancel, { capture: true });
    }

    private screen([x, y]: Pair): Pair {
        return [(x / this.pixels[0]) * this.clientWidth, (y / this.pixels[1]) * this.clientHeight];
    }

    private grip({ pull, told }: Grip, index: number) {
        const isPin = pull.from === pull.to || index < this.hand.pins.length;
        const wanted = this.screen(pull.to);
        const at = this.screen(told?.at ?? pull.to);
        const misses = told !== null && !told.follows;
        const words = told && !told.at ? "not seen" : misses ? `${Math.round(told.miss)} px away` : "";
        return svg`<g class="grip ${isPin ? "pin" : "pulled"} ${misses ? "misses" : ""}">
            <line x1=${at[0]} y1=${at[1]} x2=${wanted[0]} y2=${wanted[1]} />
            <circle class="wanted" cx=${wanted[0]} cy=${wanted[1]} r="9" />
            <circle class="there" cx=${at[0]} cy=${at[1]} r="3" />
            ${words ? svg`<text x=${wanted[0] + 14} y=${wanted[1] - 8}>${words}</text>` : nothing}
            ${isPin
                ? svg`<circle class="unpin" cx=${wanted[0]} cy=${wanted[1]} r="13" tabindex="0" role="button"
                    aria-label="Pin ${index + 1}: take it off"
                    @click=${() => this.hand.unpin(index)}
                    @keydown=${(event: KeyboardEvent) => {
                        if (event.key === "Enter" || event.key === "Delete") this.hand.unpin(index);
                    }}><title>Held here. A click takes the pin off.</title></circle>`
                : nothing}
        </g>`;
    }

    private cross(place: Pair) {
        const [x, y] = this.screen(place);
        return svg`<path class="cross" d="M${x - 12} ${y}h8M${x + 4} ${y}h8M${x} ${y - 12}v8M${x} ${y + 4}v8" />`;
    }

    override render() {
        return html`<svg
            class=${this.canDrag ? "drags" : ""}
            @pointermove=${(event: PointerEvent) => this.hand.hover(this.placeOf(event))}
            @pointerleave=${() => this.hand.leave()}
        >
            <rect class="area" width="100%" height="100%" @pointerdown=${(event: PointerEvent) => this.pressed(event)} />
            ${this.grips.map((grip, index) => this.grip(grip, index))} ${this.crosses.map((one) => this.cross(one))}
        </svg>`;
    }
}

customElements.define("picture-touch", PictureTouch);
