// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What the studio shows to understand a camera: overlays of the picture, and the camera in space.

import assert from "node:assert/strict";
import { test } from "node:test";
import { serverOf, text } from "./harness.mjs";

const studio = serverOf(text);

async function choose(page, id) {
    await page.tab.locator("summary").click();
    await page.tab.locator(id).click();
}

const untilLattice = (page) => page.until((studio) => studio.inspection.lattice?.size[0] === studio.pixels[0]);

test("lines of u and v are where the map has them, and the horizon is level", async () => {
    const page = await studio.open();
    await choose(page, "#overlay-grid");
    await choose(page, "#overlay-horizon");
    await untilLattice(page);
    const seen = await page.tab.evaluate(() => {
        const box = document.querySelector("picture-overlays");
        const numbers = (path) => path.getAttribute("d").match(/[\d.]+/g).map(Number);
        const line = (name) => [...box.querySelectorAll(`path.${name}`)].map(numbers);
        return {
            words: [...box.querySelectorAll("text")].map((one) => one.textContent),
            u: line("u"),
            horizon: line("horizon"),
            size: [box.clientWidth, box.clientHeight],
        };
    });
    // u goes from 210.85 to -149.15 degrees.
    assert.ok(seen.words.includes("u 180°") && seen.words.includes("u -90°") && seen.words.includes("v 0°"), `${seen.words}`);
    const at = seen.words.filter((one) => one.startsWith("u ")).indexOf("u 180°");
    const wanted = ((210.85 - 180) / 360) * seen.size[0];
    for (let i = 0; i < seen.u[at].length; i += 2) assert.ok(Math.abs(seen.u[at][i] - wanted) < 1);
    // The middle of the superellipsoid, within a cell of the lattice.
    for (let i = 1; i < seen.horizon[0].length; i += 2) assert.ok(Math.abs(seen.horizon[0][i] - seen.size[1] / 2) < 8);
});

test("colours of the scale and of objects have a legend, and only one of them is shown", async () => {
    const page = await studio.open();
    await choose(page, "#overlay-scale");
    await untilLattice(page);
    const legend = page.tab.locator(".legend");
    await legend.waitFor();
    assert.match(await legend.innerText(), /px a unit/);
    const { object } = await page.tab.evaluate(
        async () => (await document.querySelector("balcony-studio").session.at([10, 10])).hit,
    );
    await choose(page, "#overlay-objects");
    await page.until((_, object) => document.querySelector(".legend")?.textContent.includes(object), object);
    assert.doesNotMatch(await legend.innerText(), /px a unit/);
    await choose(page, "#overlay-objects");
    await legend.waitFor({ state: "detached" });
});

test("a lattice of the picture is one question, and its points are those of the pixels", async () => {
    const page = await studio.open();
    const asked = await page.tab.evaluateHandle(() => {
        const { connection } = document.querySelector("balcony-studio").session;
        const names = [];
        const { request } = connection;
        connection.request = (method, ...more) => (names.push(method), request.call(connection, method, ...more));
        return names;
    });
    await choose(page, "#overlay-grid");
    await untilLattice(page);
    assert.deepEqual(await asked.jsonValue(), ["view/grid"]);
    const [place, seen] = await page.tab.evaluate(async () => {
        const { inspection, session } = document.querySelector("balcony-studio");
        const place = inspection.lattice.places.findLast((one) => one.hit);
        return [place, await session.at([place.x, place.y])];
    });
    assert.deepEqual(place, seen);
});

test("the camera in space is drawn, and a point of it is found in the picture", async () => {
    const page = await studio.open();
    await page.tab.locator("#space").click();
    await page.until(() => document.querySelector("camera-space")?.space?.points);
    await untilLattice(page);
    const drawn = await page.tab.evaluate(() => {
        const space = document.querySelector("camera-space");
        space.space.draw();
        const image = new OffscreenCanvas(space.clientWidth, space.clientHeight).getContext("2d");
        image.drawImage(space.querySelector("canvas"), 0, 0, space.clientWidth, space.clientHeight);
        const { data } = image.getImageData(0, 0, space.clientWidth, space.clientHeight);
        let seen = 0;
        for (let i = 3; i < data.length; i += 4) seen += data[i] > 0 ? 1 : 0;
        return seen / (data.length / 4);
    });
    assert.ok(drawn > 0.02, `${drawn}`);
    // A point that the picture shows is found where it shows it.
    const [place, found] = await page.tab.evaluate(async () => {
        const studio = document.querySelector("balcony-studio");
        const place = studio.inspection.lattice.places.find((one) => one.hit);
        await studio.find(place.hit.point);
        return [place, studio.found];
    });
    assert.ok(found.some(([x, y]) => Math.hypot(x - place.x, y - place.y) < 2), `${JSON.stringify([place, found])}`);
    await page.tab.locator("picture-touch .cross").first().waitFor();
});

test("without WebGL, the page says so and goes on", async () => {
    const page = await studio.open();
    await page.tab.evaluate(() => {
        const { getContext } = HTMLCanvasElement.prototype;
        HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
            return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...more);
        };
    });
    page.expect(/WebGL/);
    await page.tab.locator("#space").click();
    await page.tab.getByText("it has no WebGL").waitFor();
    await page.untilFollowed();
});
