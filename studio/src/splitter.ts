// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The edge between the picture and the text, which is dragged or moved by arrow keys.

import { html } from "lit";
import { followPointer } from "./follow_pointer";

const least = 280;
const step = 24;

const widthNow = (edge: HTMLElement): number => (edge.nextElementSibling as HTMLElement).offsetWidth;

function setWidth(edge: HTMLElement, width: number): void {
    const most = edge.parentElement!.offsetWidth - least;
    const whole = Math.round(Math.max(least, Math.min(most, width)));
    edge.parentElement!.style.setProperty("--text-width", `${whole}px`);
    edge.setAttribute("aria-valuenow", String(whole));
}

function pressed(event: KeyboardEvent): void {
    const edge = event.currentTarget as HTMLElement;
    const by = event.key === "ArrowLeft" ? step : event.key === "ArrowRight" ? -step : 0;
    if (by === 0) return;
    event.preventDefault();
    setWidth(edge, widthNow(edge) + by);
}

function held(event: PointerEvent): void {
    const edge = event.currentTarget as HTMLElement;
    const [begin, width] = [event.clientX, widthNow(edge)];
    followPointer(event, (moved) => setWidth(edge, width + begin - moved.clientX));
}

export const splitter = () => html`
    <div
        class="splitter"
        role="separator"
        tabindex="0"
        aria-orientation="vertical"
        aria-label="Width of the text"
        @pointerdown=${held}
        @keydown=${pressed}
    ></div>
`;
