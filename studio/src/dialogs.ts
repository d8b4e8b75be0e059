// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Questions to the person at the page. Each is an element <dialog>, which keeps the keyboard inside and
// closes with Escape, and a promise of the answer.

import { html, nothing, render, type TemplateResult } from "lit";
import type { RenderOrder } from "./protocol";

/** The form's fields by name, and the button that was pressed; null if it was closed. */
function ask(title: string, body: TemplateResult | string, buttons: [string, string][]): Promise<FormData | null> {
    const dialog = document.createElement("dialog");
    dialog.setAttribute("aria-label", title);
    render(
        html`
            <form method="dialog">
                <h2>${title}</h2>
                ${body}
                <p class="buttons">
                    <button type="button" @click=${() => dialog.close()}>${buttons.length > 0 ? "Cancel" : "Close"}</button>
                    ${buttons.map(
                        ([value, words], index) =>
                            html`<button class=${index === buttons.length - 1 ? "main" : ""} value=${value}>${words}</button>`,
                    )}
                </p>
            </form>
        `,
        dialog,
    );
    document.body.append(dialog);
    dialog.showModal();
    return new Promise((resolve) => {
        let answer: FormData | null = null;
        dialog.querySelector("form")!.addEventListener("submit", (event) => {
            answer = new FormData(event.target as HTMLFormElement, event.submitter);
            answer.set("button", (event.submitter as HTMLButtonElement | null)?.value ?? "");
        });
        dialog.addEventListener("close", () => {
            dialog.remove();
            resolve(answer);
        });
    });
}

const numberField = (name: string, words: string, value: number, most: number) => html`
    <label><span>${words}</span><input type="number" name=${name} value=${value} min="1" max=${most} required /></label>
`;

export async function askForSize(size: [number, number]): Promise<string | null> {
    const answer = await ask(
        "Size of the picture",
        html`<div class="fields">
            ${numberField("width", "Width", size[0], 4096)} ${numberField("height", "Height", size[1], 4096)}
        </div>`,
        [["size", "Show"]],
    );
    return answer && `${answer.get("width")}x${answer.get("height")}`;
}

const checkField = (name: string, words: string, isChecked: boolean) => html`
    <label><span>${words}</span><input type="checkbox" name=${name} ?checked=${isChecked} /></label>
`;

/** The fields of a film or a picture that are not those of both come first. */
async function askForOrder(
    title: string,
    [width, height]: [number, number],
    samples: number,
    outputs: [string, string][],
    more: TemplateResult | typeof nothing,
): Promise<RenderOrder | null> {
    const answer = await ask(
        title,
        html`<div class="fields">
            ${more} ${numberField("width", "Width", width, 65536)} ${numberField("height", "Height", height, 65536)}
            ${numberField("samples", "Samples a pixel", samples, 65536)} ${checkField("denoise", "Without noise", true)}
            <label>
                <span>File</span>
                <select name="output">
                    ${outputs.map(([value, words]) => html`<option value=${value}>${words}</option>`)}
                </select>
            </label>
        </div>`,
        [["render", "Render"]],
    );
    if (!answer) return null;
    const order: RenderOrder = {
        width: Number(answer.get("width")),
        height: Number(answer.get("height")),
        samples: Number(answer.get("samples")),
        denoise: answer.has("denoise"),
        output: String(answer.get("output")),
    };
    return answer.has("frames") ? { ...order, frames: Number(answer.get("frames")), turntable: answer.has("turntable") } : order;
}

export function askForRender(size: [number, number]): Promise<RenderOrder | null> {
    const outputs: [string, string][] = [
        ["png", "PNG, for the screen"],
        ["exr", "EXR, with all its light"],
    ];
    return askForOrder("Render in full quality", size, 64, outputs, nothing);
}

/** The films are extensions of files. */
export function askForFilm(size: [number, number], frames: number, films: string[]): Promise<RenderOrder | null> {
    const outputs = films.map((one): [string, string] => [one.slice(1), one.slice(1).toUpperCase()]);
    const more = html`
        ${numberField("frames", "Frames", frames, 1_000_000)}
        ${checkField("turntable", "Once round the scene", false)}
    `;
    return askForOrder("Render a film", size, 32, outputs, more);
}

export async function askForName(name: string): Promise<string | null> {
    const answer = await ask(
        `Another name for ${name}`,
        html`<div class="fields">
            <label><span>Name</span><input name="name" value=${name} required autofocus pattern="[A-Za-z_][A-Za-z_0-9]*" /></label>
        </div>`,
        [["rename", "Rename"]],
    );
    return answer && String(answer.get("name"));
}

export async function confirm(title: string, words: string, action: string): Promise<boolean> {
    return (await ask(title, html`<p>${words}</p>`, [["yes", action]])) !== null;
}

export async function showText(title: string, text: string): Promise<void> {
    await ask(title, html`<textarea readonly rows="8" cols="80" aria-label=${title} .value=${text}></textarea>`, []);
}

/** A text to copy or to save as a file, with what is to be known about it. Says what was done. */
export async function offerText(file: string, text: string, remarks: string[]): Promise<string | null> {
    const answer = await ask(
        file,
        html`
            ${remarks.map((words) => html`<p class="warning">${words}</p>`)}
            <pre tabindex="0" aria-label="Text of ${file}">${text}</pre>
        `,
        [["copy", "Copy"], ["save", "Download"]],
    );
    if (answer?.get("button") === "save") download(file, text);
    if (answer?.get("button") !== "copy") return null;
    await navigator.clipboard.writeText(text);
    return `Copied ${file}`;
}

function download(file: string, text: string): void {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
    link.download = file;
    link.click();
    URL.revokeObjectURL(link.href);
}

const keys: [string, string][] = [
    ["Ctrl+S", "save the file"],
    ["Ctrl+Enter", "render in full quality"],
    ["Alt+1, Alt+2, Alt+3", "go to the text, to the sliders, to the handles on the picture"],
    ["Ctrl+Z, Ctrl+Y", "undo, redo, also what a slider has changed"],
    ["Ctrl and the mouse", "drag a number of the text; with Shift, ten times as far"],
    ["the mouse on the picture", "pull a point where it is wanted; a click keeps what is said of one"],
    ["Shift and a click", "hold a point of the picture while others are pulled"],
    ["Escape", "give up a drag"],
    ["Ctrl+Space", "show what can stand at the cursor"],
    ["Tab", "go to the next blank of a call, or leave the text"],
    ["F8", "go to the next mistake"],
    ["F12", "go to where a name is declared; with Shift, select all its places"],
    ["F2", "give the name at the cursor another one"],
    ["Shift+Alt+F", "format the text"],
    ["Ctrl+F", "find and replace"],
    ["arrows", "move a slider by a step, a handle by a pixel; with Shift, a handle by ten"],
];

export async function showKeys(): Promise<void> {
    const rows = keys.map(([key, words]) => html`<dt><kbd>${key}</kbd></dt><dd>${words}</dd>`);
    await ask("Keys", html`<dl class="keys">${rows}</dl>`, []);
}
