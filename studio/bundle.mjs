// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: node bundle.mjs [FOLDER]
//
// Bundles the page into a folder, by default ../build/studio: index.html, icon.svg, studio.js
// with what it loads later, studio.css and licences.txt, which has the licences of all that is bundled.

import { copyFileSync, mkdirSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { licences } from "./licences.mjs";
import { requirePackages } from "./packages.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const folder = resolve(process.argv[2] ?? join(here, "../build/studio")); // The bundler has another working folder.
mkdirSync(folder, { recursive: true });
requirePackages();
// Names of files that are loaded later change with the sources.
for (const file of readdirSync(folder)) if (file.endsWith(".js")) rmSync(join(folder, file));

const { metafile } = await build({
    absWorkingDir: here,
    entryPoints: ["src/studio.ts", "studio.css"],
    outdir: folder,
    entryNames: "[name]",
    chunkNames: "[name]",
    bundle: true,
    splitting: true, // What is imported later is another file.
    minify: true,
    format: "esm",
    target: "es2022",
    legalComments: "none",
    metafile: true,
    logLevel: "warning",
});
for (const file of ["index.html", "icon.svg"]) copyFileSync(join(here, file), join(folder, file));

writeFileSync(join(folder, "licences.txt"),
    licences("The page of balcony studio contains these packages.", metafile, join(here, "node_modules")));
