// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: node screenshot.mjs ADDRESS OUTPUT.png
//
// Writes what a browser shows of a studio at an address, when its picture is at rest.

import { chromium } from "playwright-core";

const [address, output] = process.argv.slice(2);
const browser = await chromium.launch({
    executablePath: process.env.BROWSER ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu", "--disable-background-networking"],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 720 }, colorScheme: "dark" });
await page.goto(address);
await page.waitForFunction(() => {
    const { session } = document.querySelector("balcony-studio");
    return session?.isSettled && session.shown?.quality === "denoised";
}, null, { timeout: 120_000 });
await page.screenshot({ path: output });
await browser.close();
