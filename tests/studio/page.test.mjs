// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The studio in a browser: what a hand does, and what is then seen.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { cameraFile, Page, plateCamera, Server, serverOf, text } from "./harness.mjs";
import { othersShare } from "./processor.mjs";

const studio = serverOf(text);
const open = (options) => studio.open(options);

test("the picture follows the text", async () => {
    const page = await open();
    const before = await page.pixels();
    await page.type("gamma = 0.25", "gamma = 1");
    await page.untilFollowed();
    assert.notEqual(await page.pixels(), before);
    assert.equal(await page.tab.locator("#parameter-gamma").inputValue(), "1");
});

test("a slider moves the picture, and the text when it rests, as one step of undo", async () => {
    const page = await open();
    const before = await page.pixels();
    await page.drag("seam", 0.58, 0.8, 20, 10);
    await page.until(({ session }) => session.latency.measured.length >= 5);
    assert.notEqual(await page.pixels(), before);
    assert.equal(await page.text(), text);
    await page.tab.mouse.up();
    await page.until((studio, text) => studio.text().toString() !== text, text);
    const written = await page.text();
    const value = /seam = ([\d.]+)deg/.exec(written)[1];
    // The middle of the thumb, which is 14 pixels wide, goes with the hand, within a pixel.
    const { width } = await page.tab.locator("#parameter-seam").boundingBox();
    const wanted = (360 * (0.8 * width - 7)) / (width - 14) - 180;
    assert.ok(Math.abs(value - wanted) < 360 / (width - 14), `${value} is not ${wanted}`);
    assert.equal(written, text.replace("30.85", value));
    await page.untilFollowed();
    const moved = await page.pixels();
    assert.notEqual(moved, before);
    // The slider has the keyboard, and undo is that of the text.
    await page.tab.keyboard.press("Control+z");
    await page.untilText(text);
    await page.untilFollowed();
    assert.notEqual(await page.pixels(), moved);
    await page.tab.keyboard.press("Control+y");
    await page.untilText(written);
});

test("keys move a slider, and what they do in a row is one step of undo", async () => {
    const page = await open();
    await page.tab.keyboard.press("Alt+2");
    // At once: keys that wait for each other rest between, on a busy machine.
    await Promise.all(Array.from({ length: 5 }, () => page.tab.keyboard.press("ArrowRight")));
    await page.until((studio, text) => studio.text().toString() !== text, text);
    const written = await page.text();
    assert.match(written, /a = 4\.\d+ above 0, \/\* half its length \*\/ b/);
    assert.notEqual(written, text);
    await page.tab.keyboard.press("Control+z");
    await page.untilText(text);
    // A number that is typed.
    const field = page.tab.getByLabel("gamma", { exact: true }).last();
    await field.fill("0.7");
    await field.press("Enter");
    await page.untilText(text.replace("gamma = 0.25", "gamma = 0.7"));
});

test("a number is dragged in the text, as one step of undo", async () => {
    const page = await open();
    const before = await page.pixels();
    const number = page.tab.locator(".cm-line", { hasText: "gamma = 0.25" }).locator("span", { hasText: /^0.25$/ });
    const { x, y } = await number.boundingBox();
    await page.tab.keyboard.down("Control");
    await page.tab.mouse.move(x + 8, y + 8);
    await page.tab.mouse.down();
    for (const way of [100, 300, 500]) await page.tab.mouse.move(x + 8 + way, y + 8);
    await page.tab.mouse.up();
    await page.tab.keyboard.up("Control");
    await page.untilText(text.replace("gamma = 0.25", "gamma = 0.75"));
    await page.untilFollowed();
    assert.notEqual(await page.pixels(), before);
    await page.tab.keyboard.press("Control+z");
    await page.untilText(text);
});

test("an error greys the last good picture, names its place, and is mended by a click", async () => {
    const page = await open();
    await page.until(({ session }) => session.shown?.quality === "denoised");
    const before = await page.pixels();
    await page.type("superellipse(1", "superelipse(1");
    const message = page.tab.locator("live-picture .message");
    await message.waitFor();
    const broken = await page.text();
    assert.match(await message.innerText(), /superelipse/);
    assert.match(await message.innerText(), /Go to line 14/);
    assert.equal(await page.tab.locator("live-picture .stale").count(), 1);
    assert.equal(await page.pixels(), before);
    assert.equal(await page.state(), "The text has an error");
    assert.equal(await page.tab.locator(".problems .line").first().innerText(), "14");
    await message.getByRole("button", { name: "superellipse" }).click();
    await page.untilText(text);
    await message.waitFor({ state: "detached" });
    await page.untilFollowed();
    assert.equal(await page.tab.locator("live-picture .stale").count(), 0);
    await page.tab.keyboard.press("Control+z");
    await page.untilText(broken);
});

