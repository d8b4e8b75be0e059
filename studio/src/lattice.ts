// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What stands at the points of a lattice of the picture. Overlays and the view of the camera in space are
// made of it.

import type { Pair } from "./handle_marks";
import type { PicturePlace, Seen } from "./protocol";

export interface Lattice {
    columns: number;
    rows: number;
    /** The picture in pixels of its full size. */
    size: Pair;
    /** Row by row from the top. */
    places: PicturePlace[];
}

/** From the server's answer, which has what stands in the middle of each cell. */
export function latticeFrom(seen: Seen[], columns: number, rows: number, size: Pair): Lattice {
    const middle = (index: number): PicturePlace => ({
        x: (((index % columns) + 0.5) / columns) * size[0],
        y: ((Math.floor(index / columns) + 0.5) / rows) * size[1],
        ...seen[index]!,
    });
    return { columns, rows, size, places: seen.map((_, index) => middle(index)) };
}

/** About as many points as the overlays need, in cells that are nearly square. */
export function latticeOf([width, height]: Pair, points = 1600): Pair {
    const columns = Math.max(4, Math.round(Math.sqrt((points * width) / height)));
    return [columns, Math.max(4, Math.round(points / columns))];
}

/**
 * The line where values on a lattice have a level, as pieces between fractions of the picture. No piece
 * crosses a cell that has a point without a value, or that the values leap over, as at the seam of an angle.
 */
export function contour(values: (number | null)[], columns: number, rows: number, level: number, leap: number): [Pair, Pair][] {
    const pieces: [Pair, Pair][] = [];
    const place = (column: number, row: number): Pair => [(column + 0.5) / columns, (row + 0.5) / rows];
    for (let row = 0; row + 1 < rows; ++row) {
        for (let column = 0; column + 1 < columns; ++column) {
            // Around the cell.
            const corners: Pair[] = [[column, row], [column + 1, row], [column + 1, row + 1], [column, row + 1]];
            const found = corners.map(([x, y]) => values[y * columns + x] ?? null);
            if (found.some((value) => value === null)) continue;
            const numbers = found as number[];
            if (Math.max(...numbers) - Math.min(...numbers) > leap) continue;
            const crossings: Pair[] = [];
            for (let side = 0; side < 4; ++side) {
                const [a, b] = [numbers[side]! - level, numbers[(side + 1) % 4]! - level];
                if (a < 0 === b < 0) continue;
                const part = a / (a - b);
                const [from, to] = [place(...corners[side]!), place(...corners[(side + 1) % 4]!)];
                crossings.push([from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]);
            }
            for (let i = 0; i + 1 < crossings.length; i += 2) pieces.push([crossings[i]!, crossings[i + 1]!]);
        }
    }
    return pieces;
}

/** Round numbers in a range, of about so many; angles in steps of degrees that divide a turn. */
export function levelsOf(values: (number | null)[], isAngle: boolean, count = 12): number[] {
    const known = values.filter((value) => value !== null);
    if (known.length === 0) return [];
    const [least, most] = [Math.min(...known), Math.max(...known)];
    if (most === least) return [];
    const unit = isAngle ? Math.PI / 180 : 1;
    const wanted = (most - least) / count / unit;
    const tens = 10 ** Math.floor(Math.log10(wanted));
    const steps = isAngle && wanted >= 10 ? [10, 15, 30, 45, 90] : [tens, 2 * tens, 5 * tens, 10 * tens];
    const step = (steps.find((one) => one >= wanted) ?? steps.at(-1)!) * unit;
    const levels: number[] = [];
    for (let n = Math.ceil(least / step); n * step <= most; ++n) levels.push(n * step);
    return levels;
}
