// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The numbers of the camera as sliders.

import { numberText, rangeOf, rounded, unitOf } from "../src/parameter_range";
import type { Parameter } from "../src/protocol";

export class Sliders {
    /** Values in the order of the parameters: in radians if they are angles. */
    readonly values: number[];
    onmove: () => void = () => {};
    /** A hand is down or up. */
    onhold: (isHeld: boolean) => void = () => {};
    private readonly updates: (() => void)[] = [];

    constructor(
        parent: HTMLElement,
        private readonly parameters: Parameter[],
    ) {
        this.values = parameters.map(({ value }) => value);
        parent.append(...parameters.map((parameter, index) => this.row(parameter, index)));
    }

    reset(): void {
        this.parameters.forEach(({ value }, index) => (this.values[index] = value));
        for (const update of this.updates) update();
        this.onmove();
    }

    private row(parameter: Parameter, index: number): HTMLElement {
        const unit = unitOf(parameter);
        const range = rangeOf(parameter);
        const sign = parameter.unit === "angle" ? "°" : parameter.unit === "seconds" ? "s" : "";
        const [row, label, slider, number, field, mark] = (
            ["div", "label", "input", "span", "input", "span"] as const
        ).map((name) => document.createElement(name)) as [
            HTMLElement,
            HTMLLabelElement,
            HTMLInputElement,
            HTMLElement,
            HTMLInputElement,
            HTMLElement,
        ];
        const id = `parameter-${index}`;
        Object.assign(label, { htmlFor: id, textContent: parameter.name });
        Object.assign(slider, { id, type: "range", min: String(range.min), max: String(range.max), step: "any" });
        Object.assign(field, { type: "text", inputMode: "decimal", autocomplete: "off" });
        field.setAttribute("aria-label", `${parameter.name}${sign === "°" ? " in degrees" : sign ? " in seconds" : ""}`);
        Object.assign(mark, { className: "unit", textContent: sign });
        const update = () => {
            const shown = this.values[index]! / unit;
            slider.value = String(shown);
            slider.setAttribute("aria-valuetext", numberText(shown) + sign);
            field.value = numberText(shown);
        };
        const move = (shown: number) => {
            if (Number.isFinite(shown)) this.values[index] = shown * unit;
            update();
            this.onmove();
        };
        slider.addEventListener("input", () => move(rounded(slider.valueAsNumber, range.step)));
        slider.addEventListener("pointerdown", () => this.onhold(true));
        for (const up of ["pointerup", "pointercancel", "lostpointercapture"]) {
            slider.addEventListener(up, () => this.onhold(false));
        }
        // A step of a key is a hundredth of the range.
        slider.addEventListener("keydown", (event) => {
            const hundredth = (range.max - range.min) / 100;
            const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
            if (steps === undefined) return;
            event.preventDefault();
            const wanted = this.values[index]! / unit + steps * hundredth;
            move(rounded(Math.min(range.max, Math.max(range.min, wanted)), range.step));
        });
        const within = (shown: number) =>
            Math.max(parameter.min === undefined ? shown : range.min, Math.min(shown, (parameter.max ?? Infinity) / unit));
        field.addEventListener("change", () => move(within(Number.parseFloat(field.value))));
        this.updates.push(update);
        update();
        row.className = "parameter";
        number.className = "number";
        number.append(field, mark);
        row.append(label, number, slider);
        return row;
    }
}