test("of a text that has had an error from the start, nothing is said but the error", async () => {
    await studio.server.stop();
    writeFileSync(cameraFile, text.replace("superellipse(1", "superelipse(1"));
    studio.server = await Server.start();
    const page = await Page.open(studio.server.address);
    studio.pages.push(page);
    await page.tab.locator("live-picture .message").waitFor();
    await page.tab.locator("summary").first().click();
    await page.tab.locator("#overlay-findings").click();
    assert.equal(await page.tab.locator("parameter-sliders").isVisible(), false);
    assert.equal(await page.tab.locator(".remarks").count(), 0);
});

test("completion has whole calls with blanks, and help", async () => {
    const page = await open();
    await page.select("    move   translate", 0);
    await page.tab.keyboard.type("    warp   zo");
    await page.tab.locator(".cm-tooltip-autocomplete li", { hasText: "zoom" }).first().waitFor();
    await page.tab.waitForTimeout(150); // The editor lets nobody accept what has just appeared.
    await page.tab.keyboard.press("Enter");
    await page.until((studio) => /warp   zoom\(at = /.test(studio.text().toString()));
    await page.tab.keyboard.press("Escape");
    await page.tab.locator(".cm-line span", { hasText: /^translate$/ }).hover();
    const help = page.tab.locator(".cm-tooltip .cam-help");
    await help.waitFor();
    assert.match(await help.innerText(), /translate\(/);
});

test("a name is another one everywhere, and all its places are selected", async () => {
    const page = await open();
    await page.select("gamma, by", 0);
    await page.tab.keyboard.press("Shift+F12");
    await page.until((_) => document.querySelector("camera-editor").view.state.selection.ranges.length === 3);
    await page.select("gamma, by", 0);
    await page.tab.keyboard.press("F2");
    const dialog = page.tab.getByRole("dialog");
    await dialog.getByLabel("Name").fill("roundness");
    await page.tab.keyboard.press("Enter");
    await page.untilText(text.replaceAll("gamma", "roundness"));
    await page.tab.keyboard.press("Control+z");
    await page.untilText(text);
});

test("saving writes the file, and asks before it replaces what others wrote", async () => {
    const page = await open();
    const save = page.tab.locator("#save");
    assert.ok(await save.isDisabled());
    await page.type("gamma = 0.25", "gamma = 0.5");
    const written = text.replace("gamma = 0.25", "gamma = 0.5");
    await page.until((_) => !document.querySelector("#save").disabled);
    await page.tab.keyboard.press("Control+s");
    await page.until((_) => document.querySelector("#save").disabled);
    assert.equal(readFileSync(cameraFile, "utf8"), written);

    writeFileSync(cameraFile, "// Of another editor.\n");
    await page.type("gamma = 0.5", "gamma = 0.6");
    await page.tab.keyboard.press("Control+s");
    const dialog = page.tab.getByRole("dialog");
    await dialog.getByRole("button", { name: "Cancel" }).click();
    assert.equal(readFileSync(cameraFile, "utf8"), "// Of another editor.\n");
    await page.tab.keyboard.press("Control+s");
    await dialog.getByRole("button", { name: "Replace it" }).click();
    await page.until((_) => document.querySelector("#save").disabled);
    assert.equal(readFileSync(cameraFile, "utf8"), text.replace("gamma = 0.25", "gamma = 0.6"));
});

test("a restarted server gets the text, and nothing that was typed is lost", async () => {
    const page = await open();
    await page.type("gamma = 0.25", "gamma = 0.5");
    await page.untilFollowed();
    await studio.server.stop();
    await page.until(({ session }) => session.link === "lost");
    assert.match(await page.state(), /Connection lost/);
    await page.type("gamma = 0.5", "gamma = 0.75");
    const typed = text.replace("gamma = 0.25", "gamma = 0.75");
    studio.server = await Server.start();
    await page.until(({ session }) => session.link === "open");
    await page.untilFollowed();
    assert.equal(await page.text(), typed);
    const other = await open();
    assert.equal(await other.text(), typed);
    assert.equal(readFileSync(cameraFile, "utf8"), text);
});

test("two pages show one text and one picture", async () => {
    const [one, two] = [await open(), await open()];
    await one.type("gamma = 0.25", "gamma = 0.5");
    const changed = text.replace("gamma = 0.25", "gamma = 0.5");
    await two.untilText(changed);
    await two.untilFollowed();
    assert.equal(await two.tab.locator("#parameter-gamma").inputValue(), "0.5");
    // Both at once.
    await Promise.all([one.type("// A second", "// The second"), two.type("30.85deg", "12deg")]);
    const both = changed.replace("A second", "The second").replace("30.85", "12");
    await one.untilText(both);
    await two.untilText(both);
    // Undo is of what was done here.
    await two.tab.keyboard.press("Control+z");
    await one.untilText(changed.replace("A second", "The second"));
});

test("another camera of the file", async () => {
    const page = await open();
    const before = await page.pixels();
    const names = await page.tab.locator("#camera option").allInnerTexts();
    assert.deepEqual(names, ["straight", "walls"]);
    await page.tab.locator("#camera").selectOption("straight");
    await page.tab.locator("#parameter-fov").waitFor();
    await page.untilFollowed();
    assert.notEqual(await page.pixels(), before);
    assert.equal(await page.tab.locator("#parameter-fov").inputValue(), "80");
});

test("with a wrong token the page says what to do", async () => {
    const page = await Page.open(studio.server.address.replace(/token=..../, "token=0000"));
    studio.pages.push(page);
    await page.tab.getByText("The server does not know this page").first().waitFor();
});

test("everything has a name, and fits desks and tablets in both colours", async () => {
    for (const [width, height] of [
        [1280, 720],
        [1180, 820],
        [820, 1180],
    ]) {
        for (const colorScheme of ["dark", "light"]) {
            const page = await open({ viewport: { width, height }, colorScheme });
            const seen = await page.tab.evaluate(() => {
                const nameless = [...document.querySelectorAll("button, input, select, summary, a")].filter(
                    (one) => !(one.textContent.trim() || one.ariaLabel || one.labels?.[0]?.textContent),
                );
                return {
                    nameless: nameless.map((one) => one.outerHTML),
                    over: document.scrollingElement.scrollWidth - innerWidth,
                    picture: document.querySelector("canvas").getBoundingClientRect().width / innerWidth,
                    theme: document.documentElement.dataset.theme,
                };
            });
            assert.deepEqual(seen.nameless, []);
            assert.ok(seen.over <= 0);
            assert.ok(seen.picture > 0.6, `${width} x ${height}: ${seen.picture}`);
            assert.equal(seen.theme, colorScheme);
            await page.close();
        }
    }
});

// The goal is 50 ms with two cores for the studio. Of a core that other programs have a share s of, the studio gets
// 1 - s, so that its times are 1/(1 - s) as long. Nothing makes a run quicker than the studio is: the best of three
// runs is its own time. Runs in which others have more than a quarter of the machine tell nothing, since the order in
// which programs have their turns then counts more than their shares.
test("the picture of plate 2's camera follows a hand within 50 ms", async (context) => {
    const page = await open();
    await page.replace(plateCamera);
    await page.tab.evaluate(() => document.querySelector("balcony-studio").resize("960x540"));
    await page.until(({ session }) => session.shown.width === 960 && session.shown.height === 540);
    const medians = [];
    for (let run = 0; run < 8 && medians.length < 3 && !medians.some((median) => median <= 50); ++run) {
        await page.untilFollowed();
        await page.tab.evaluate(() => document.querySelector("balcony-studio").session.latency.measured.splice(0));
        const shareOfOthers = othersShare();
        await page.drag("gamma", run % 2 === 0 ? 0.1 : 0.9, run % 2 === 0 ? 0.9 : 0.1, 60, 16);
        await page.until(({ session }) => session.latency.measured.length >= 30);
        const share = shareOfOthers();
        const measured = await page.tab.evaluate(
            () => document.querySelector("balcony-studio").session.latency.measured,
        );
        await page.tab.mouse.up();
        const sorted = [...measured].sort((a, b) => a - b);
        const part = (p) => Math.round(sorted[Math.floor(p * (sorted.length - 1))]);
        console.log(
            `from the hand to the picture: median ${part(0.5)} ms, 90%: ${part(0.9)} ms, of ${sorted.length}; ` +
                `others have ${Math.round(100 * share)}% of the machine`,
        );
        if (share <= 0.25) medians.push(part(0.5) * (1 - share));
    }
    if (medians.length === 0) context.skip("other programs have more than a quarter of the machine");
    else assert.ok(Math.min(...medians) <= 50, medians.join(", "));
});
