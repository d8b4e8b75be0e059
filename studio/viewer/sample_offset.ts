// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Where the samples of a pixel are, in the order of time.

/** How far a sample can be from the middle of its pixel, in pixels. */
const radius = 1.5;

/** The part of the samples below an offset: as in the renderer's filter (src/render/sampling/pass_offset.cpp). */
function partBelow(offset: number): number {
    const t = offset / (2 * radius) + 0.5;
    const angle = 2 * Math.PI * t;
    const waves = 0.48829 * Math.sin(angle) - 0.07064 * Math.sin(2 * angle) + (0.01168 / 3) * Math.sin(3 * angle);
    return t - waves / (2 * Math.PI * 0.35875);
}

function offsetOf(part: number): number {
    let [below, above] = [-radius, radius];
    while (above - below > 1e-6) {
        const middle = (below + above) / 2;
        if (partBelow(middle) < part) below = middle;
        else above = middle;
    }
    return (below + above) / 2;
}

/** Of a sample, from the middle of the pixel: that is where the first one is. The points before the filter are
 *  those of Roberts' sequence R2. */
export function sampleOffset(number: number): [number, number] {
    const plastic = 1.32471795724474602596;
    return [offsetOf((0.5 + number / plastic) % 1), offsetOf((0.5 + number / plastic ** 2) % 1)];
}
