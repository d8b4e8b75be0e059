// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The camera that is shown in other languages.

import { html, nothing } from "lit";
import { offerText } from "./dialogs";
import type { Exported } from "./protocol";
import type { Session } from "./session";

/** How people write them. */
const words: Record<string, string> = { osl: "OSL", glsl: "GLSL", c: "C", numpy: "NumPy", torch: "PyTorch", mitsuba: "Mitsuba", pov: "POV-Ray" };

export function exportChoice({ about }: Session, choose: (language: string) => void) {
    const languages = about?.languages ?? [];
    if (languages.length === 0) return nothing;
    return html`<div class="group exports" role="group" aria-label="Export the camera">
        <span class="heading">Export the camera</span>
        ${languages.map(
            ({ name, meaning }) =>
                html`<button role="menuitem" id="export-${name}" title=${meaning} @click=${() => choose(name)}>
                    ${words[name] ?? name}
                </button>`,
        )}
    </div>`;
}

/** Says what was done with the text. Throws why a camera cannot be exported. */
export async function exportCamera({ connection }: Session, language: string): Promise<string | null> {
    const { file, text, diagnostics } = await connection.request<Exported>("export", { language });
    return offerText(file, text, diagnostics.map(({ message }) => message));
}
