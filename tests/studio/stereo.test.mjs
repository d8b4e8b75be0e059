// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What two eyes see is chosen in the menu.

import assert from "node:assert/strict";
import { test } from "node:test";
import { serverOf, text } from "./harness.mjs";

const studio = serverOf(text);

/** The layers that stand left and right in the picture. */
const layers = (page) =>
    page.tab.evaluate(async () => {
        const { session, pixels } = document.querySelector("balcony-studio");
        const seen = await Promise.all([0.25, 0.75].map((x) => session.at([x * pixels[0], 0.5 * pixels[1]])));
        return [...new Set(seen.map((place) => place.ray?.layer ?? null))];
    });

test("both eyes are seen side by side, and one again", async () => {
    const page = await studio.open();
    await page.untilFollowed();
    const choose = async (name) => {
        await page.tab.locator("summary").click();
        const item = page.tab.locator("#stereo").getByRole("menuitemradio", { name, exact: true });
        await item.click();
        await page.untilFollowed();
        await page.tab.locator("summary").click();
        assert.equal(await item.getAttribute("aria-checked"), "true");
        await page.tab.keyboard.press("Escape");
    };
    const aspect = () => page.tab.evaluate(() => {
        const { pixels } = document.querySelector("balcony-studio");
        return pixels[0] / pixels[1];
    });
    const before = await aspect();
    await choose("side by side");
    assert.ok(Math.abs((await aspect()) - 2 * before) < 0.03 * before);
    assert.deepEqual(await layers(page), ["left", "right"]);
    // What a hand moves is that of one eye.
    assert.equal(await page.tab.locator("picture-handles").count(), 0);
    await choose("anaglyph");
    assert.ok(Math.abs((await aspect()) - before) < 0.03 * before);
    assert.deepEqual(await layers(page), ["right"]);
    await choose("One eye");
    assert.ok(Math.abs((await aspect()) - before) < 0.01 * before);
    assert.deepEqual(await layers(page), [""]);
});
