// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Numbers of the stages that have no place on the picture. A hand drags each to the right or to the
// left, or arrows move it by steps.

import { html, LitElement, nothing } from "lit";
import { followPointer } from "./follow_pointer";
import type { HandleHand } from "./handle_hand";
import { marksOf, nameOf, numbersOf, type Pair } from "./handle_marks";
import { handStep } from "./number_drag";
import { numberText, rounded } from "./parameter_range";
import type { Handle, HandleNumber } from "./protocol";

const pause = 600;
const degree = Math.PI / 180;
/** Pixels of the hand for one thing. */
const pixelsOfCount = 12;

const unitOf = ({ angle }: HandleNumber): number => (angle ? degree : 1);

const coordinates: Partial<Record<Handle["kind"], string[]>> = {
    space_point: ["x", "y", "z"],
    direction: ["x", "y", "z"],
    interval: ["first", "last"],
    parameter_point: ["u", "v"],
};

interface Held {
    id: string;
    number: HandleNumber;
    step: number;
    by: number;
}

export class StageNumbers extends LitElement {
    static override properties = {
        handles: { attribute: false },
        sliders: { attribute: false },
        pixels: { attribute: false },
    };
    declare handles: Handle[];
    /** The parameters that have sliders. */
    declare sliders: ReadonlySet<string>;
    declare pixels: Pair;
    hand: HandleHand | null = null;
    private held: Held | null = null;
    private timer = 0;

    constructor() {
        super();
        this.handles = [];
        this.sliders = new Set();
        this.pixels = [16, 9];
    }

    override createRenderRoot() {
        return this;
    }

    private hold(id: string, index: number, at: number): void {
        clearTimeout(this.timer);
        if (this.held?.id === id) return;
        const handle = this.handles[index]!;
        const number = handle.numbers[at]!;
        const step = handle.kind === "count" ? 1 : handStep(number.value / unitOf(number)) * unitOf(number);
        this.held = { id, number, step, by: 0 };
        this.hand?.hold(index, handle);
    }

    private move(at: number, by: number): void {
        if (!this.held || by === this.held.by) return;
        this.held.by = by;
        const { number, step } = this.held;
        const unit = unitOf(number);
        const value = rounded((number.value + by * step) / unit, step / unit) * unit;
        this.hand?.move([{ number: at, value, step }]);
    }

    private rest(): void {
        clearTimeout(this.timer);
        if (!this.held) return;
        this.held = null;
        this.hand?.rest();
        this.requestUpdate();
    }

    private pressed(id: string, index: number, at: number, begin: PointerEvent): void {
        if (begin.button !== 0) return;
        const target = begin.currentTarget as HTMLElement;
        target.focus();
        begin.preventDefault();
        this.hold(id, index, at);
        const pixels = this.handles[index]!.kind === "count" ? pixelsOfCount : 1;
        const move = (event: PointerEvent): void =>
            this.move(at, (event.shiftKey ? 10 : 1) * Math.round((event.clientX - begin.clientX) / pixels));
        followPointer(begin, move, () => this.rest());
    }

    private keyed(id: string, index: number, at: number, event: KeyboardEvent): void {
        const forward = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
        if (!forward || event.ctrlKey || event.altKey || event.metaKey) return;
        event.preventDefault();
        event.stopPropagation();
        this.hold(id, index, at);
        this.move(at, this.held!.by + forward * (event.shiftKey ? 10 : 1));
        this.timer = window.setTimeout(() => this.rest(), pause);
    }

    private number(index: number, at: number) {
        const handle = this.handles[index]!;
        const number = handle.numbers[at]!;
        const id = `${index}-${at}`;
        const text = numberText(number.value / unitOf(number)) + (number.angle ? "°" : "");
        const part = handle.numbers.length > 1 ? (coordinates[handle.kind]?.[at] ?? "") : "";
        const name = [nameOf(handle), part].join(" ").trim();
        return html`
            ${part ? html`<span class="part">${part}</span>` : nothing}
            <span
                class="scrub"
                role="slider"
                tabindex=${number.moves ? 0 : nothing}
                aria-disabled=${!number.moves}
                data-number=${id}
                aria-label=${name}
                aria-valuenow=${number.value}
                aria-valuetext=${text}
                @pointerdown=${(event: PointerEvent) => number.moves && this.pressed(id, index, at, event)}
                @keydown=${(event: KeyboardEvent) => number.moves && this.keyed(id, index, at, event)}
                @blur=${() => this.rest()}
                >${text}</span
            >
        `;
    }

    override render() {
        const shown = numbersOf(this.handles, marksOf(this.handles, this.pixels).marks, this.sliders);
        if (shown.length === 0) return nothing;
        return html`<div class="stages" role="group" aria-label="Numbers of the stages">
            ${shown.map((index) => {
                const handle = this.handles[index]!;
                return html`<span class="stage" title=${handle.meaning || nothing}>
                    <span class="name">${nameOf(handle)}</span>
                    ${handle.numbers.map((_, at) => this.number(index, at))}
                </span>`;
            })}
        </div>`;
    }
}

customElements.define("stage-numbers", StageNumbers);
