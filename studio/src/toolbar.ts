// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The bar above the picture.

import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { exportChoice } from "./exports";
import type { Inspection } from "./inspection";
import { type OverlayName, overlayNames } from "./picture_overlays";
import { nameOf, type SizeChoice, widths } from "./picture_size";
import type { Session } from "./session";
import { stereoChoice } from "./stereo";
import { type Theme, themes } from "./theme";

export interface ToolbarActions {
    camera(name: string): void;
    /** Shows all built-in cameras. */
    wall(): void;
    /** By the words of choiceOf(). */
    size(name: string): void;
    save(): void;
    render(): void;
    stop(): void;
    command(): void;
    export(language: string): void;
    expose(): void;
    /** Both eyes' pictures in a format, or that of one eye. */
    stereo(format: string | null): void;
    format(): void;
    theme(theme: Theme): void;
    /** Show or hide something. */
    overlay(name: OverlayName): void;
    space(): void;
    timeline(): void;
    handles(): void;
    keys(): void;
}

const fileName = (uri: string): string => decodeURIComponent(uri.slice(uri.lastIndexOf("/") + 1));
const valueOf = (event: Event): string => (event.target as HTMLSelectElement).value;

function cameraChoice({ cameras, chosen }: Session, actions: ToolbarActions) {
    const last = cameras.at(-1) ?? "";
    const names = chosen && !cameras.includes(chosen) ? [chosen, ...cameras] : cameras;
    return html`
        <label class="choice">
            <span>Camera</span>
            <select id="camera" .value=${live(chosen || last)} @change=${(event: Event) => actions.camera(valueOf(event))}>
                ${names.map((name) => html`<option value=${name} ?selected=${name === (chosen || last)}>${name}</option>`)}
            </select>
        </label>
    `;
}

function sizeChoice(size: SizeChoice, pixels: [number, number], actions: ToolbarActions) {
    const name = nameOf(size);
    const isListed = size.kind === "fit" || (size.kind === "wide" && widths.includes(size.width));
    const option = (value: string, words: string) =>
        html`<option value=${value} ?selected=${value === name}>${words}</option>`;
    return html`
        <label class="choice">
            <span>Size</span>
            <select
                id="size"
                title="${pixels[0]} × ${pixels[1]} pixels"
                .value=${live(name)}
                @change=${(event: Event) => actions.size(valueOf(event))}
            >
                ${option("fit", "Fit the window")}
                ${widths.map((width) => option(String(width), `${width} wide`))}
                ${isListed ? nothing : option(name, size.kind === "exact" ? size.size.join(" × ") : `${name} wide`)}
                ${option("other", "Other…")}
            </select>
        </label>
    `;
}

function renderButton(session: Session, actions: ToolbarActions) {
    const { render } = session;
    if (!session.can("render/start") || session.about?.readOnly) return nothing;
    if (!render) {
        return html`<button class="main" id="render" title="Render in full quality (Ctrl+Enter)" @click=${actions.render}>
            Render…
        </button>`;
    }
    const part = Math.round(100 * render.done);
    return html`
        <span class="progress">
            <progress max="100" value=${part} aria-label="Rendering"></progress>
            <span>${part} %</span>
            <button id="stop" @click=${actions.stop}>Stop</button>
        </span>
    `;
}

const overlayWords: Record<OverlayName, string> = {
    grid: "Lines of u and v",
    scale: "Scale",
    objects: "Objects",
    horizon: "Horizon",
    ellipses: "Circles",
    findings: "What check finds",
};

function overlayChoice({ overlays }: Inspection, actions: ToolbarActions) {
    return html`<div class="group" role="group" aria-label="Over the picture">
        <span class="heading">Over the picture</span>
        ${overlayNames.map(
            (name) =>
                html`<button
                    role="menuitemcheckbox"
                    aria-checked=${overlays.has(name)}
                    id="overlay-${name}"
                    @click=${() => actions.overlay(name)}
                >
                    ${overlayWords[name]}
                </button>`,
        )}
    </div>`;
}

