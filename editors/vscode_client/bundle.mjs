// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: node bundle.mjs FOLDER
//
// Makes the extension in a folder: the highlighting of ../vscode, and the client of `balcony lsp` with all that
// it uses and the licences of that. manifest.json has what the client adds to the manifest of the highlighting.

import { cpSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { licences } from "../../studio/licences.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const folder = resolve(process.argv[2]);
const json = (file) => JSON.parse(readFileSync(join(here, file), "utf8"));

rmSync(folder, { recursive: true, force: true });
cpSync(join(here, "../vscode"), folder, { recursive: true });
cpSync(join(here, "README.md"), join(folder, "README.md"));

const highlighting = json("../vscode/package.json");
const client = json("manifest.json");
const contributes = { ...highlighting.contributes, ...client.contributes };
const manifest = { ...highlighting, ...client, contributes };
writeFileSync(join(folder, "package.json"), `${JSON.stringify(manifest, null, 4)}\n`);

const { metafile } = await build({
    absWorkingDir: here,
    entryPoints: ["extension.js"],
    outfile: join(folder, "extension.cjs"),
    bundle: true,
    minify: true,
    format: "cjs",
    platform: "node",
    target: "node18",
    external: ["vscode"],
    legalComments: "none",
    metafile: true,
    logLevel: "warning",
});
writeFileSync(join(folder, "licences.txt"),
    licences("The extension contains these packages.", metafile, join(here, "node_modules")));
