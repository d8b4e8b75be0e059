// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// How much of the machine other programs take: by Linux's counters of the processors' time.

import { readdirSync, readFileSync } from "node:fs";
import { availableParallelism } from "node:os";

/** Ticks of all programs, and those of this process and all that it has started. */
function ticks() {
    const [user, nice, system, , , interrupt, soft] = readFileSync("/proc/stat", "utf8")
        .split("\n", 1)[0]
        .split(/\s+/)
        .slice(1)
        .map(Number);
    const processes = new Map();
    for (const id of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
        try {
            const fields = readFileSync(`/proc/${id}/stat`, "utf8").split(") ").at(-1).split(" ");
            processes.set(Number(id), { parent: Number(fields[1]), time: Number(fields[11]) + Number(fields[12]) });
        } catch {
            // It has ended.
        }
    }
    const isOwn = (id) => id === process.pid || (processes.has(id) && isOwn(processes.get(id).parent));
    let own = 0;
    for (const [id, { time }] of processes) own += isOwn(id) ? time : 0;
    return { at: performance.now(), all: user + nice + system + interrupt + soft, own };
}

/** Begins a measurement. Its end tells the share of all processors that other programs had, from 0 to 1. */
export function othersShare() {
    const begin = ticks();
    return () => {
        const end = ticks();
        const others = end.all - begin.all - (end.own - begin.own);
        // A tick is a hundredth of a second.
        return Math.max(0, (others * 10) / ((end.at - begin.at) * availableParallelism()));
    };
}
