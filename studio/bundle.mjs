// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: node bundle.mjs [FOLDER]
//
// Bundles the page into a folder, by default ../build/studio: index.html, icon.svg, studio.js,
// studio.css and licences.txt, which has the licences of all that is bundled.

import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2] ?? join(here, "../build/studio");
mkdirSync(folder, { recursive: true });

const { metafile } = await build({
    absWorkingDir: here,
    entryPoints: ["src/studio.ts", "studio.css"],
    outdir: folder,
    entryNames: "[name]",
    bundle: true,
    minify: true,
    format: "esm",
    target: "es2022",
    legalComments: "none",
    metafile: true,
    logLevel: "warning",
});
for (const file of ["index.html", "icon.svg"]) copyFileSync(join(here, file), join(folder, file));

const packages = new Set();
for (const file of Object.keys(metafile.inputs)) {
    const name = /node_modules\/((?:@[^/]+\/)?[^/]+)\/(?!.*node_modules)/.exec(file)?.[1];
    if (name) packages.add(name);
}
const texts = [...packages].sort().map((name) => {
    const at = join(here, "node_modules", name);
    const { version, license } = JSON.parse(readFileSync(join(at, "package.json"), "utf8"));
    const file = readdirSync(at).find((one) => /^licen[cs]e/i.test(one));
    if (!file || !existsSync(join(at, file))) throw new Error(`${name} has no file with its licence`);
    return `${name} ${version}: ${license}\n\n${readFileSync(join(at, file), "utf8").trim()}\n`;
});
const head = "The page of balcony studio contains these packages.\n";
writeFileSync(join(folder, "licences.txt"), [head, ...texts].join(`\n${"-".repeat(80)}\n\n`));
