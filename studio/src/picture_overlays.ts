// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What is drawn over the picture to understand its camera: lines of equal u and v, the scale, the objects,
// the horizon, circles as the camera shows them, and what check finds.

import { html, LitElement, nothing, svg } from "lit";
import type { Pair } from "./handle_marks";
import { drawn, ellipsesOn } from "./ellipses";
import { contour, type Lattice, levelsOf } from "./lattice";
import { numberText } from "./parameter_range";
import type { PicturePlace, Remark } from "./protocol";
import { remarkAreas } from "./remarks";

export const overlayNames = ["grid", "scale", "objects", "horizon", "ellipses", "findings"] as const;
export type OverlayName = (typeof overlayNames)[number];

type Colour = [number, number, number];

/** An entry of the legend; without a colour, it is about lines. */
interface Key {
    colour: Colour | null;
    words: string;
}

/** Of an entry of the legend, in pixels; picture.css has them, too. */
const keySize: Pair = [170, 18];

/** Dark blue, where a unit of the scene is small, over grey to yellow, where it is large. */
export function scaleColour(part: number): Colour {
    const stops: Colour[] = [[38, 60, 150], [60, 140, 170], [160, 170, 160], [226, 180, 70], [255, 244, 150]];
    const at = Math.min(Math.max(part, 0), 1) * (stops.length - 1);
    const index = Math.min(Math.floor(at), stops.length - 2);
    return stops[index]!.map((from, i) => from + (stops[index + 1]![i]! - from) * (at - index)) as Colour;
}

/** Colours that differ as much as so many can: steps of the golden section around the circle. */
export function objectColour(index: number): Colour {
    const hue = (index * 0.618034) % 1;
    const part = (shift: number): number =>
        Math.round(255 * Math.min(1, Math.max(0, Math.abs(((hue + shift) % 1) * 6 - 3) - 1)) * 0.75 + 50);
    return [part(0), part(2 / 3), part(1 / 3)];
}

export class PictureOverlays extends LitElement {
    static override properties = {
        lattice: { attribute: false },
        shown: { attribute: false },
        isAngle: { attribute: false },
        up: { attribute: false },
        remarks: { attribute: false },
        chosen: { attribute: false },
        pixels: { attribute: false },
    };
    declare lattice: Lattice | null;
    declare shown: ReadonlySet<OverlayName>;
    declare isAngle: [boolean, boolean];
    /** The vertical axis of the scene; null if nobody knows. */
    declare up: [number, number, number] | null;
    declare remarks: Remark[] | null;
    /** The remark that is pointed at, by its index. */
    declare chosen: number | null;
    /** Of the picture in its full size. */
    declare pixels: Pair;

    constructor() {
        super();
        this.lattice = null;
        this.shown = new Set();
        this.isAngle = [false, false];
        this.up = null;
        this.remarks = null;
        this.chosen = null;
        this.pixels = [1, 1];
    }

    override createRenderRoot() {
        return this;
    }

    override connectedCallback(): void {
        super.connectedCallback();
        new ResizeObserver(() => this.requestUpdate()).observe(this);
    }

    private values(of: (place: PicturePlace) => number | null | undefined): (number | null)[] {
        return this.lattice!.places.map((place) => (place && of(place)) ?? null);
    }

    private path(pieces: [Pair, Pair][]): string {
        const { clientWidth: width, clientHeight: height } = this;
        const at = ([x, y]: Pair): string => `${(x * width).toFixed(1)} ${(y * height).toFixed(1)}`;
        return pieces.map(([from, to]) => `M${at(from)}L${at(to)}`).join("");
    }

    private lines(axis: 0 | 1) {
        const { columns, rows } = this.lattice!;
        const values = this.values(({ ray }) => ray && (axis === 0 ? ray.u : ray.v));
        const levels = levelsOf(values, this.isAngle[axis]);
        const leap = levels.length > 1 ? 4 * Math.abs(levels[1]! - levels[0]!) : Infinity;
        const name = "uv"[axis];
        return levels.map((level) => {
            const pieces = contour(values, columns, rows, level, leap);
            if (pieces.length === 0) return nothing;
            const [x, y] = pieces[axis === 0 ? 0 : Math.floor(pieces.length / 2)]![0];
            const text = this.isAngle[axis] ? `${numberText((level * 180) / Math.PI)}°` : numberText(level);
            return svg`<path class="line ${name}" d=${this.path(pieces)} />
                <text x=${x * this.clientWidth + 3} y=${y * this.clientHeight + (axis === 0 ? 12 : -3)}>${name} ${text}</text>`;
        });
    }

