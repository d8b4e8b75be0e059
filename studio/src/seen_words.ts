// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What stands at a pixel, in words.

import type { PicturePlace, Triple } from "./protocol";

const short = (value: number): string => String(Number(value.toPrecision(4)));
const triple = (values: Triple): string => `(${values.map(short).join(", ")})`;

const coordinate = (value: number, isAngle: boolean): string =>
    isAngle ? `${short((value * 180) / Math.PI)}°` : short(value);

/** `isAngle` is of u and v. */
export function seenWords({ ray, hit }: PicturePlace, isAngle: [boolean, boolean]): { name: string; value: string }[] {
    if (!ray) return [{ name: "", value: "no ray" }];
    const words = [{ name: "", value: hit ? [hit.object, hit.material].filter((one) => one).join(", ") : "nothing" }];
    const say = (name: string, value: string): void => void words.push({ name, value });
    if (ray.layer) say("in", ray.layer);
    if (hit) say("at", short(hit.distance));
    say("u", coordinate(ray.u, isAngle[0]));
    say("v", coordinate(ray.v, isAngle[1]));
    if (hit) say("scale", `${short(hit.magnification)} px a unit`);
    say("ray", `${triple(ray.origin)} → ${triple(ray.direction)}`);
    return words;
}
