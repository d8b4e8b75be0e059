// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What check finds: areas of the picture, and below it their text.

import { html, nothing, svg } from "lit";
import type { Pair } from "./handle_marks";
import type { Inspection } from "./inspection";
import type { Remark } from "./protocol";

const kindOf = ({ defect }: Remark): string => (defect ? "defect" : "note");

/** The areas of all remarks, on a picture in pixels of the full size that is shown `zoom` times as large. */
export function remarkAreas(remarks: Remark[], chosen: number | null, zoom: number) {
    const path = ({ boxes }: Remark): string =>
        boxes
            .map((box) => box.map((one) => (one * zoom).toFixed(1)))
            .map(([left, top, right, bottom]) => `M${left} ${top}H${right}V${bottom}H${left}Z`)
            .join("");
    const isFaint = (index: number): string => (chosen !== null && chosen !== index ? "faint" : "");
    const areas = remarks.map(
        (one, index) => svg`<path class="remark ${kindOf(one)} ${isFaint(index)}" d=${path(one)} />`,
    );
    const numbers = remarks.map((one, index) =>
        one.at ? numberAt([one.at[0] * zoom, one.at[1] * zoom], `${kindOf(one)} ${isFaint(index)}`, index + 1) : nothing,
    );
    return [areas, numbers];
}

function numberAt([x, y]: Pair, kind: string, number: number) {
    return svg`<circle class="remark-number ${kind}" cx=${x} cy=${y} r="9" />
        <text class="remark-number" x=${x} y=${y + 4}>${number}</text>`;
}

export function remarkList(inspection: Inspection) {
    const { remarks, chosen } = inspection;
    if (!inspection.overlays.has("findings")) return nothing;
    if (remarks === null) return html`<p class="remarks quiet" role="status">Checking the camera…</p>`;
    if (remarks.length === 0) {
        return html`<p class="remarks quiet" role="status">
            No defects: rays everywhere, no folds, no seams, no repeated views.
        </p>`;
    }
    return html`<ol class="remarks" aria-label="What check finds">
        ${remarks.map(
            (one, index) => html`<li
                class="${kindOf(one)} ${index === chosen ? "chosen" : ""}"
                tabindex="0"
                @pointerenter=${() => inspection.choose(index)}
                @pointerleave=${() => inspection.choose(null)}
                @focus=${() => inspection.choose(index)}
                @blur=${() => inspection.choose(null)}
            >
                <b>${one.name}</b> ${one.camera ? html`<span class="quiet">${one.camera}:</span> ` : nothing}${one.message}
                ${one.remedy ? html`<span class="quiet">– ${one.remedy}</span>` : nothing}
            </li>`,
        )}
    </ol>`;
}