function menu(session: Session, theme: Theme, inspection: Inspection, actions: ToolbarActions) {
    const item = (id: string, words: string, keys: string, act: () => void) =>
        html`<button id=${id} role="menuitem" @click=${act}><span>${words}</span><kbd>${keys}</kbd></button>`;
    return html`
        <details class="menu" @keydown=${closeOnEscape} @focusout=${closeOnLeave}>
            <summary aria-label="More" title="More" role="button">⋯</summary>
            <div class="items" role="menu" @click=${closeOnChoice}>
                ${item("format", "Format the text", "Shift+Alt+F", actions.format)}
                ${item("expose", "Expose for this picture", "", actions.expose)}
                ${session.can("command") ? item("command", "Copy the command line", "", actions.command) : nothing}
                ${session.can("view/grid") ? overlayChoice(inspection, actions) : nothing}
                ${stereoChoice(session, actions.stereo)}
                ${session.can("export") ? exportChoice(session, actions.export) : nothing}
                <div class="group themes" role="group" aria-label="Colours">
                    <span class="heading">Colours</span>
                    ${themes.map(
                        (name) =>
                            html`<button
                                role="menuitemradio"
                                aria-checked=${name === theme}
                                id="theme-${name}"
                                @click=${() => actions.theme(name)}
                            >
                                ${name}
                            </button>`,
                    )}
                </div>
                ${item("keys", "Keys", "F1", actions.keys)}
                <a role="menuitem" href="/licences.txt" target="_blank" rel="noopener">Licences</a>
            </div>
        </details>
    `;
}

const menuOf = (event: Event): HTMLDetailsElement => (event.currentTarget as HTMLElement).closest("details")!;

function closeOnEscape(event: KeyboardEvent): void {
    if (event.key !== "Escape") return;
    const details = menuOf(event);
    details.open = false;
    details.querySelector("summary")!.focus();
}

function closeOnLeave(event: FocusEvent): void {
    const details = menuOf(event);
    if (!details.contains(event.relatedTarget as Node | null)) details.open = false;
}

function closeOnChoice(event: Event): void {
    menuOf(event).open = false;
}

export interface Shown {
    session: Session;
    size: SizeChoice;
    pixels: [number, number];
    theme: Theme;
    hasHandles: boolean;
    hasTimeline: boolean;
    inspection: Inspection;
}

export function toolbar({ session, size, pixels, theme, hasHandles, hasTimeline, inspection }: Shown, actions: ToolbarActions) {
    const { about } = session;
    const unsaved = about !== null && !about.readOnly && !session.isSaved;
    return html`
        <header>
            <span class="file" title=${about ? decodeURIComponent(about.uri.replace("file://", "")) : ""}>
                <strong>${about ? fileName(about.uri) : "Balcony"}</strong>
                ${about?.readOnly
                    ? html`<span class="quiet">read-only</span>`
                    : html`<span class="unsaved" ?hidden=${!unsaved} title="Not saved" aria-label="not saved">●</span>`}
            </span>
            ${cameraChoice(session, actions)}
            ${session.can("cameras/text") && !about?.readOnly
                ? html`<button id="wall" title="Start with a built-in camera" @click=${actions.wall}>Cameras…</button>`
                : nothing}
            ${sizeChoice(size, pixels, actions)}
            <span class="space"></span>
            ${session.can("handles") && !about?.readOnly
                ? html`<button
                      id="handles"
                      aria-pressed=${hasHandles}
                      title="Show what a hand can move on the picture"
                      @click=${actions.handles}
                  >
                      Handles
                  </button>`
                : nothing}
            ${session.can("view/grid")
                ? html`<button
                      id="space"
                      aria-pressed=${inspection.hasSpace}
                      title="Show the camera in space"
                      @click=${actions.space}
                  >
                      3D
                  </button>`
                : nothing}
            <button
                id="timeline"
                aria-pressed=${hasTimeline}
                title="Show the time of the picture, and play it"
                @click=${actions.timeline}
            >
                Time
            </button>
            <button id="save" ?disabled=${!unsaved} title="Save the file (Ctrl+S)" @click=${actions.save}>Save</button>
            ${renderButton(session, actions)} ${menu(session, theme, inspection, actions)}
        </header>
    `;
}
