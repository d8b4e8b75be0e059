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
    // The editor asks its own questions, some of them after it has been opened.
    const lattices = (await asked.jsonValue()).filter((method) => method.startsWith("view/"));
    assert.deepEqual(lattices, ["view/grid"]);
    const [place, seen] = await page.tab.evaluate(async () => {
        const { inspection, session } = document.querySelector("balcony-studio");
        const place = inspection.lattice.places.findLast((one) => one.hit);
        return [place, await session.at([place.x, place.y])];
    });
    assert.deepEqual(place, seen);
});

test("the legend is not longer than a flat picture", async () => {
    const page = await studio.open();
    await choose(page, "#overlay-objects");
    await untilLattice(page);
    await page.tab.locator(".legend li").first().waitFor();
    const [legend, picture, entries] = await page.tab.evaluate(() => [
        document.querySelector(".legend").getBoundingClientRect(),
        document.querySelector("picture-overlays").getBoundingClientRect(),
        [...document.querySelectorAll(".legend li")].map((one) => one.getBoundingClientRect()),
    ]);
    assert.ok(picture.height < 200 && entries.length >= 6, `${picture.height} ${entries.length}`);
    for (const one of [legend, ...entries]) {
        assert.ok(one.bottom <= picture.bottom && one.right <= picture.right, JSON.stringify([one, picture]));
    }
});

test("circles are ellipses by the metric of the lattice", async () => {
    const page = await studio.open();
    await page.tab.evaluate(() => {
        const { inspection } = document.querySelector("balcony-studio");
        // A lattice of one cell in which a step to the lower right is half as long as one to the upper right.
        const ray = { layer: "", origin: [0, 0, 0], direction: [1, 0, 0], u: 0, v: 0 };
        const hit = { object: "a", material: "", distance: 1, point: [0, 0, 0], magnification: 1, metric: [5, -3, 5] };
        inspection.overlays.add("ellipses");
        inspection.ask = () => {}; // Whatever has followed, or follows.
        inspection.lattice = { columns: 1, rows: 1, size: [100, 20], places: [{ x: 50, y: 10, ray, hit }] };
        document.querySelector("balcony-studio").changed();
    });
    const ellipse = page.tab.locator("picture-overlays ellipse");
    await ellipse.waitFor();
    const [rx, ry, move] = await ellipse.evaluate((one) => ["rx", "ry", "transform"].map((name) => one.getAttribute(name)));
    // (1, 1) has the length 2 and (1, -1) the length 4.
    assert.ok(Math.abs(rx / ry - 2) < 1e-9, `${rx} ${ry}`);
    const angle = Number(/rotate\((.*)\)/.exec(move)[1]);
    assert.ok(Math.abs((angle % 180) - 45) < 1e-9, move);
    assert.match(await page.tab.locator(".legend").innerText(), /circles of radius/);
});

test("what check finds is shown where it is, with its text, and follows the text", async () => {
    const page = await studio.open();
    await choose(page, "#overlay-findings");
    await page.until(({ inspection }) => inspection.remarks !== null);
    await page.replace(`camera part(least = 0.5) {
    aspect 2
    map    u = 1 .. -1, v = square
    eye    point(0, 0, 0)
    toward surface(u, v) = [1 + sqrt(least - u)/1e6, u, v]
}
`);
    await page.untilFollowed();
    const area = page.tab.locator("picture-overlays path.remark.defect");
    await page.tab.getByText("25 % of the picture has no ray").first().waitFor();
    // The left quarter of the picture.
    const [seen, picture] = [await area.boundingBox(), await page.tab.locator("picture-overlays").boundingBox()];
    assert.ok(Math.abs(seen.x - picture.x) < 1 && Math.abs(seen.width - picture.width / 4) < 4, JSON.stringify(seen));
    assert.ok(Math.abs(seen.height - picture.height) < 1);
    const entry = page.tab.locator(".remarks li.defect");
    assert.match(await entry.innerText(), /restrict map/);
    await page.tab.locator(".remarks li").last().focus();
    await page.tab.locator("path.remark.defect.faint").waitFor({ state: "attached" });
    // A hand that moves the number has another picture checked.
    await page.tab.evaluate(() =>
        document.querySelector("balcony-studio").session.changeView({ values: [{ parameter: "least", value: 2 }] }),
    );
    await entry.waitFor({ state: "detached" });
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