    private horizon() {
        if (!this.up) return nothing;
        const { up } = this;
        const { columns, rows } = this.lattice!;
        const values = this.values(({ ray }) => ray && ray.direction.reduce((sum, one, i) => sum + one * up[i]!, 0));
        return svg`<path class="line horizon" d=${this.path(contour(values, columns, rows, 0, 1))} />`;
    }

    /** Of each point of the lattice, and what they mean. */
    private colours(): { colours: (Colour | null)[]; legend: Key[]; isSmooth: boolean } | null {
        const { places } = this.lattice!;
        if (this.shown.has("scale")) {
            const logs = places.map((one) => (one?.hit && one.hit.magnification > 0 ? Math.log(one.hit.magnification) : null));
            // A hundredth at each end is edges of objects.
            const known = logs.filter((one) => one !== null).sort((a, b) => a - b);
            if (known.length === 0) return null;
            const [least, most] = [known[Math.floor(0.01 * known.length)]!, known[Math.floor(0.99 * (known.length - 1))]!];
            const part = (value: number): number => (most > least ? (value - least) / (most - least) : 0.5);
            return {
                colours: logs.map((one) => (one === null ? null : scaleColour(part(one)))),
                legend: [0, 0.5, 1].map((at) => ({
                    colour: scaleColour(at),
                    words: `${Number(Math.exp(least + at * (most - least)).toPrecision(3))} px a unit`,
                })),
                isSmooth: true,
            };
        }
        if (!this.shown.has("objects")) return null;
        const count = new Map<string, number>();
        for (const one of places) if (one?.hit) count.set(one.hit.object, (count.get(one.hit.object) ?? 0) + 1);
        const names = [...count.keys()].sort();
        const largest = [...names].sort((a, b) => count.get(b)! - count.get(a)!).slice(0, 12);
        return {
            colours: places.map((one) => (one?.hit ? objectColour(names.indexOf(one.hit.object)) : null)),
            legend: largest.map((name) => ({ colour: objectColour(names.indexOf(name)), words: name })),
            isSmooth: false,
        };
    }

    /** As many as the picture has room for, in columns of so many rows. */
    private legend(keys: Key[]) {
        const [columns, rows] = [this.clientWidth, this.clientHeight].map((side, axis) =>
            Math.max(1, Math.floor((side - 36) / keySize[axis]!)),
        ) as Pair;
        const shown = keys.length > columns * rows ? keys.slice(0, columns * rows) : keys;
        return html`<ul class="legend" data-rows=${Math.min(rows, shown.length)} aria-label="Legend">
            ${shown.map(
                ({ colour, words }) =>
                    html`<li class=${colour ? "coloured" : ""} title=${words}>${colour ? html`<i data-colour=${colour.join(" ")}></i>` : nothing}${words}</li>`,
            )}
        </ul>`;
    }

    override updated(): void {
        const legend = this.querySelector<HTMLElement>(".legend");
        if (legend) legend.style.gridTemplateRows = `repeat(${legend.dataset.rows}, ${keySize[1]}px)`;
        for (const one of this.querySelectorAll<HTMLElement>("[data-colour]")) {
            one.style.background = `rgb(${one.dataset.colour})`;
        }
        const canvas = this.querySelector("canvas");
        const made = this.lattice && this.colours();
        if (!canvas || !made) return;
        const { columns, rows } = this.lattice!;
        [canvas.width, canvas.height] = [columns, rows];
        const image = new ImageData(columns, rows);
        for (const [index, colour] of made.colours.entries()) {
            if (colour) image.data.set([...colour, 255], 4 * index);
        }
        canvas.getContext("2d")!.putImageData(image, 0, 0);
    }

    override render() {
        const { lattice, shown } = this;
        const made = lattice && this.colours();
        const circles = lattice && shown.has("ellipses") ? ellipsesOn(lattice, [this.clientWidth, this.clientHeight]) : null;
        const keys = made?.legend ?? [];
        if (circles && circles.radius > 0) {
            const words = `circles of radius ${numberText(circles.radius)}`;
            keys.push({ colour: null, words: circles.ellipses.some((one) => one.isReduced) ? `${words}; dotted: drawn smaller` : words });
        }
        return html`
            ${made ? html`<canvas class=${made.isSmooth ? "smooth" : ""} aria-hidden="true"></canvas>` : nothing}
            <svg aria-hidden="true">
                ${lattice && shown.has("grid") ? [this.lines(0), this.lines(1)] : nothing}
                ${lattice && shown.has("horizon") ? this.horizon() : nothing}
                ${circles ? drawn(circles.ellipses) : nothing}
                ${shown.has("findings") && this.remarks
                    ? remarkAreas(this.remarks, this.chosen, this.clientWidth / this.pixels[0])
                    : nothing}
            </svg>
            ${keys.length > 0 ? this.legend(keys) : nothing}
        `;
    }
}

customElements.define("picture-overlays", PictureOverlays);
