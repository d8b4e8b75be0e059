// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The hand on the picture itself: what stands at a pixel, points that are held, and a point that is pulled.

import type { Pair } from "./handle_marks";
import type { Dragged, DragPoint, PicturePlace, Pull } from "./protocol";

export interface PictureServer {
    /** What stands at a pixel of the full size; null without a connection. */
    at(place: Pair): Promise<PicturePlace | null>;
    /** Pulls; an empty list ends it. The number of the change; null without a connection. */
    drag(pulls: Pull[]): Promise<number | null>;
    /** Writes the values of the last answer into the text. */
    keep(): Promise<void>;
    /** A drag has ended without being kept. */
    cancelled(): void;
    changed(): void;
}

/** A point of the scene that a hand holds or pulls. */
export interface Grip {
    pull: Pull;
    /** What became of it, as far as that is known. */
    told: DragPoint | null;
}

function pullOf(place: PicturePlace): Pull | null {
    const at: Pair = [place.x, place.y];
    if (place.hit) return { point: place.hit.point, from: at, to: at };
    return place.ray ? { point: place.ray.direction, infinite: true, from: at, to: at } : null;
}

/** How long a hand that lets go waits for the answer to its last pull, in milliseconds. */
const patience = 2000;

export class PictureHand {
    /** Under the hand, or kept by a click. */
    seen: PicturePlace | null = null;
    isKept = false;
    readonly pins: Grip[] = [];
    pulled: Grip | null = null;
    private wanted: Pair | null = null;
    private isAsking = false;
    private to: Pair | null = null;
    /** The number of the last pull, and of the last one that was answered. */
    private last: Promise<number | null> = Promise.resolve(null);
    private answered = 0;

    constructor(private readonly server: PictureServer) {}

    /** All that is pulled, in the order of the answers. */
    get grips(): Grip[] {
        return this.pulled ? [...this.pins, this.pulled] : this.pins;
    }

    hover(place: Pair): void {
        if (this.isKept || this.pulled) return;
        this.wanted = place;
        void this.ask();
    }

    leave(): void {
        this.wanted = null;
        if (!this.isKept) this.seen = null;
        this.server.changed();
    }

    private async ask(): Promise<void> {
        if (this.isAsking) return;
        this.isAsking = true;
        while (this.wanted) {
            const place = this.wanted;
            this.wanted = null;
            const seen = await this.server.at(place);
            if (!this.isKept && seen) this.seen = seen;
            this.server.changed();
        }
        this.isAsking = false;
    }

    /** Keeps what stands at a place, or lets it go. */
    async keep(place: Pair | null): Promise<void> {
        this.isKept = place !== null;
        this.seen = place ? await this.server.at(place) : null;
        this.isKept = this.seen !== null;
        this.server.changed();
    }

    /** The picture is another one now. */
    async refresh(): Promise<void> {
        if (this.isKept && this.seen) await this.keep([this.seen.x, this.seen.y]);
    }

    async pin(place: Pair): Promise<void> {
        const seen = await this.server.at(place);
        const pull = seen && pullOf(seen);
        if (pull) this.pins.push({ pull, told: null });
        this.server.changed();
    }

    unpin(index: number): void {
        this.pins.splice(index, 1);
        this.server.changed();
    }

    unpinAll(): void {
        this.pins.length = 0;
        this.server.changed();
    }

    /** Takes what stands at a place. */
    async take(place: Pair): Promise<void> {
        this.to = place;
        const seen = await this.server.at(place);
        const pull = seen && pullOf(seen);
        if (!pull || !this.to) return;
        [this.seen, this.isKept] = [null, false];
        this.pulled = { pull, told: null };
        this.pull(this.to);
    }

    pull(to: Pair): void {
        this.to = to;
        if (!this.pulled) return;
        this.pulled.pull = { ...this.pulled.pull, to };
        this.last = this.server.drag(this.grips.map(({ pull }) => pull));
        this.server.changed();
    }

    told({ points, change }: Dragged): void {
        this.answered = change;
        for (const [index, grip] of this.grips.entries()) grip.told = points[index] ?? null;
    }

    /** Lets go: the text gets the values that were found. */
    async release(): Promise<void> {
        this.to = null;
        await this.untilAnswered();
        if (!this.pulled) return;
        await this.server.keep();
        this.ended();
    }

    private async untilAnswered(): Promise<void> {
        const change = await this.last;
        const end = Date.now() + patience;
        while (change !== null && this.pulled && this.answered < change && Date.now() < end) {
            await new Promise((goOn) => setTimeout(goOn, 5));
        }
    }

    /** Lets go, and all is as it was. */
    cancel(): void {
        this.to = null;
        if (!this.pulled) return;
        void this.server.drag([]);
        this.server.cancelled();
        this.ended();
    }

    private ended(): void {
        this.pulled = null;
        // Pins stay on their points of the scene, where the new picture shows them.
        for (const grip of this.pins) {
            const { told, pull } = grip;
            const at = told?.at ?? pull.from;
            grip.pull = { ...pull, from: at, to: at };
            grip.told = null;
        }
        this.server.changed();
    }
}
