// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What is shown to understand a camera, and when what it is made of is asked for.

import type { Pair } from "./handle_marks";
import { type Lattice, latticeFrom, latticeOf } from "./lattice";
import type { OverlayName } from "./picture_overlays";
import type { Remark, Seen } from "./protocol";

/** How long the picture is the same before it is asked about. */
const pause = 250;

export interface InspectionServer {
    /** What stands in the cells of the picture; null if nobody knows. */
    grid(columns: number, rows: number): Promise<Seen[] | null>;
    check(): Promise<Remark[]>;
    changed(): void;
    /** Of a check that was not stopped by a newer picture. */
    failed(why: unknown): void;
}

export class Inspection {
    readonly overlays = new Set<OverlayName>();
    hasSpace = false;
    /** Of the picture that is shown, or of one before. */
    lattice: Lattice | null = null;
    /** Null while there are none. */
    remarks: Remark[] | null = null;
    /** That is pointed at, by its index. */
    chosen: number | null = null;
    private known = "";
    private timer = 0;

    constructor(private readonly server: InspectionServer) {}

    toggle(name: OverlayName): void {
        if (!this.overlays.delete(name)) this.overlays.add(name);
        // Both colour the whole picture.
        if (name === "scale") this.overlays.delete("objects");
        if (name === "objects") this.overlays.delete("scale");
        this.server.changed();
    }

    choose(index: number | null): void {
        this.chosen = index;
        this.server.changed();
    }

    private get needsCheck(): boolean {
        return this.overlays.has("findings");
    }

    private get needsLattice(): boolean {
        return this.hasSpace || this.overlays.size > (this.needsCheck ? 1 : 0);
    }

    /** The picture is that of a change, in so many pixels. */
    follow(change: number, size: Pair): void {
        const wanted = [change, ...size, this.needsLattice, this.needsCheck].join(" ");
        if (wanted === this.known) return;
        this.known = wanted;
        clearTimeout(this.timer);
        this.timer = window.setTimeout(() => this.ask(size), pause);
    }

    private ask(size: Pair): void {
        if (this.needsLattice) void this.askForLattice(size);
        if (this.needsCheck) void this.askForRemarks();
        else this.remarks = null;
    }

    private async askForLattice(size: Pair): Promise<void> {
        const { known } = this;
        const [columns, rows] = latticeOf(size);
        const seen = await this.server.grid(columns, rows);
        // Otherwise the picture is another one by now.
        if (!seen || known !== this.known) return;
        this.lattice = latticeFrom(seen, columns, rows, size);
        this.server.changed();
    }

    private async askForRemarks(): Promise<void> {
        const { known } = this;
        try {
            const remarks = await this.server.check();
            if (known !== this.known) return;
            this.remarks = remarks;
            this.chosen = null;
            this.server.changed();
        } catch (failure) {
            if (known === this.known) this.server.failed(failure);
        }
    }
}
