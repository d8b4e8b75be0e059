// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures and films in full quality, which the server writes beside the camera file.

import { askForFilm, askForRender, showText } from "./dialogs";
import type { RenderOrder } from "./protocol";
import type { Session } from "./session";

type Size = [number, number];

/** Asks how, and begins. */
async function start(session: Session, ask: () => Promise<RenderOrder | null>): Promise<void> {
    if (session.render || !session.can("render/start")) return;
    const order = await ask();
    if (!order) return;
    const { id } = await session.connection.request<{ id: number }>("render/start", order);
    session.render ??= { id, done: 0, seconds: 0 };
}

/** The shape of the picture that is shown, in another width. */
const withWidth = (wanted: number, [width, height]: Size): Size => [wanted, Math.max(1, Math.round((wanted * height) / width))];

/** A picture, as wide as a screen unless another width is given. */
export function startRender(session: Session, shown: Size): Promise<void> {
    return start(session, () => askForRender(withWidth(1920, shown)));
}

/** A film of as many frames. Its sides are even, as most films need. */
export function startFilm(session: Session, shown: Size, frames: number): Promise<void> {
    const [width, height] = withWidth(1280, shown);
    return start(session, () => askForFilm([width, height + (height % 2)], frames, session.film.formats));
}

/** What there is of the picture or the film is written. */
export async function stopRender({ render, connection }: Session): Promise<void> {
    if (render) await connection.request("render/stop", { id: render.id });
}

/** The words that say that the command line is in the clipboard; null if a dialog has shown it. */
export async function copyCommand({ connection }: Session): Promise<string | null> {
    const { line } = await connection.request<{ line: string }>("command", {});
    try {
        await navigator.clipboard.writeText(line);
    } catch {
        await showText("The command line", line);
        return null;
    }
    return `Copied:\n${line}`;
}
