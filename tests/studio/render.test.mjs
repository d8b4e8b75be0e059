// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures in full quality: one is written, one is stopped, and the command line that makes one is told.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { cameraFile, serverOf, text } from "./harness.mjs";

const studio = serverOf(text);

/** Opens the dialog by its key, and fills its fields. */
async function order(page, fields) {
    await page.tab.keyboard.press("Control+Enter");
    const dialog = page.tab.getByRole("dialog", { name: "Render in full quality" });
    for (const [name, value] of Object.entries(fields)) await dialog.locator(`[name=${name}]`).fill(String(value));
    await dialog.getByRole("button", { name: "Render" }).click();
}

function sizeOf(picture) {
    const bytes = readFileSync(picture);
    return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20) };
}

const file = (ending) => cameraFile.replace(/\.cam$/, ending);

test("a picture is rendered beside the camera file, and no file is replaced", async () => {
    const page = await studio.open();
    await order(page, { width: 64, height: 36, samples: 4 });
    await page.tab.getByText(`Wrote ${file(".png")}`).waitFor();
    const bytes = readFileSync(file(".png"));
    assert.deepEqual(sizeOf(file(".png")), { width: 64, height: 36 });
    await page.tab.locator("#render").click();
    const dialog = page.tab.getByRole("dialog", { name: "Render in full quality" });
    const [width, height] = await Promise.all(
        ["width", "height"].map((name) => dialog.locator(`[name=${name}]`).inputValue()),
    );
    const aspect = await page.tab.evaluate(() => {
        const { width, height } = document.querySelector("live-picture canvas");
        return width / height;
    });
    assert.equal(width, "1920");
    assert.ok(Math.abs(width / height - aspect) < 0.02 * aspect, `${height}`);
    await page.tab.keyboard.press("Escape");
    await order(page, { width: 32, height: 18, samples: 1 });
    await page.tab.getByText(`Wrote ${file("-2.png")}`).waitFor();
    assert.deepEqual(readFileSync(file(".png")), bytes);
});

test("a render shows how far it is, and is stopped", async () => {
    const page = await studio.open();
    await order(page, { width: 1600, height: 900, samples: 60000 });
    await page.tab.getByRole("progressbar", { name: "Rendering" }).waitFor();
    await page.until(({ session }) => session.render?.seconds > 0.5);
    await page.tab.locator("#stop").click();
    const words = await page.tab.getByText(/^Stopped: wrote /).innerText();
    const [, stopped] = /^Stopped: wrote (.*\.png)$/m.exec(words);
    assert.deepEqual(sizeOf(stopped), { width: 1600, height: 900 });
    await page.tab.locator("#render").waitFor();
});

test("the command line that renders what is shown is copied", async () => {
    const page = await studio.open();
    await page.tab.locator("summary").click();
    await page.tab.locator("#command").click();
    await page.tab.getByText(/^Copied:/).waitFor();
    const line = await page.tab.evaluate(() => navigator.clipboard.readText());
    assert.match(line, /^balcony render /);
    assert.ok(line.includes(cameraFile.split("/").at(-1)), line);
});

test("a camera is exported from the menu, copied and downloaded", async () => {
    const page = await studio.open();
    const choose = async (id) => {
        await page.tab.locator("summary").click();
        await page.tab.locator(id).click();
    };
    await choose("#export-glsl");
    const dialog = page.tab.getByRole("dialog", { name: "walls.glsl" });
    const made = await dialog.locator("pre").textContent();
    assert.match(made, /All walls of a room in one picture\./);
    assert.match(made, /walls_ray\(/);
    await dialog.getByRole("button", { name: "Copy" }).click();
    await page.tab.getByText("Copied walls.glsl").waitFor();
    assert.equal(await page.tab.evaluate(() => navigator.clipboard.readText()), made);
    await choose("#export-numpy");
    const [download] = await Promise.all([
        page.tab.waitForEvent("download"),
        page.tab.getByRole("dialog", { name: "walls.py" }).getByRole("button", { name: "Download" }).click(),
    ]);
    assert.equal(download.suggestedFilename(), "walls.py");
    assert.match(readFileSync(await download.path(), "utf8"), /^# walls: .* from my camera\.cam:walls\.$/m);
});

test("a camera that cannot be exported says why", async () => {
    const page = await studio.open();
    await page.replace(`${text}picture both { layer walls layer straight { place (0, 0) .. (0.2, 0.2) } }\n`);
    await page.untilFollowed();
    await page.tab.locator("summary").click();
    await page.tab.locator("#export-c").click();
    await page.tab.getByText("is a picture with layers, but one camera is exported").waitFor();
});
