// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: node embed.mjs FOLDER SOURCE
//
// Writes the files of a bundled page, compressed, as a C++ source that defines studio::page_files().

import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const [folder, source] = process.argv.slice(2);
const types = {
    ".css": "text/css; charset=utf-8",
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".svg": "image/svg+xml",
    ".txt": "text/plain; charset=utf-8",
};

/** What all of them may have together, in bytes. */
const most = 1.5e6;

const arrays = [];
const rows = [];
let sum = 0;
for (const [index, name] of readdirSync(folder).sort().entries()) {
    const bytes = gzipSync(readFileSync(join(folder, name)), { level: 9 });
    bytes[9] = 255; // The system that compressed it, which is unknown.
    sum += bytes.length;
    const lines = [];
    for (let at = 0; at < bytes.length; at += 24) lines.push(`    ${[...bytes.subarray(at, at + 24)].join(",")},`);
    arrays.push(`constexpr std::uint8_t file_${index}[] = {\n${lines.join("\n")}\n};`);
    rows.push(`{"${name}", "${types[extname(name)]}", file_${index}, true},`);
}
if (sum > most) throw new Error(`the page has ${sum} bytes, compressed; at most ${most} are right`);
const template = readFileSync(join(dirname(fileURLToPath(import.meta.url)), "page_files.cpp.in"), "utf8");
writeFileSync(
    source,
    template.replace("// ARRAYS", () => arrays.join("\n")).replace("// ROWS", () => rows.join("\n        ")),
);
