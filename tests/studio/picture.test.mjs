// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The picture under the hand: what stands at a pixel, and what follows when it is pulled.

import assert from "node:assert/strict";
import { test } from "node:test";
import { serverOf } from "./harness.mjs";

const text = `// A view that turns.
camera view(yaw = 10deg /* to the left */, pitch = -5deg, fov = 80deg above 0 to 170deg) {
    aspect 16/9
    map    u = tan(fov/2) .. -tan(fov/2), v = square
    eye    point(0, 0, 0)
    toward plane((1, 0, 0))
    look   absolute
    move   rotate(y, -pitch), rotate(z, yaw), translate(0, 0, 1.5)
}
`;

const studio = serverOf(text);

async function open() {
    const page = await studio.open();
    await page.tab.locator("#handles").click(); // They would be in the way.
    await page.tab.locator("stage-numbers").waitFor({ state: "detached" });
    await page.untilFollowed(); // The picture gets the room that they had.
    page.box = await page.tab.locator("live-picture canvas").boundingBox();
    page.size = await page.tab.evaluate(() => document.querySelector("balcony-studio").pixels);
    return page;
}

const place = ({ box }, x, y) => [box.x + x * box.width, box.y + y * box.height];
const at = (page, x, y) =>
    page.tab.evaluate(
        ([x, y]) => document.querySelector("balcony-studio").session.at([x, y]),
        [x * page.size[0], y * page.size[1]],
    );

test("a picture that had its room before the server answered has the pixels of it", async () => {
    const prepare = (tab) =>
        tab.addInitScript(() => {
            const { send } = WebSocket.prototype;
            WebSocket.prototype.send = function (message) {
                setTimeout(() => send.call(this, message), 500);
            };
        });
    const page = await studio.open({ prepare });
    const [shown, pixels] = await page.tab.evaluate(() => {
        const { session, pixels } = document.querySelector("balcony-studio");
        return [[session.shown.width, session.shown.height], pixels];
    });
    assert.deepEqual(shown, pixels);
});

test("the hand sees the object, the distance, (u, v) and the ray of a pixel, and a click keeps them", async () => {
    const page = await open();
    const words = page.tab.locator(".seen-at");
    await page.tab.mouse.move(...place(page, 0.5, 0.9));
    await words.waitFor();
    const { hit, ray } = await at(page, 0.5, 0.9);
    await page.until((_, object) => document.querySelector(".seen-at")?.textContent.includes(object), hit.object);
    const told = await words.innerText();
    assert.ok(told.includes(String(Number(hit.distance.toPrecision(4)))), told);
    // The middle of the picture is u = 0, and 0.4 of its height below it is v, within a pixel.
    const half = Math.tan((40 * Math.PI) / 180);
    assert.ok(Math.abs(ray.u) < (2 * half) / page.size[0], `${ray.u}`);
    assert.ok(Math.abs(ray.v + (0.8 * half * 9) / 16) < (2 * half) / page.size[0], `${ray.v}`);
    assert.match(told, / px a unit/);
    await page.tab.mouse.down();
    await page.tab.mouse.up();
    await page.tab.locator("picture-touch .cross").waitFor();
    await page.tab.mouse.move(...place(page, 0.2, 0.1));
    await page.tab.waitForTimeout(200);
    assert.equal(await words.innerText(), told);
    await page.tab.mouse.down();
    await page.tab.mouse.up();
    await page.tab.locator("picture-touch .cross").waitFor({ state: "detached" });
});

test("a point that is pulled goes with the hand, and the text has the numbers that do it, as one step", async () => {
    const page = await open();
    const before = await at(page, 0.5, 0.5);
    await page.tab.getByRole("button", { name: "fov follows" }).click();
    await page.tab.mouse.move(...place(page, 0.5, 0.5));
    await page.tab.mouse.down();
    for (const x of [0.52, 0.56, 0.6]) await page.tab.mouse.move(...place(page, x, 0.45));
    await page.tab.locator("picture-touch .pulled").waitFor();
    await page.until((studio) => studio.pictureHand.pulled?.told?.follows);
    assert.equal(await page.text(), text);
    await page.tab.mouse.up();
    await page.until((studio, text) => studio.text().toString() !== text, text);
    await page.untilFollowed();
    const now = await page.text();
    const [, yaw, pitch] = /yaw = ([\d.]+)deg \/\* to the left \*\/, pitch = ([-\d.]+)deg/.exec(now);
    assert.equal(now.replace(yaw, "10").replace(`pitch = ${pitch}`, "pitch = -5"), text);
    const after = await at(page, 0.6, 0.45);
    const turned = before.ray.direction.reduce((sum, one, i) => sum + one * after.ray.direction[i], 0);
    // Two pixels of 80 degrees in this width.
    assert.ok(turned > Math.cos((2 * 80 * Math.PI) / 180 / page.size[0]), `${turned}`);
    await page.tab.keyboard.press("Control+z");
    await page.untilText(text);
});

test("pins hold points, and what cannot follow says by how much", async () => {
    const page = await open();
    await page.tab.keyboard.down("Shift");
    await page.tab.mouse.click(...place(page, 0.3, 0.5));
    await page.tab.keyboard.up("Shift");
    await page.tab.locator("picture-touch .pin").waitFor();
    for (const name of ["fov", "pitch"]) await page.tab.getByRole("button", { name: `${name} follows` }).click();
    await page.tab.mouse.move(...place(page, 0.6, 0.5));
    await page.tab.mouse.down();
    for (const x of [0.65, 0.7, 0.8]) await page.tab.mouse.move(...place(page, x, 0.5));
    // The yaw alone cannot move one point and hold another.
    await page.tab.locator("picture-touch .pulled.misses text").waitFor();
    assert.match(await page.tab.locator("picture-touch .pulled text").textContent(), /^\d+ px away$/);
    assert.match(await page.tab.locator(".status").innerText(), /cannot bring it nearer/);
    await page.tab.keyboard.press("Escape");
    await page.tab.mouse.up();
    await page.untilFollowed();
    assert.equal(await page.text(), text);
    assert.equal(await page.tab.locator("#parameter-yaw").inputValue(), "10");
    await page.tab.locator("picture-touch .unpin").click();
    await page.tab.locator("picture-touch .pin").waitFor({ state: "detached" });
});
