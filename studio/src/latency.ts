// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// How long the picture takes to follow: from a change until it, or a newer one, is on the screen.

export class Latency {
    private readonly open: { begin: number; change: number | null }[] = [];
    /** In milliseconds, the newest last. */
    readonly measured: number[] = [];

    /** Begins a measurement; `change` is its number, as soon as that is known. */
    begin(change: Promise<number | null>): void {
        const one: { begin: number; change: number | null } = { begin: performance.now(), change: null };
        this.open.push(one);
        const end = (): void => void this.open.splice(this.open.indexOf(one), 1);
        change.then((number) => (number === null ? end() : (one.change = number)), end);
    }

    drawn(change: number): void {
        const now = performance.now();
        for (let i = this.open.length - 1; i >= 0; --i) {
            const one = this.open[i]!;
            if (one.change === null || one.change > change) continue;
            this.open.splice(i, 1);
            this.measured.push(now - one.begin);
        }
        this.measured.splice(0, this.measured.length - 500);
    }

    /** The median of the last ones, or null before there are any. */
    get typical(): number | null {
        const last = this.measured.slice(-15).sort((a, b) => a - b);
        return last[last.length >> 1] ?? null;
    }
}
