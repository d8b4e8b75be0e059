// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Each kind of handle in the studio: what a hand or a key does to it, and the text that this makes.

import assert from "node:assert/strict";
import { test } from "node:test";
import { serverOf } from "./harness.mjs";

const text = `// Handles of all kinds but those of pictures.
let half = 1
camera inset(fov = 60deg above 0 to 179deg, px = -3) {
    aspect 16/9
    map    u = half .. -half, /* upright */ v = -0.5 .. 0.5
    warp   repeat(2, zoom(at = (0.2, -0.1), radius = 0.4, strength = 2)) // near
    eye    point(0, 0, 1.5)
    toward plane((1, 0, 0))
    move   rotate((0, 0.5, 1), 10deg), translate(px, 0, 0.25)
}

picture both {
    aspect 16/9
    layer inset
    layer inset(px = -1) {
        place (0.6, 0.1) .. (0.95, 0.5)
        clip  ellipse
        leader (0.4, 0.5) .. (0.5, 0.6)
    }
}
`;

const studio = serverOf(text);

async function open(camera, options) {
    const page = await studio.open(options);
    await page.tab.locator("#camera").selectOption(camera);
    await page.tab.locator("picture-handles .mark").first().waitFor();
    await page.untilFollowed();
    page.picture = await page.tab.locator("live-picture canvas").boundingBox();
    return page;
}

const mark = (page, label) => page.tab.locator(`picture-handles .mark[aria-label="${label}"]`);
const number = (page, label) => page.tab.locator(`stage-numbers .scrub[aria-label="${label}"]`);

/** Waits until the text has all that a hand did which has let go. */
const untilWritten = (page) => page.until(({ hand, session }) => hand.held === null && session.isSettled);

/** Drags an element, lets go, and returns the numbers that now stand for one of the text, ended by undo. */
async function changed(page, element, by, before, pattern) {
    await page.pull(element, by);
    await page.tab.mouse.up();
    await untilWritten(page);
    const now = await page.text();
    const found = pattern.exec(now);
    assert.ok(found, now);
    // All else is as it was, and the way of the hand is one step.
    assert.equal(now.replace(found[0], before), text);
    assert.ok(text.includes(before));
    await page.tab.keyboard.press("Control+z");
    await page.untilText(text);
    await page.until(({ session }) => session.isSettled);
    return found.slice(1).map(Number);
}

const near = (value, wanted, step) =>
    assert.ok(Math.abs(value - wanted) <= step, `${value} is not ${wanted} within ${step}`);

test("points, ranges and radii on the picture", async () => {
    const page = await open("inset");
    const { width, height } = page.picture;
    const pixels = await page.tab.evaluate(() => document.querySelector("balcony-studio").pixels);
    const u = 2 / pixels[0];
    const v = 1 / pixels[1];

    // To the left is a larger u in this map.
    const [at_u, at_v] = await changed(
        page, mark(page, "zoom at"), [-0.1 * width, -0.2 * height],
        "at = (0.2, -0.1)", /at = \(([-\d.]+), ([-\d.]+)\)/);
    near(at_u, 0.4, u);
    near(at_v, 0.1, v);

    const [radius] = await changed(
        page, mark(page, "zoom radius"), [0.05 * width, 40], "radius = 0.4", /radius = ([\d.]+)/);
    near(radius, 0.5, u);

    // Both ends of u are made of one number.
    const [half] = await changed(page, mark(page, "map u, left"), [0.1 * width, 0], "half = 1", /half = ([\d.]+)/);
    near(half, 0.8, u);

    const [top] = await changed(page, mark(page, "map v, top"), [5, 0.1 * height], ".. 0.5", /\.\. (0[\d.]*)/);
    near(top, 0.4, v);
    const [bottom] = await changed(
        page, mark(page, "map v, bottom"), [0, -0.2 * height], " v = -0.5", / v = ([-\d.]+)/);
    near(bottom, -0.3, v);
});

test("a radius in degrees, and one that differs in u and v", async () => {
    const page = await open("inset");
    const turned = text
        .replace("u = half .. -half, /* upright */ v = -0.5 .. 0.5", "u = 40deg .. -40deg, v = -30deg .. 30deg")
        .replace("(0.2, -0.1), radius = 0.4", "(0deg, 0deg), radius = (10deg, 20deg)")
        .replace("toward plane((1, 0, 0))", "toward sphere(1)");
    await page.replace(turned);
    await page.until(({ session }) => session.isSettled);
    await page.untilFollowed();
    const { width, height } = page.picture;
    await page.pull(mark(page, "zoom radius").locator(".knob"), [0.1 * width, 0]);
    await page.tab.mouse.up();
    await page.pull(mark(page, "zoom radius 2").locator(".knob"), [0, 0.1 * height]);
    await page.tab.mouse.up();
    await page.until((studio) => /radius = \(1[78][.\d]*deg, 1[34][.\d]*deg\)/.test(studio.text().toString()));
});

