// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The pixels of the picture: those of its room, or as many as one chooses.

export type SizeChoice = { kind: "fit" } | { kind: "wide"; width: number } | { kind: "exact"; size: [number, number] };

export const widths = [480, 960, 1280, 1920];

/** The server takes no larger picture while it follows the hand. */
const longest = 4096;

const whole = (value: number): number => Math.max(16, Math.min(longest, Math.round(value)));

/** `room` is in pixels of the screen. */
export function sizeOf(choice: SizeChoice, aspect: number, room: [number, number]): [number, number] {
    if (choice.kind === "exact") return [whole(choice.size[0]), whole(choice.size[1])];
    const width = choice.kind === "wide" ? choice.width : Math.min(room[0], room[1] * aspect, 1920);
    return [whole(width), whole(width / aspect)];
}

export const nameOf = (choice: SizeChoice): string =>
    choice.kind === "fit" ? "fit" : choice.kind === "wide" ? String(choice.width) : choice.size.join("x");

/** Of `fit`, `960` or `960x540`; null for other words. */
export function choiceOf(name: string): SizeChoice | null {
    if (name === "fit") return { kind: "fit" };
    const numbers = /^(\d{2,4})(?:\s*[x×]\s*(\d{2,4}))?$/.exec(name.trim());
    if (!numbers) return null;
    const [width, height] = [Number(numbers[1]), Number(numbers[2])];
    return numbers[2] === undefined ? { kind: "wide", width } : { kind: "exact", size: [width, height] };
}
