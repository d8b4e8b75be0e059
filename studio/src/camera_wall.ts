// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// All built-in cameras on this scene, as a wall of pictures that can be searched. Those in view are made
// first.

import { html, LitElement, nothing } from "lit";
import type { BuiltInCamera, FrameHead } from "./protocol";
import { bitmapOf } from "./picture_bytes";

/** How long the hand is still before the pictures in view are asked for. */
const pause = 120;
/** How long it waits before it asks again. */
const patience = 500;
const size = { width: 240, height: 135 };

export interface WallServer {
    list(): Promise<BuiltInCamera[]>;
    /** An empty list ends it. Rejects while there is no scene. */
    show(names: string[], size: { width: number; height: number }): Promise<unknown>;
    take(name: string): void;
}

/** Whether all words of a search are in what is said of a camera. */
export function isFound({ name, family, about, keywords }: BuiltInCamera, search: string): boolean {
    const said = [name, family, about, ...[keywords].flat()].join(" ").toLowerCase();
    return search
        .toLowerCase()
        .split(/\s+/)
        .every((word) => said.includes(word));
}

export class CameraWall extends LitElement {
    static override properties = { server: { attribute: false } };
    declare server: WallServer | null;
    private cameras: BuiltInCamera[] = [];
    private search = "";
    private readonly pictures = new Map<string, ImageBitmap>();
    private readonly failed = new Map<string, string>();
    private readonly inView = new Set<string>();
    private observer: IntersectionObserver | null = null;
    private timer = 0;

    constructor() {
        super();
        this.server = null;
    }

    override createRenderRoot() {
        return this;
    }

    private get dialog(): HTMLDialogElement {
        return this.querySelector("dialog")!;
    }

    /** Opens at once, so that the keys that follow are those of the search. */
    async open(): Promise<void> {
        if (!this.server) return;
        this.dialog.showModal();
        const search = this.querySelector("input")!;
        search.focus();
        search.select();
        if (this.cameras.length === 0) {
            try {
                this.cameras = await this.server.list();
            } catch (error) {
                this.dialog.close();
                throw error;
            }
            this.requestUpdate();
            await this.updateComplete;
        }
        this.watch();
    }

    async picture(head: FrameHead, bytes: Uint8Array): Promise<void> {
        this.pictures.set(head.name!, await bitmapOf(head, bytes));
        this.requestUpdate();
    }

    fail(name: string, message: string): void {
        this.failed.set(name, message);
        this.requestUpdate();
    }

    private watch(): void {
        this.observer?.disconnect();
        this.inView.clear();
        this.observer = new IntersectionObserver((entries) => {
            for (const { target, isIntersecting } of entries) {
                const { name } = (target as HTMLElement).dataset;
                if (isIntersecting) this.inView.add(name!);
                else this.inView.delete(name!);
            }
            clearTimeout(this.timer);
            this.timer = window.setTimeout(() => this.ask(), pause);
        });
        for (const one of this.querySelectorAll("[data-name]")) this.observer.observe(one);
    }

    private ask(): void {
        const isMissing = (name: string): boolean => !this.pictures.has(name) && !this.failed.has(name);
        const names = this.found.map(({ name }) => name).filter(isMissing);
        const isFar = (name: string): number => (this.inView.has(name) ? 0 : 1);
        if (!this.dialog.open) return;
        this.server!.show(names.sort((a, b) => isFar(a) - isFar(b)), size).catch(() => {
            clearTimeout(this.timer);
            this.timer = window.setTimeout(() => this.ask(), patience);
        });
    }

    private get found(): BuiltInCamera[] {
        return this.cameras.filter((one) => isFound(one, this.search));
    }

    private async searched(event: Event): Promise<void> {
        this.search = (event.target as HTMLInputElement).value.trim();
        this.requestUpdate();
        await this.updateComplete;
        this.watch();
    }

    private closed(): void {
        this.observer?.disconnect();
        clearTimeout(this.timer);
        this.server?.show([], size).catch(() => {}); // Nothing was on its way.
    }

    private take(name: string): void {
        this.dialog.close();
        this.server?.take(name);
    }

    override updated(): void {
        for (const canvas of this.querySelectorAll<HTMLCanvasElement>("canvas[data-of]")) {
            const picture = this.pictures.get(canvas.dataset.of!);
            if (!picture || canvas.dataset.drawn === canvas.dataset.of) continue;
            [canvas.width, canvas.height] = [picture.width, picture.height];
            canvas.getContext("2d", { alpha: false })!.drawImage(picture, 0, 0);
            canvas.dataset.drawn = canvas.dataset.of!;
        }
    }

    private card({ name, about }: BuiltInCamera) {
        const failure = this.failed.get(name);
        return html`<button class="card" data-name=${name} title=${about} @click=${() => this.take(name)}>
            <span class="thumbnail">
                ${this.pictures.has(name)
                    ? html`<canvas data-of=${name} role="img" aria-label="The scene through ${name}"></canvas>`
                    : failure
                      ? html`<span class="quiet">${failure.split("\n")[0]}</span>`
                      : html`<span class="spinner"></span>`}
            </span>
            <span class="name">${name}</span>
            <span class="about quiet">${about.split(/(?<=\.)\s/, 1)[0]}</span>
        </button>`;
    }

    override render() {
        const { found } = this;
        const isListed = this.cameras.length > 0;
        const families = new Map<string, BuiltInCamera[]>();
        for (const one of found) families.set(one.family, [...(families.get(one.family) ?? []), one]);
        return html`<dialog class="wall" aria-label="Cameras" @close=${() => this.closed()}>
            <div class="top">
                <h2>Start with a camera</h2>
                <input
                    role="searchbox"
                    placeholder="panorama, stereo, map, fisheye…"
                    aria-label="Search by what cameras are for"
                    @input=${(event: Event) => void this.searched(event)}
                />
                <span class="quiet" role="status">${isListed ? `${found.length} of ${this.cameras.length}` : nothing}</span>
                <span class="space"></span>
                <button @click=${() => this.dialog.close()}>Close</button>
            </div>
            <div class="families">
                ${[...families].map(
                    ([family, cameras]) => html`<section aria-label=${family} data-cards=${cameras.length}>
                        <h3>${family}</h3>
                        <div class="cards">${cameras.map((one) => this.card(one))}</div>
                    </section>`,
                )}
                ${isListed && found.length === 0 ? html`<p class="quiet">No camera is for that. Try another word.</p>` : nothing}
            </div>
        </dialog>`;
    }
}

customElements.define("camera-wall", CameraWall);
