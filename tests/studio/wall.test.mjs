// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The wall of built-in cameras: it is searched, its pictures come, and one is taken as a start.

import assert from "node:assert/strict";
import { test } from "node:test";
import { serverOf, text } from "./harness.mjs";

const studio = serverOf(text);

test("cameras are searched by what they are for, and one is taken as one step of undo", async () => {
    const page = await studio.open();
    const before = await page.pixels();
    await page.tab.locator("#wall").click();
    const wall = page.tab.getByRole("dialog", { name: "Cameras" });
    const cards = wall.locator(".card");
    await cards.first().waitFor();
    assert.ok((await cards.count()) > 150);
    await page.tab.keyboard.type("photosphere 360");
    await page.until((_) => document.querySelectorAll(".card").length < 10);
    const card = wall.locator('.card[data-name="panorama"]');
    await card.locator("canvas").waitFor();
    const drawn = await card.locator("canvas").evaluate((canvas) => {
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        return [canvas.width / canvas.height, new Set(data).size];
    });
    assert.ok(Math.abs(drawn[0] - 2) < 0.05, `${drawn}`);
    assert.ok(drawn[1] > 30, `${drawn}`);
    await card.click();
    await page.until((studio) => studio.session.chosen === "panorama" && studio.session.isSettled);
    const now = await page.text();
    assert.ok(now.startsWith(`${text}\n`));
    assert.match(now, /^camera panorama\(/m);
    await page.untilFollowed();
    await page.tab.locator("#parameter-yaw").waitFor();
    assert.notEqual(await page.pixels(), before);
    assert.equal(await page.tab.locator("#camera").inputValue(), "panorama");
    // Again under another name.
    await page.tab.locator("#wall").click();
    await page.tab.keyboard.press("Control+a");
    await page.tab.keyboard.type("photosphere");
    await wall.locator('.card[data-name="panorama"]').click();
    await page.until((studio) => studio.session.chosen === "panorama_2");
    await page.tab.locator("camera-editor").click();
    await page.tab.keyboard.press("Control+z");
    await page.untilText(now);
    await page.tab.keyboard.press("Control+z");
    await page.untilText(text);
});

test("what is typed at once is the search, and a word that no camera is for says so", async () => {
    const page = await studio.open();
    await page.tab.locator("camera-editor .cm-content").click();
    await page.tab.evaluate(() => document.querySelector("#wall").click());
    await page.tab.keyboard.type("xyzzy");
    await page.tab.getByText("No camera is for that").waitFor();
    assert.equal(await page.text(), text);
    await page.tab.keyboard.press("Escape");
    await page.until((_) => document.querySelector("dialog[open]") === null);
});

test("small families share a row, unless the window is narrow", async () => {
    const page = await studio.open();
    await page.tab.locator("#wall").click();
    await page.tab.locator(".card").first().waitFor();
    await page.tab.keyboard.type("360");
    await page.until((_) => document.querySelectorAll(".card").length < 30);
    const seen = () =>
        page.tab.locator(".wall .families").evaluate((families) => {
            const sections = [...families.querySelectorAll("section")];
            const rows = new Set(sections.map((one) => one.getBoundingClientRect().top));
            return [sections.length, rows.size, families.scrollWidth - families.clientWidth];
        });
    const [families, rows, hidden] = await seen();
    assert.ok(families > 2 && rows < families, `${families} families in ${rows} rows`);
    assert.equal(hidden, 0);
    await page.tab.setViewportSize({ width: 420, height: 700 });
    assert.deepEqual(await seen(), [families, families, 0]);
});
