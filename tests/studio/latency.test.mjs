// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// How long the picture takes to follow a hand, in a browser and a server that do nothing else.

import assert from "node:assert/strict";
import { test } from "node:test";
import { plateCamera, serverOf, text } from "./harness.mjs";
import { othersShare, slowness } from "./processor.mjs";

const studio = serverOf(text);

// The goal is 50 ms with two cores of 2.5 GHz for the studio. On slower ones, times are as much longer. Of a core that
// other programs have a share s of, the studio gets 1 - s, so that its times are 1/(1 - s) as long. Nothing makes a run
// quicker than the studio is: the best of eight runs is its own time. Runs in which others have more than a quarter of
// the machine tell nothing, since the order in which programs have their turns then counts more than their shares.
test("the picture of plate 2's camera follows a hand within 50 ms", async (context) => {
    const page = await studio.open();
    await page.replace(plateCamera);
    await page.tab.evaluate(() => document.querySelector("balcony-studio").resize("960x540"));
    await page.until(({ session }) => session.shown.width === 960 && session.shown.height === 540);
    const medians = [];
    for (let run = 0; run < 12 && medians.length < 8 && !medians.some((median) => median <= 50); ++run) {
        await page.untilFollowed();
        await page.tab.evaluate(() => document.querySelector("balcony-studio").session.latency.measured.splice(0));
        const before = slowness();
        const shareOfOthers = othersShare();
        await page.drag("gamma", run % 2 === 0 ? 0.1 : 0.9, run % 2 === 0 ? 0.9 : 0.1, 60, 16);
        await page.until(({ session }) => session.latency.measured.length >= 30);
        const share = shareOfOthers();
        const measured = await page.tab.evaluate(
            () => document.querySelector("balcony-studio").session.latency.measured,
        );
        await page.tab.mouse.up();
        const slower = Math.max(before, slowness());
        const sorted = [...measured].sort((a, b) => a - b);
        const part = (p) => Math.round(sorted[Math.floor(p * (sorted.length - 1))]);
        console.log(
            `from the hand to the picture: median ${part(0.5)} ms, 90%: ${part(0.9)} ms, of ${sorted.length}; ` +
                `others have ${Math.round(100 * share)}% of the machine; it takes ${slower.toFixed(2)} times as long ` +
                "as one of 2.5 GHz",
        );
        if (share <= 0.25) medians.push((part(0.5) * (1 - share)) / slower);
    }
    if (medians.length === 0) context.skip("other programs have more than a quarter of the machine");
    else assert.ok(Math.min(...medians) <= 50, medians.join(", "));
});
