// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures in full quality, which the server writes beside the camera file.

import { askForRender, showText } from "./dialogs";
import type { Session } from "./session";

/** Asks how, and begins. The width is that of a screen unless another one is given. */
export async function startRender(session: Session, [width, height]: [number, number]): Promise<void> {
    if (session.render || !session.can("render/start")) return;
    const usual = 1920;
    const order = await askForRender([usual, Math.max(1, Math.round((usual * height) / width))]);
    if (!order) return;
    const { id } = await session.connection.request<{ id: number }>("render/start", order);
    session.render ??= { id, done: 0, seconds: 0 };
}

/** What there is of the picture is written. */
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
