// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Tissot's ellipses: how the camera shows circles of one size that stand across its rays.

import { svg } from "lit";
import type { Pair } from "./handle_marks";
import type { Lattice } from "./lattice";
import type { Triple } from "./protocol";

export interface Ellipse {
    /** In pixels of the screen. */
    at: Pair;
    /** Half of the longer and of the shorter axis. */
    half: Pair;
    /** Of the longer axis, in degrees, clockwise from the right. */
    angle: number;
    /** It is larger than there is room for, and drawn smaller. */
    isReduced: boolean;
}

/** The pixels between ellipses, at least. */
const apart = 34;

/** The steps p of a metric with length 1: the halves of the axes, the longer one first, and its angle. */
export function axesOf([xx, xy, yy]: Triple): { half: Pair; angle: number } {
    const middle = (xx + yy) / 2;
    const spread = Math.hypot((xx - yy) / 2, xy);
    const angle = Math.atan2(2 * xy, xx - yy) / 2 + Math.PI / 2;
    return { half: [1 / Math.sqrt(Math.max(middle - spread, 0)), 1 / Math.sqrt(middle + spread)], angle };
}

/** A number with one digit that is not larger. */
function roundBelow(value: number): number {
    const tens = 10 ** Math.floor(Math.log10(value));
    return Math.floor(value / tens + 1e-9) * tens;
}

/** Those on a picture with pixels of the screen, and the radius of the circles, in units of the scene. */
export function ellipsesOn({ columns, rows, size, places }: Lattice, screen: Pair): { ellipses: Ellipse[]; radius: number } {
    const [cell, zoom] = [screen[0] / columns, screen[0] / size[0]];
    const every = Math.max(1, Math.ceil(apart / cell));
    const found: { at: Pair; half: Pair; angle: number }[] = [];
    for (let row = Math.floor((rows % every) / 2); row < rows; row += every) {
        for (let column = Math.floor((columns % every) / 2); column < columns; column += every) {
            const place = places[row * columns + column]!;
            const { half, angle } = place.hit?.metric ? axesOf(place.hit.metric) : { half: [0, 0] as Pair, angle: 0 };
            if (!(half[1] > 0) || !Number.isFinite(half[0])) continue;
            found.push({ at: [place.x * zoom, place.y * zoom], half: [half[0] * zoom, half[1] * zoom], angle });
        }
    }
    if (found.length === 0) return { ellipses: [], radius: 0 };
    const room = 0.48 * every * cell;
    const lengths = found.map(({ half }) => half[0]).sort((a, b) => a - b);
    // So large that most of them fit.
    const radius = roundBelow(room / lengths[Math.floor(0.9 * (lengths.length - 1))]!);
    const ellipses = found.map(({ at, half, angle }) => {
        const reduced = Math.min(1, room / (half[0] * radius));
        return {
            at,
            half: [half[0] * radius * reduced, half[1] * radius * reduced] as Pair,
            angle: (angle * 180) / Math.PI,
            isReduced: reduced < 1,
        };
    });
    return { ellipses, radius };
}

export const drawn = (ellipses: Ellipse[]) =>
    ellipses.map(
        ({ at: [x, y], half, angle, isReduced }) =>
            svg`<ellipse class=${isReduced ? "reduced" : ""} rx=${half[0]} ry=${half[1]}
                transform="translate(${x} ${y}) rotate(${angle})" />`,
    );
