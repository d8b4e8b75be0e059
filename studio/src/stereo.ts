// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The menu's group of what the two eyes see.

import { html, nothing } from "lit";
import type { Session } from "./session";

const item = (words: string, title: string, isChosen: boolean, act: () => void) =>
    html`<button role="menuitemradio" aria-checked=${isChosen} title=${title} @click=${act}>${words}</button>`;

/** The picture of one eye, or one of the formats; `show` gets its name, or null. */
export function stereoChoice({ about, camera }: Session, show: (format: string | null) => void) {
    if (!about?.stereoFormats) return nothing;
    return html`<div class="group" role="group" aria-label="Stereo" id="stereo">
        <span class="heading">Stereo</span>
        ${item("One eye", "The picture without stereo", !camera?.stereo, () => show(null))}
        ${about.stereoFormats.map(({ name, meaning }) =>
            item(name.replaceAll("_", " "), meaning, camera?.stereo === name, () => show(name)),
        )}
    </div>`;
}
