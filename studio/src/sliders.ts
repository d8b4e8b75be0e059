// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The numbers of the camera under the hand. A hand that moves changes the picture, and the text when
// it rests.

import { html, LitElement, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { numberText, rangeOf, rounded, type SliderRange, unitOf } from "./parameter_range";
import type { Parameter, ParameterValue } from "./protocol";

/** How long a hand or a key is still before it rests. */
const pause = 350;

export class ParameterSliders extends LitElement {
    static override properties = {
        parameters: { attribute: false },
        isReadOnly: { type: Boolean },
        canFollow: { attribute: false },
    };
    declare parameters: Parameter[];
    declare isReadOnly: boolean;
    /** The names of those that can follow a hand on the picture. */
    declare canFollow: string[];
    onmove: (values: ParameterValue[]) => void = () => {};
    onrest: (values: ParameterValue[]) => void = () => {};
    /** Those that were moved and are not yet in the text. */
    private moved = new Map<string, number>();
    /** A range stays while the hand moves in it. */
    private ranges = new Map<string, SliderRange>();
    /** Those that do not follow a hand on the picture. */
    private readonly fixed = new Set<string>();
    /** What stands in a field that somebody types in. */
    private typing: { name: string; text: string } | null = null;
    private isHeld = false;
    private timer = 0;

    constructor() {
        super();
        this.parameters = [];
        this.isReadOnly = false;
        this.canFollow = [];
    }

    override createRenderRoot() {
        return this;
    }

    /** The values that the text does not have yet. */
    get values(): ParameterValue[] {
        return [...this.moved].map(([parameter, value]) => ({ parameter, value }));
    }

    /** The text has them now. */
    settle(values: ParameterValue[]): void {
        for (const { parameter, value } of values) {
            if (this.moved.get(parameter) === value) this.moved.delete(parameter);
        }
        this.requestUpdate();
    }

    /** Shows values that a hand on the picture has found; onrest() does not hear of them. */
    show(values: ParameterValue[]): void {
        clearTimeout(this.timer);
        for (const { parameter, value } of values) this.moved.set(parameter, value);
        this.requestUpdate();
    }

    /** Those that are to follow a hand on the picture. */
    get following(): string[] {
        return this.canFollow.filter((name) => !this.fixed.has(name));
    }

    private fix(name: string): void {
        if (!this.fixed.delete(name)) this.fixed.add(name);
        this.requestUpdate();
    }

    forget(): void {
        this.moved.clear();
        this.ranges.clear();
        this.requestUpdate();
    }

    private move(parameter: Parameter, shown: number): void {
        if (!Number.isFinite(shown)) return;
        this.moved.set(parameter.name, shown * unitOf(parameter));
        this.onmove(this.values);
        this.requestUpdate();
        this.rest();
    }

    private rest(): void {
        clearTimeout(this.timer);
        this.timer = window.setTimeout(() => {
            if (this.isHeld || this.moved.size === 0) return;
            this.ranges.clear();
            this.onrest(this.values);
        }, pause);
    }

    private hold(isHeld: boolean): void {
        this.isHeld = isHeld;
        if (!isHeld) this.rest();
    }

    private row(parameter: Parameter) {
        const unit = unitOf(parameter);
        const value = (this.moved.get(parameter.name) ?? parameter.value) / unit;
        const known = this.ranges.get(parameter.name);
        const range = known ?? rangeOf({ ...parameter, value: value * unit });
        this.ranges.set(parameter.name, range);
        const text = numberText(value);
        const sign = parameter.unit === "angle" ? "°" : "";
        const id = `parameter-${parameter.name}`;
        const moved = (event: Event) =>
            this.move(parameter, rounded((event.target as HTMLInputElement).valueAsNumber, range.step));
        const typing = (event: Event) => {
            this.typing = { name: parameter.name, text: (event.target as HTMLInputElement).value };
        };
        const typed = (event: Event) => {
            this.typing = null;
            this.move(parameter, Number.parseFloat((event.target as HTMLInputElement).value));
        };
        const written = this.typing?.name === parameter.name ? this.typing.text : text;
        return html`
            <div class="parameter">
                <label for=${id} title=${parameter.meaning ?? nothing}>${parameter.name}</label>
                ${this.followButton(parameter.name)}
                <input
                    type="range"
                    id=${id}
                    min=${range.min}
                    max=${range.max}
                    step=${range.step}
                    .value=${live(String(value))}
                    ?disabled=${this.isReadOnly}
                    aria-valuetext=${text + sign}
                    @pointerdown=${() => this.hold(true)}
                    @pointerup=${() => this.hold(false)}
                    @pointercancel=${() => this.hold(false)}
                    @input=${moved}
                />
                <span class="number">
                    <input
                        type="text"
                        inputmode="decimal"
                        .value=${live(written)}
                        ?disabled=${this.isReadOnly}
                        aria-label="${parameter.name}${sign ? " in degrees" : ""}"
                        @input=${typing}
                        @change=${typed}
                        @blur=${() => (this.typing = null)}
                    /><span aria-hidden="true">${sign}</span>
                </span>
            </div>
        `;
    }

    private followButton(name: string) {
        if (!this.canFollow.includes(name)) return html`<span></span>`;
        const follows = !this.fixed.has(name);
        return html`<button
            class="follow"
            aria-pressed=${follows}
            aria-label="${name} follows a hand on the picture"
            title=${follows ? "It follows a hand on the picture" : "It stays as it is when a hand drags the picture"}
            @click=${() => this.fix(name)}
        ></button>`;
    }

    // The part of the track before the thumb. A style sheet cannot know it.
    override updated(): void {
        for (const input of this.querySelectorAll<HTMLInputElement>("input[type=range]")) {
            const [min, max] = [Number(input.min), Number(input.max)];
            input.style.setProperty("--part", String((input.valueAsNumber - min) / (max - min)));
        }
    }

    override render() {
        if (this.parameters.length === 0) {
            return html`<p class="quiet none">This camera has no numbers to move. Give it parameters in the text.</p>`;
        }
        return html`<div class="parameters">${this.parameters.map((parameter) => this.row(parameter))}</div>`;
    }
}

customElements.define("parameter-sliders", ParameterSliders);
