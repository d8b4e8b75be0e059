// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The handles on the picture. A hand drags them, or arrows move them by pixels.

import { html, LitElement, nothing, svg } from "lit";
import { followPointer } from "./follow_pointer";
import type { HandleHand } from "./handle_hand";
import { type Mark, type Marks, marksOf, type Outline, type Pair } from "./handle_marks";
import { numberText } from "./parameter_range";
import type { Handle } from "./protocol";

/** How long a key is still before the handle rests. */
const pause = 600;

/** How near to the border of the picture a handle stands, in pixels of the screen, so that a hand can take it. */
const border = 8;

const arrows: Record<string, Pair> = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, -1],
    ArrowDown: [0, 1],
};

interface Held {
    mark: Mark;
    /** How far the hand has moved, as fractions of the picture. */
    by: Pair;
}

export class PictureHandles extends LitElement {
    static override properties = { handles: { attribute: false }, pixels: { attribute: false } };
    declare handles: Handle[];
    /** The size of the picture at rest. */
    declare pixels: Pair;
    hand: HandleHand | null = null;
    private held: Held | null = null;
    private shown: Marks = { marks: [], outlines: [] };
    private timer = 0;

    constructor() {
        super();
        this.handles = [];
        this.pixels = [16, 9];
    }

    override createRenderRoot() {
        return this;
    }

    override connectedCallback(): void {
        super.connectedCallback();
        new ResizeObserver(() => this.requestUpdate()).observe(this);
    }

    focusFirst(): void {
        this.querySelector<SVGElement>("[role=slider]")?.focus();
    }

    override willUpdate(): void {
        this.shown = marksOf(this.handles, this.pixels);
    }

    private hold(mark: Mark): void {
        clearTimeout(this.timer);
        if (this.held?.mark.id === mark.id) return;
        this.held = { mark, by: [0, 0] };
        this.hand?.hold(mark.handle, this.handles[mark.handle]!);
    }

    private move(by: Pair): void {
        if (!this.held) return;
        this.held.by = by;
        this.hand?.move(this.held.mark.moves(by));
        this.requestUpdate();
    }

    private rest(): void {
        clearTimeout(this.timer);
        if (!this.held) return;
        this.held = null;
        this.hand?.rest();
        this.requestUpdate();
    }

    private pressed(mark: Mark, begin: PointerEvent): void {
        if (begin.button !== 0) return;
        const target = begin.currentTarget as SVGElement;
        target.focus();
        begin.preventDefault();
        begin.stopPropagation();
        this.hold(mark);
        // A hand takes what waits at the border from there.
        const [x, y] = this.placeOf(mark);
        const [left, top] = [x / this.clientWidth - mark.at[0], y / this.clientHeight - mark.at[1]];
        const move = (event: PointerEvent): void =>
            this.move([
                left + (event.clientX - begin.clientX) / this.clientWidth,
                top + (event.clientY - begin.clientY) / this.clientHeight,
            ]);
        followPointer(begin, move, () => this.rest());
    }

    private keyed(mark: Mark, event: KeyboardEvent): void {
        const arrow = arrows[event.key];
        if (!arrow || event.ctrlKey || event.altKey || event.metaKey) return;
        event.preventDefault();
        event.stopPropagation();
        this.hold(mark);
        const pixels = event.shiftKey ? 10 : 1;
        const [x, y] = this.held!.by;
        this.move([x + (arrow[0] * pixels) / this.pixels[0], y + (arrow[1] * pixels) / this.pixels[1]]);
        this.timer = window.setTimeout(() => this.rest(), pause);
    }

    /** Where it is on the screen; what is outside of the picture waits at its border. */
    private placeOf({ at, shape }: { at: Pair; shape: Mark["shape"] }): Pair {
        const margin = shape === "side" ? 0 : border;
        const within = (value: number, size: number): number => Math.min(size - margin, Math.max(margin, value));
        return [within(at[0] * this.clientWidth, this.clientWidth), within(at[1] * this.clientHeight, this.clientHeight)];
    }

    private outline(outline: Outline) {
        const { clientWidth: width, clientHeight: height } = this;
        if (outline.kind === "region") {
            const [x0, x1] = [outline.from[0], outline.to[0]].sort((a, b) => a - b) as Pair;
            const [y0, y1] = [outline.from[1], outline.to[1]].sort((a, b) => a - b) as Pair;
            return svg`<rect class="outline" x=${x0 * width} y=${y0 * height}
                width=${(x1 - x0) * width} height=${(y1 - y0) * height} />`;
        }
        return svg`<ellipse class="outline" cx=${outline.at[0] * width} cy=${outline.at[1] * height}
            rx=${outline.radius[0] * width} ry=${outline.radius[1] * height} />`;
    }

    private mark(now: Mark) {
        const isHeld = this.held?.mark.id === now.id;
        const { at } = isHeld ? this.held!.mark : now;
        const by = isHeld ? this.held!.by : [0, 0];
        const [x, y] = this.placeOf({ at: [at[0] + by[0]!, at[1] + by[1]!], shape: now.shape });
        const { numbers, meaning } = this.handles[now.handle]!;
        const told = numbers.map(({ value, angle }) => (angle ? `${numberText((value * 180) / Math.PI)}°` : numberText(value)));
        const label = `${now.label}: ${told.join(", ")}`;
        // The label stands where there is room for it.
        const isRight = x > this.clientWidth * 0.7;
        const isBelow = y < 40;
        return svg`
            <g class="mark ${now.shape} ${isHeld ? "held" : ""}" transform="translate(${x} ${y})" tabindex="0" role="slider"
                data-mark=${now.id} aria-label=${now.label} aria-valuenow=${numbers[0]!.value} aria-valuetext=${told.join(", ")}
                @pointerdown=${(event: PointerEvent) => this.pressed(now, event)}
                @keydown=${(event: KeyboardEvent) => this.keyed(now, event)}
                @blur=${() => this.rest()}
            >
                <title>${meaning ? `${label}\n${meaning}` : label}</title>
                <circle class="reach" r="15" />
                ${this.shapeOf(now)}
                <text x=${isRight ? -14 : 14} y=${isBelow ? 22 : -12} text-anchor=${isRight ? "end" : "start"}
                    aria-hidden="true">${label}</text>
            </g>`;
    }

    private shapeOf({ shape, at }: Mark) {
        if (shape === "corner") return svg`<rect class="knob" x="-5" y="-5" width="10" height="10" />`;
        if (shape === "radius") return svg`<circle class="knob" r="4.5" />`;
        if (shape !== "side") return svg`<circle class="knob" r="7" /><circle class="pupil" r="1.5" />`;
        const isUpright = at[1] === 0.5;
        // Half of it would be outside.
        const [dx, dy] = [at[0] === 0 ? 4 : at[0] === 1 ? -4 : 0, at[1] === 0 ? 4 : at[1] === 1 ? -4 : 0];
        const [width, height] = isUpright ? [6, 30] : [30, 6];
        return svg`<rect class="knob" x=${dx - width / 2} y=${dy - height / 2} width=${width} height=${height} rx="3" />`;
    }

    override render() {
        const { marks, outlines } = this.shown;
        if (marks.length === 0) return nothing;
        return html`<svg role="group" aria-label="Handles on the picture">
            ${outlines.map((one) => this.outline(one))} ${marks.map((one) => this.mark(one))}
        </svg>`;
    }
}

customElements.define("picture-handles", PictureHandles);
