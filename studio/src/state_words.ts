// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What the studio is doing, in words.

import type { FrameHead, SceneState } from "./protocol";

export type Link = "connecting" | "open" | "lost" | "refused" | "foreign";

export interface Doing {
    link: Link;
    scene: SceneState;
    hasError: boolean;
    isAtRest: boolean;
    frame: FrameHead | null;
}

export interface Words {
    kind: "busy" | "rest" | "error" | "lost";
    text: string;
    /** What can be done about it. */
    advice?: string;
}

const links: Record<Exclude<Link, "open">, Words> = {
    connecting: { kind: "busy", text: "Connecting" },
    lost: {
        kind: "lost",
        text: "Connection lost, trying again",
        advice: "Your text is safe here. It goes to the server as soon as it is back.",
    },
    refused: {
        kind: "lost",
        text: "The server does not know this page",
        advice: "It was started with another token. Copy your text, and open the address that balcony studio prints.",
    },
    foreign: {
        kind: "lost",
        text: "The server is of another version",
        advice: "Copy your text, then load this page again.",
    },
};

const samples = (count: number): string => (count === 1 ? "1 sample" : `${count} samples`);

export function wordsOf({ link, scene, hasError, isAtRest, frame }: Doing): Words {
    if (link !== "open") return links[link];
    if (scene.state === "failed") {
        return { kind: "error", text: "No scene", advice: scene.message ?? "The scene cannot be loaded." };
    }
    if (scene.state === "loading") {
        return { kind: "busy", text: "Loading the scene", ...(scene.message ? { advice: scene.message } : {}) };
    }
    if (hasError) return { kind: "error", text: "The text has an error" };
    if (!frame) return { kind: "busy", text: "Making the first picture" };
    if (isAtRest) {
        const denoised = frame.quality === "denoised" ? ", denoised" : "";
        return { kind: "rest", text: `At rest, ${samples(frame.samples)}${denoised}` };
    }
    if (frame.quality === "coarse") return { kind: "busy", text: "Coarse picture" };
    if (frame.quality === "preview") return { kind: "busy", text: "Preview" };
    return { kind: "busy", text: `Rendering, ${samples(frame.samples)}` };
}
