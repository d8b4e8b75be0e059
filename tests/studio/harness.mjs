// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A server of the studio, and pages of it in a browser.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";
import { after, afterEach, beforeEach } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "../../studio/node_modules/playwright-core/index.mjs";

export const patience = Number(process.env.PATIENCE ?? 30_000);

const repository = join(dirname(fileURLToPath(import.meta.url)), "../..");
/** The text of plate 2's camera. */
export const plateCamera = readFileSync(join(repository, "plates/02-superelliptic/camera.cam"), "utf8");

/** With comments behind numbers, a camera of 9 numbers that all move, and a second camera. */
export const text = `// A second camera.
camera straight(fov = 80deg) {
    map    u = tan(fov/2) .. -tan(fov/2), v = square
    eye    point(0, 0, 0)
    toward plane((1, 0, 0))
    look   absolute
}

// All walls of a room in one picture.
camera walls(a = 4.5 above 0, /* half its length */ b = 2.5 above 0, // half its width
             c = 1.2 above 0, gamma = 0.25 from 0.05 to 2, seam = 30.85deg) {
    aspect 5
    map    u = 180deg + seam .. seam - 180deg, v = -36deg .. 36deg
    eye    product(superellipse(1, b/a, gamma, by = arc_length),
                   superellipse(a, c, gamma, by = arc_length))
    look   normal
    move   translate(0, 0, 1.5)
}
`;

const folder = mkdtempSync(join(tmpdir(), "balcony-studio-"));
export const cameraFile = join(folder, "my camera.cam");
const scene = join(folder, "gallery.glb");
const tokenFile = join(folder, "token");
execFileSync(process.env.BUILD_SCENE, ["gallery", scene]);

async function freePort() {
    const server = createServer();
    server.listen(0, "127.0.0.1");
    await once(server, "listening");
    const { port } = server.address();
    server.close();
    await once(server, "close");
    return port;
}
const port = await freePort();

export class Server {
    static async start(...options) {
        const server = new Server();
        const args = ["studio", scene, cameraFile, "--port", String(port), "--token-file", tokenFile, ...options];
        server.process = spawn(process.env.BALCONY, args, { stdio: ["ignore", "pipe", "inherit"] });
        server.ended = once(server.process, "exit");
        for await (const line of createInterface(server.process.stdout)) {
            server.address = /http:\/\/127\.0\.0\.1:\d+\/\?token=[0-9a-f]+/.exec(line)?.[0];
            if (server.address) return server;
        }
        throw new Error("the server has not said its address");
    }

    async stop() {
        this.process.kill();
        await this.ended;
    }
}

const browser = await chromium.launch({
    executablePath: process.env.BROWSER,
    headless: true,
    args: [
        ...["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run"],
        ...["--disable-background-networking", "--disable-component-update", "--disable-sync"],
        // Pages behind others are drawn, too.
        ...["--disable-renderer-backgrounding", "--disable-backgrounding-occluded-windows"],
    ],
});

/** What went wrong in any page. A connection that is lost is told as an error of the network. */
const complaints = [];

export class Page {
    expected = /ERR_CONNECTION|WebSocket/;

