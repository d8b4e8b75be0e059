// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: node viewer.mjs FOLDER
//
// Writes viewer.html: all of a page but its title and its data, in one file without links. Its content
// security policy allows its own script and its own style by their hashes, and no connection. Writes
// licences.txt, too, whose text the page has.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { licences } from "./licences.mjs";
import { requirePackages } from "./packages.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const folder = resolve(process.argv[2]); // The bundler has another working folder.
mkdirSync(folder, { recursive: true });
requirePackages();

const { metafile, outputFiles } = await build({
    absWorkingDir: here,
    entryPoints: ["viewer/viewer.ts", "viewer/viewer.css"],
    outdir: folder,
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    legalComments: "none",
    metafile: true,
    write: false,
    logLevel: "warning",
});
const texts = licences("The pages of balcony page contain these packages.", metafile, join(here, "node_modules"));
const text = (ending) => outputFiles.find(({ path }) => path.endsWith(ending)).text.trim();
const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
const parts = {
    SCRIPT: text(".js"),
    STYLE: text(".css"),
    LICENCES: escaped(texts),
};
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
parts.POLICY = [
    "default-src 'none'",
    `script-src ${hash(parts.SCRIPT)}`,
    `style-src ${hash(parts.STYLE)}`,
    "base-uri 'none'",
    "form-action 'none'",
].join("; ");
const page = readFileSync(join(here, "viewer/viewer.html"), "utf8").replace(/<!--([A-Z]+)-->/g, (_, name) => parts[name]);
for (const mark of ["<!--title-->", "<!--data-->"]) {
    if (page.split(mark).length !== 2) throw new Error(`the viewer must have ${mark} once`);
}
writeFileSync(join(folder, "viewer.html"), page);
writeFileSync(join(folder, "licences.txt"), texts);
