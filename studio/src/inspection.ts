// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What is shown to understand a camera, and when what it is made of is asked for.

import type { Pair } from "./handle_marks";
import { type Lattice, latticeFrom, latticeOf } from "./lattice";
import type { OverlayName } from "./picture_overlays";
import type { Seen } from "./protocol";

/** How long the picture is the same before its lattice is asked for. */
const pause = 250;

export class Inspection {
    readonly overlays = new Set<OverlayName>();
    hasSpace = false;
    /** Of the picture that is shown, or of one before. */
    lattice: Lattice | null = null;
    private known = "";
    private timer = 0;

    constructor(
        /** What stands in the cells of the picture; null if nobody knows. */
        private readonly grid: (columns: number, rows: number) => Promise<Seen[] | null>,
        private readonly changed: () => void,
    ) {}

    toggle(name: OverlayName): void {
        if (!this.overlays.delete(name)) this.overlays.add(name);
        // Both colour the whole picture.
        if (name === "scale") this.overlays.delete("objects");
        if (name === "objects") this.overlays.delete("scale");
        this.changed();
    }

    /** The picture is that of a change, in so many pixels. */
    follow(change: number, size: Pair): void {
        const wanted = this.overlays.size > 0 || this.hasSpace ? `${change} ${size.join("x")}` : "";
        if (wanted === this.known) return;
        this.known = wanted;
        clearTimeout(this.timer);
        if (wanted !== "") this.timer = window.setTimeout(() => void this.ask(size), pause);
    }

    private async ask(size: Pair): Promise<void> {
        const { known } = this;
        const [columns, rows] = latticeOf(size);
        const seen = await this.grid(columns, rows);
        // Otherwise the picture is another one by now.
        if (!seen || known !== this.known) return;
        this.lattice = latticeFrom(seen, columns, rows, size);
        this.changed();
    }
}
