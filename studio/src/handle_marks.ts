// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Where handles stand on the picture, and what they become when a hand moves them there. Places are
// fractions of the picture, from its top left corner.

import type { Handle, HandleMove, HandleNumber } from "./protocol";

export type Pair = [number, number];

export interface Mark {
    /** The same for the same handle of the next text. */
    id: string;
    /** The index of its handle. */
    handle: number;
    shape: "point" | "corner" | "side" | "radius";
    label: string;
    at: Pair;
    /** What numbers become when it has moved so far. */
    moves(by: Pair): HandleMove[];
}

/** What is drawn for handles that are more than a point. */
export type Outline = { kind: "region"; from: Pair; to: Pair } | { kind: "ring"; at: Pair; radius: Pair };

export interface Marks {
    marks: Mark[];
    outlines: Outline[];
}

/** How the map lays (u, v) on the picture. */
interface Plane {
    u: Pair;
    v: Pair;
}

const rangeOf = (handle: Handle): Pair => [handle.numbers[0]!.value, handle.numbers[1]!.value];
const span = ([first, last]: Pair): number => last - first;

function planeOf(handles: Handle[], aspect: number): Plane | null {
    const range = (name: string): Handle | undefined =>
        handles.find((one) => one.kind === "interval" && one.parameter === name);
    const [u, v] = [range("u"), range("v")];
    if (!u) return null;
    const half = Math.abs(span(rangeOf(u))) / 2 / aspect;
    return { u: rangeOf(u), v: v ? rangeOf(v) : [-half, half] };
}

/** The stage and the parameter; a point that is a stage's x, y and z is called by the stage. */
export function nameOf({ kind, statement, stage, parameter, index }: Handle): string {
    const ofStage = kind === "space_point" && parameter === "x" ? "" : parameter;
    return [stage || statement, ofStage, index > 0 ? String(index + 1) : ""].filter((part) => part !== "").join(" ");
}

/** The handle that is the same in another list, where texts before it may be longer. */
export const isSame = (a: Handle, b: Handle): boolean =>
    a.kind === b.kind && a.statement === b.statement && nameOf(a) === nameOf(b);

/** In the same unit as u and v, which may be angles. */
const isRadius = ({ kind, parameter }: Handle): boolean =>
    (kind === "size" || kind === "angle") && parameter === "radius";

/** By how much a number changes for a whole picture, and for a pixel of it. */
interface Rate {
    number: number;
    axis: 0 | 1;
    whole: number;
}

class Collector {
    readonly marks: Mark[] = [];
    readonly outlines: Outline[] = [];
    private readonly plane: Plane | null;

    constructor(
        private readonly handles: Handle[],
        private readonly size: Pair,
    ) {
        this.plane = planeOf(handles, size[0] / size[1]);
    }

    collect(): Marks {
        for (const index of this.handles.keys()) this.add(index);
        return { marks: this.marks, outlines: this.outlines };
    }

    private mark(index: number, shape: Mark["shape"], part: string, at: Pair, rates: Rate[]): void {
        const handle = this.handles[index]!;
        const moving = rates.filter(({ number, whole }) => handle.numbers[number]!.moves && whole !== 0);
        if (moving.length === 0) return;
        this.marks.push({
            id: `${index}-${part}`,
            handle: index,
            shape,
            label: [nameOf(handle), part].filter((word) => word !== "").join(", "),
            at,
            moves: (by) =>
                moving
                    .filter(({ axis }) => by[axis] !== 0)
                    .map(({ number, axis, whole }) => ({
                        number,
                        value: handle.numbers[number]!.value + by[axis] * whole,
                        step: Math.abs(whole) / this.size[axis],
                    })),
        });
    }