    /** `prepare` gets the tab before it has an address. */
    static async open(address, { prepare, ...options } = {}) {
        const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, ...options });
        await context.grantPermissions(["clipboard-read", "clipboard-write"]);
        const page = new Page();
        page.tab = await context.newPage();
        page.tab.setDefaultTimeout(patience);
        page.tab.on("pageerror", (error) => complaints.push(String(error)));
        page.tab.on("console", (message) => {
            if (message.type() === "error" && !page.expected.test(message.text())) {
                complaints.push(message.text());
            }
        });
        await prepare?.(page.tab);
        await page.tab.goto(address);
        return page;
    }

    /** Messages of the page that a test causes. */
    expect(pattern) {
        this.expected = pattern;
    }

    async close() {
        await this.tab.context().close();
    }

    /** Waits until a function of the studio's element holds. */
    async until(condition, argument) {
        const asked = `(${condition})(document.querySelector("balcony-studio"), ${JSON.stringify(argument)})`;
        for (const end = Date.now() + patience; !(await this.tab.evaluate(asked)); ) {
            if (Date.now() > end) throw new Error(`it has not come to: ${condition}`);
            await this.tab.waitForTimeout(20);
        }
    }

    text() {
        return this.tab.evaluate(() => document.querySelector("camera-editor").text);
    }

    async untilText(text) {
        await this.until((studio, text) => studio.text().toString() === text, text);
    }

    state() {
        return this.tab.locator("#state").innerText();
    }

    /** Waits for the picture of everything that has been changed, in the size of its room, and in one ray a pixel or
     *  more. */
    async untilFollowed() {
        await this.until((studio) => {
            const { pixels } = studio;
            studio.fit();
            return studio.pixels === pixels;
        });
        await this.until(({ session }) => session.isSettled);
        const { change } = await this.tab.evaluate(() =>
            document.querySelector("balcony-studio").session.connection.request("view/change", {}),
        );
        await this.until(
            ({ session }, change) => session.shown?.change >= change && session.shown.quality !== "coarse",
            change,
        );
    }

    /** A number that is another one for another picture. */
    pixels() {
        return this.tab.evaluate(() => {
            const canvas = document.querySelector("live-picture canvas");
            const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
            let sum = canvas.width;
            for (let i = 0; i < data.length; ++i) sum = (Math.imul(sum, 31) + data[i]) | 0;
            return sum;
        });
    }

    /** Selects as many letters of a part of the text. */
    async select(part, letters = part.length) {
        const at = (await this.text()).indexOf(part);
        if (at < 0) throw new Error(`the text does not have '${part}'`);
        await this.tab.evaluate(
            ([from, to]) => document.querySelector("camera-editor").goTo(from, to),
            [at, at + letters],
        );
    }

    /** Replaces a part of the text, as one types. */
    async type(before, after) {
        await this.select(before);
        await this.tab.keyboard.insertText(after);
    }

    /** Replaces the whole text. */
    async replace(after) {
        await this.tab.evaluate((insert) => {
            const editor = document.querySelector("camera-editor");
            editor.change({ from: 0, to: editor.text.length, insert });
        }, after);
        await this.untilText(after);
    }

    /** Drags from the middle of an element by pixels of the screen, in steps; does not let go. */
    async pull(element, by, steps = 5) {
        const { x, y, width, height } = await element.boundingBox();
        const [x0, y0] = [x + width / 2, y + height / 2];
        await this.tab.mouse.move(x0, y0);
        await this.tab.mouse.down();
        for (let i = 1; i <= steps; ++i) await this.tab.mouse.move(x0 + (by[0] * i) / steps, y0 + (by[1] * i) / steps);
    }

    /** Drags the slider of a parameter from one part of its width to another, in steps; does not let go. */
    async drag(parameter, from, to, steps, pause = 0) {
        const { x, y, width, height } = await this.tab.locator(`#parameter-${parameter}`).boundingBox();
        const middle = y + height / 2;
        await this.tab.mouse.move(x + from * width, middle);
        await this.tab.mouse.down();
        for (let i = 1; i <= steps; ++i) {
            await this.tab.mouse.move(x + (from + ((to - from) * i) / steps) * width, middle);
            if (pause > 0) await this.tab.waitForTimeout(pause);
        }
    }
}

/** What the tests of a file have: each a server of its own, which begins with the text. */
export function serverOf(text) {
    const made = {
        server: null,
        pages: [],
        async open(options) {
            const page = await Page.open(made.server.address, options);
            made.pages.push(page);
            await page.untilFollowed();
            return page;
        },
    };
    beforeEach(async () => {
        writeFileSync(cameraFile, text);
        made.server = await Server.start();
    });
    afterEach(async () => {
        for (const page of made.pages.splice(0)) await page.close();
        await made.server.stop();
        assert.deepEqual(complaints.splice(0), []);
    });
    after(async () => {
        await made.server.stop(); // Nothing follows a test that skips itself.
        await browser.close();
        rmSync(folder, { recursive: true });
    });
    return made;
}
