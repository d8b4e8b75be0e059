// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The time of the picture: it is scrubbed, played, and left.

import assert from "node:assert/strict";
import { test } from "node:test";
import { serverOf } from "./harness.mjs";

const studio = serverOf(`camera gliding(from = -2) {
    aspect 2
    map    u = 1 .. -1, v = square
    eye    point(from + t, 0, 1.5)
    toward plane((1, 0, 0))
    look   absolute
}
`);

/** Where the rays of the picture begin, along x. */
const place = (page) =>
    page.tab.evaluate(async () => (await document.querySelector("balcony-studio").session.at([5, 5])).ray.origin[0]);

test("a frame is chosen, and shows its time", async () => {
    const page = await studio.open();
    assert.equal(await page.tab.locator("time-line").count(), 0);
    await page.tab.locator("#timeline").click();
    const frame = page.tab.getByRole("slider", { name: "Frame" });
    assert.equal(await frame.getAttribute("max"), "120");
    await frame.fill("49");
    await page.untilFollowed();
    assert.ok(Math.abs((await place(page)) - 0) < 1e-6);
    await page.tab.getByText("frame 49 of 120").waitFor();
    // A shorter film ends at its last frame.
    await page.tab.getByLabel("Length in seconds").fill("1");
    await page.tab.getByLabel("Length in seconds").blur();
    await page.tab.getByText("frame 24 of 24").waitFor();
    await page.untilFollowed();
    assert.ok(Math.abs((await place(page)) - (-2 + 23 / 24)) < 1e-6);
    // Without the line, the picture is that of the first time.
    await page.tab.locator("#timeline").click();
    await page.untilFollowed();
    assert.equal(await place(page), -2);
});

test("playing goes on at the speed of a film, and pauses", async () => {
    const page = await studio.open();
    await page.tab.locator("#timeline").click();
    await page.tab.locator("#play").click();
    const played = await page.tab.evaluate(async () => {
        const line = document.querySelector("time-line");
        const seen = [];
        const begin = performance.now();
        while (performance.now() - begin < 2000) {
            await new Promise((goOn) => setTimeout(goOn, 50));
            seen.push([(performance.now() - line.began) / 1000, line.time]);
        }
        return seen;
    });
    // Never ahead of the clock, and it moves; how far behind depends on the machine.
    for (const [clock, time] of played) assert.ok(time <= clock + 0.01, `${clock} ${time}`);
    assert.ok(new Set(played.map(([, time]) => time)).size > 2);
    await page.tab.locator("#play").click();
    await page.untilFollowed();
    const time = await page.tab.evaluate(() => document.querySelector("time-line").time);
    assert.ok(time > 0);
    assert.ok(Math.abs((await place(page)) - (-2 + time)) < 1e-6);
    await page.tab.waitForTimeout(200);
    assert.equal(await page.tab.evaluate(() => document.querySelector("time-line").time), time);
});