    private add(index: number): void {
        const handle = this.handles[index]!;
        const value = (number: number): number => handle.numbers[number]!.value;
        if (handle.kind === "interval" && handle.statement === "map") this.addRange(index, handle);
        else if (handle.kind === "picture_point") {
            this.mark(index, "point", "", [value(0), value(1)], pictureRates(0));
        } else if (handle.kind === "picture_region") this.addRegion(index, value);
        else if (handle.kind === "parameter_point" && this.plane) {
            this.mark(index, "point", "", this.placeOf([value(0), value(1)]), this.planeRates(0));
        } else if (isRadius(handle) && this.plane) this.addRadius(index, handle);
    }

    private addRange(index: number, { parameter, numbers }: Handle): void {
        const whole = span([numbers[0]!.value, numbers[1]!.value]);
        if (parameter === "u") {
            this.mark(index, "side", "left", [0, 0.5], [{ number: 0, axis: 0, whole }]);
            this.mark(index, "side", "right", [1, 0.5], [{ number: 1, axis: 0, whole }]);
        } else {
            this.mark(index, "side", "bottom", [0.5, 1], [{ number: 0, axis: 1, whole: -whole }]);
            this.mark(index, "side", "top", [0.5, 0], [{ number: 1, axis: 1, whole: -whole }]);
        }
    }

    private addRegion(index: number, value: (number: number) => number): void {
        const from: Pair = [value(0), value(1)];
        const to: Pair = [value(2), value(3)];
        this.outlines.push({ kind: "region", from, to });
        const middle: Pair = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
        this.mark(index, "point", "", middle, [...pictureRates(0), ...pictureRates(2)]);
        this.mark(index, "corner", "top left", from, pictureRates(0));
        this.mark(index, "corner", "bottom right", to, pictureRates(2));
    }

    /** Around the point of the same stage. */
    private addRadius(index: number, handle: Handle): void {
        const isOfStage = (other: Handle): boolean =>
            other.stage === handle.stage && JSON.stringify(other.range) === JSON.stringify(handle.range);
        const centre = this.handles.find((other) => other.kind === "parameter_point" && isOfStage(other));
        const radii = this.handles.filter((one) => one.parameter === handle.parameter && isOfStage(one));
        if (!centre) return;
        const at = this.placeOf(rangeOf(centre));
        const { u, v } = this.plane!;
        const radius = (axis: 0 | 1): number => (radii[axis] ?? radii[0]!).numbers[0]!.value;
        const size: Pair = [Math.abs(radius(0) / span(u)), Math.abs(radius(1) / span(v))];
        if (handle.index === 0) {
            this.outlines.push({ kind: "ring", at, radius: size });
            this.mark(index, "radius", "", [at[0] + size[0], at[1]], [{ number: 0, axis: 0, whole: Math.abs(span(u)) }]);
        } else {
            this.mark(index, "radius", "", [at[0], at[1] - size[1]], [{ number: 0, axis: 1, whole: -Math.abs(span(v)) }]);
        }
    }

    private placeOf([u, v]: Pair): Pair {
        const plane = this.plane!;
        return [(u - plane.u[0]) / span(plane.u), 1 - (v - plane.v[0]) / span(plane.v)];
    }

    private planeRates(first: number): Rate[] {
        const { u, v } = this.plane!;
        return [
            { number: first, axis: 0, whole: span(u) },
            { number: first + 1, axis: 1, whole: -span(v) },
        ];
    }
}

const pictureRates = (first: number): Rate[] => [
    { number: first, axis: 0, whole: 1 },
    { number: first + 1, axis: 1, whole: 1 },
];

/** Of a picture of so many pixels. */
export const marksOf = (handles: Handle[], size: Pair): Marks => new Collector(handles, size).collect();

/** Handles without a place on the picture, as far as the numbers of the camera do not move all that they are. */
export function numbersOf(handles: Handle[], marks: Mark[], sliders: ReadonlySet<string>): number[] {
    const placed = new Set(marks.map(({ handle }) => handle));
    const isNew = ({ moves, parameter }: HandleNumber): boolean =>
        moves && (parameter === undefined || !sliders.has(parameter));
    return [...handles.keys()].filter((index) => !placed.has(index) && handles[index]!.numbers.some(isNew));
}
