// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The time of the picture: it is scrubbed, played, and left. Numbers get keys, and a film is made.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { cameraFile, serverOf } from "./harness.mjs";

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
    // On a slow machine, five frames are not the whole of this film.
    await page.tab.getByLabel("Length in seconds").fill("600");
    await page.tab.locator("#play").click();
    const played = await page.tab.evaluate(async () => {
        const line = document.querySelector("time-line");
        const seen = [];
        while (new Set(seen.map(([, time]) => time)).size < 5) {
            await new Promise((goOn) => setTimeout(goOn, 50));
            seen.push([(performance.now() - line.began) / 1000, line.time]);
        }
        return seen;
    });
    // Never ahead of the clock, and it moves; how far behind depends on the machine.
    for (const [clock, time] of played) assert.ok(time <= clock + 0.01, `${clock} ${time}`);
    await page.tab.locator("#play").click();
    await page.untilFollowed();
    const time = await page.tab.evaluate(() => document.querySelector("time-line").time);
    assert.ok(time > 0);
    assert.ok(Math.abs((await place(page)) - (-2 + time)) < 1e-6);
    await page.tab.waitForTimeout(200);
    assert.equal(await page.tab.evaluate(() => document.querySelector("time-line").time), time);
});

/** Moves the slider of a parameter by the keyboard, and waits until the text has its new number. */
async function nudge(page, parameter, key) {
    const before = await page.text();
    await page.tab.locator(`#parameter-${parameter}`).focus();
    await page.tab.keyboard.press(key);
    await page.until((studio, before) => studio.text().toString() !== before, before);
}

test("a slider writes keys, which stand on the line, and are removed", async () => {
    const page = await studio.open();
    await page.tab.locator("#timeline").click();
    const frame = page.tab.getByRole("slider", { name: "Frame" });
    await frame.fill("25");
    // Without being asked to, it moves the number of all times.
    await nudge(page, "from", "ArrowRight");
    assert.match(await page.text(), /^camera gliding\(from = -1\.\d+\) \{/);
    const [, start] = /from = (\S+)\)/.exec(await page.text());
    await page.tab.locator("#keying").click();
    await nudge(page, "from", "ArrowRight");
    const [, first] = /^camera gliding\(from = keys\(\((\S+), (\S+)\), \(1, (\S+)\)\)\) \{/
        .exec(await page.text())
        .slice(1);
    assert.equal(first, start);
    await frame.fill("49");
    await page.untilFollowed();
    await nudge(page, "from", "ArrowLeft");
    assert.match(await page.text(), /keys\(\(0, \S+\), \(1, \S+\), \(2, \S+\)\)/);
    await page.tab.locator("time-line .key").nth(2).waitFor();
    // Between the keys is what they say, also on the slider.
    const [, one, two] = /\(1, ([-\d.]+)\), \(2, ([-\d.]+)\)\)/.exec(await page.text()).map(Number);
    await frame.fill("37");
    await page.untilFollowed();
    await page.until(
        (studio, value) => Math.abs(studio.session.parameters[0].value - value) < 1e-9,
        (one + two) / 2,
    );
    assert.ok(Math.abs((await place(page)) - ((one + two) / 2 + 1.5)) < 1e-5);
    assert.equal(await page.tab.locator("#unkey").count(), 0);
    const track = await frame.boundingBox();
    const key = await page.tab.getByRole("button", { name: "Key at frame 25" }).boundingBox();
    const at = track.x + 8 + ((track.width - 16) * 24) / 119;
    assert.ok(Math.abs(key.x + key.width / 2 - at) < 2, `${key.x} ${at}`);
    await page.tab.getByRole("button", { name: "Key at frame 25" }).click();
    await page.tab.getByText("frame 25 of 120").waitFor();
    await page.tab.locator("#unkey").click();
    await page.until((studio) => /keys\(\(0, \S+\), \(2, \S+\)\)/.test(studio.text().toString()));
    // One step of undo.
    await page.tab.locator("camera-editor .cm-content").click();
    await page.tab.keyboard.press("Control+z");
    await page.until((studio) => /\(1, /.test(studio.text().toString()));
});

test("a page that comes later writes keys at the time that is shown", async () => {
    const page = await studio.open();
    await page.replace((await page.text()).replace("from = -2", "from = keys((0, -2), (2, 0))"));
    await page.tab.evaluate(() => document.querySelector("balcony-studio").session.film.show(1));
    await page.untilFollowed();
    const other = await studio.open();
    await other.until((studio) => studio.session.parameters[0]?.value === -1);
    await nudge(other, "from", "ArrowRight");
    assert.match(await other.text(), /keys\(\(0, -2\), \(1, -0\.9\d*\), \(2, 0\)\)/);
});

const hasFfmpeg = (() => {
    try {
        execFileSync("ffmpeg", ["-version"], { stdio: "ignore" });
        return true;
    } catch {
        return false;
    }
})();

test("a film is made of the line", { skip: !hasFfmpeg && "ffmpeg is not installed" }, async () => {
    const page = await studio.open();
    await page.tab.locator("#timeline").click();
    await page.tab.locator("#film").click();
    const dialog = page.tab.getByRole("dialog", { name: "Render a film" });
    assert.equal(await dialog.locator("[name=frames]").inputValue(), "120");
    assert.equal((await dialog.locator("[name=height]").inputValue()) % 2, 0);
    for (const [name, value] of Object.entries({ frames: 3, width: 32, height: 16, samples: 1 })) {
        await dialog.locator(`[name=${name}]`).fill(String(value));
    }
    await dialog.locator("[name=output]").selectOption("gif");
    await dialog.getByRole("button", { name: "Render" }).click();
    const file = cameraFile.replace(/\.cam$/, ".gif");
    await page.tab.getByText(`Wrote ${file}`).waitFor();
    assert.equal(readFileSync(file).subarray(0, 6).toString(), "GIF89a");
});