test("a handle outside of the picture waits at its border, and comes from there", async () => {
    const page = await open("inset");
    await page.replace(text.replace("at = (0.2, -0.1)", "at = (0.2, -0.8)"));
    await page.until(({ session }) => session.isSettled);
    await page.untilFollowed();
    const { height } = page.picture;
    await page.pull(mark(page, "zoom at").locator(".knob"), [0, -0.25 * height]);
    await page.tab.mouse.up();
    await untilWritten(page);
    // It waits 8 pixels above the lower border, which is v = -0.5.
    const v = Number(/at = \([-\d.]+, ([-\d.]+)\)/.exec(await page.text())[1]);
    near(v, -0.5 + 0.25 + 8 / height, 2 / height);
});

test("the picture follows a handle on its way", async () => {
    const page = await open("inset");
    const before = await page.pixels();
    await page.pull(mark(page, "zoom at"), [80, 0]);
    await page.until((studio, text) => studio.text().toString() !== text, text);
    await page.untilFollowed();
    assert.notEqual(await page.pixels(), before);
    await page.tab.mouse.up();
});

test("numbers that have no place on the picture", async () => {
    const page = await open("inset");
    const drag = (label, by, before, pattern) => changed(page, number(page, label), [by, 0], before, pattern);
    assert.deepEqual(await drag("zoom strength", 50, "strength = 2", /strength = ([\d.]+)/), [2.5]);
    assert.deepEqual(await drag("repeat times", 36, "repeat(2,", /repeat\((\d+),/), [5]);
    assert.deepEqual(await drag("point z", -50, "0, 0, 1.5", /0, 0, ([\d.]+)/), [1]);
    assert.deepEqual(await drag("rotate axis x", 120, "(0, 0.5, 1)", /\((0[\d.]*), 0.5, 1\)/), [0.12]);
    assert.deepEqual(await drag("rotate angle", -100, "10deg)", /([-\d.]+)deg\)/), [0]);
    // The parameter px has a slider; here it is moved with the others of its point.
    assert.deepEqual(await drag("translate x", 100, "px = -3", /px = ([-\d.]+)(?=\))/), [-2]);
});

test("regions and points of pictures", async () => {
    const page = await open("both");
    const { width, height } = page.picture;
    const pixels = await page.tab.evaluate(() => document.querySelector("balcony-studio").pixels);
    const [x, y] = await changed(
        page, mark(page, "place from"), [-0.1 * width, 0.1 * height], "(0.6, 0.1)", /\(([\d.]+), ([\d.]+)\)(?= \.\. \(0.95)/);
    near(x, 0.5, 1 / pixels[0]);
    near(y, 0.2, 1 / pixels[1]);
    const leader = /leader \(([\d.]+), ([\d.]+)\) \.\. \(([\d.]+), ([\d.]+)\)/;
    const before = "leader (0.4, 0.5) .. (0.5, 0.6)";
    const corner = await changed(
        page, mark(page, "leader, bottom right"), [0.05 * width, 0], before, leader);
    near(corner[2], 0.55, 1 / pixels[0]);
    assert.deepEqual([corner[0], corner[1], corner[3]], [0.4, 0.5, 0.6]);
    const whole = await changed(page, mark(page, "leader"), [0.2 * width, -0.1 * height], before, leader);
    [0.6, 0.4, 0.7, 0.5].forEach((wanted, i) => near(whole[i], wanted, 1 / pixels[i % 2]));
});

test("arrows move a handle by pixels, and what they do in a row is one step of undo", async () => {
    const page = await open("inset");
    const pixels = await page.tab.evaluate(() => document.querySelector("balcony-studio").pixels);
    await page.tab.keyboard.press("Alt+3");
    await mark(page, "zoom at").focus();
    // At once: keys that wait for each other rest between, on a busy machine.
    const keys = ["ArrowUp", "ArrowUp", "ArrowUp", "Shift+ArrowRight"];
    await Promise.all(keys.map((key) => page.tab.keyboard.press(key)));
    const asked = /at = \(([-\d.]+), ([-\d.]+)\)/;
    await page.until((studio, text) => studio.text().toString() !== text, text);
    await page.tab.waitForTimeout(900);
    await page.until(({ session }) => session.isSettled);
    const [, u, v] = asked.exec(await page.text());
    near(Number(u), 0.2 - 10 * (2 / pixels[0]), 1e-3);
    near(Number(v), -0.1 + 3 * (1 / pixels[1]), 1e-3);
    await page.tab.keyboard.press("Control+z");
    await page.untilText(text);
    await number(page, "zoom strength").focus();
    await page.tab.keyboard.press("Shift+ArrowRight");
    await page.untilText(text.replace("strength = 2", "strength = 2.1"));
});

test("handles are hidden by a button, and there are none of a text with errors", async () => {
    const page = await open("inset");
    await page.tab.locator("#handles").click();
    assert.equal(await page.tab.locator("picture-handles .mark").count(), 0);
    assert.equal(await page.tab.locator("stage-numbers .scrub").count(), 0);
    await page.tab.locator("#handles").click();
    await mark(page, "zoom at").waitFor();
    await page.type("strength = 2)", "strength = 2");
    await mark(page, "zoom at").waitFor({ state: "detached" });
});
