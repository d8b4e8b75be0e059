// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Below the text: what is wrong with it, and what mends it.

import { html, nothing } from "lit";
import type { Problem } from "./language_server";

export function problemList(
    problems: Problem[],
    go: (problem: Problem) => void,
    mend: (problem: Problem, fix: number) => void,
) {
    if (problems.length === 0) return nothing;
    return html`
        <ul class="problems" aria-label="Problems">
            ${problems.map(
                (problem) => html`
                    <li class=${problem.severity}>
                        <button class="place" @click=${() => go(problem)} title="Go to line ${problem.line}">
                            <span class="line">${problem.line}</span><span>${problem.message.split("\n")[0]}</span>
                        </button>
                        ${problem.fixes.map(
                            ({ title }, index) =>
                                html`<button class="fix" @click=${() => mend(problem, index)}>${title}</button>`,
                        )}
                    </li>
                `,
            )}
        </ul>
    `;
}
