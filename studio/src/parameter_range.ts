// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The range of a parameter's slider, in the unit that is shown, and its numbers as text.

import type { Parameter } from "./protocol";

export interface SliderRange {
    min: number;
    max: number;
    step: number;
}

const degree = Math.PI / 180;

export const unitOf = (parameter: Parameter): number => (parameter.unit === "angle" ? degree : 1);

/** A step of a power of ten that divides a range into 500 to 5000. */
const stepOf = (span: number): number => 10 ** Math.floor(Math.log10(span / 500));

/** The limits of the language, and where there are none, room around the value. */
export function rangeOf(parameter: Parameter): SliderRange {
    const unit = unitOf(parameter);
    const value = parameter.value / unit;
    const isAngle = parameter.unit === "angle";
    const size = Math.abs(value);
    const around = isAngle ? Math.max(180, 2 * size) : size === 0 ? 10 : 2 * size;
    const isSigned = isAngle || value <= 0;
    let min = parameter.min === undefined ? undefined : parameter.min / unit;
    let max = parameter.max === undefined ? undefined : parameter.max / unit;
    if (min === undefined) min = max === undefined ? (isSigned ? -around : 0) : Math.min(isSigned ? -around : 0, max - 1);
    if (max === undefined) max = Math.max(around, min + (min === 0 ? 1 : Math.abs(min)));
    const step = stepOf(max - min);
    // An excluded end is one step away.
    return { min: parameter.minExcluded ? min + step : min, max, step };
}

/** In as many digits as anybody reads. */
export const numberText = (value: number): string => String(Number(value.toPrecision(6)));

/** Without the digits that are smaller than a step. */
export const rounded = (value: number, step: number): number =>
    Number(value.toFixed(Math.max(0, Math.round(-Math.log10(step)))));
