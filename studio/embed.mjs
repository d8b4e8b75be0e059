// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: node embed.mjs FOLDER SOURCE
//
// Writes the files of a bundled page as a C++ source of the template with its name: page_files.cpp has
// them compressed, as a server sends them, and viewer.cpp as they are.

import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, extname, join } from "node:path";
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

const here = dirname(fileURLToPath(import.meta.url));
const isCompressed = basename(source) === "page_files.cpp";

/** What all of them may have together, in bytes. */
const most = 1.5e6;

function compressed(bytes) {
    const made = gzipSync(bytes, { level: 9 });
    made[9] = 255; // The system that compressed it, which is unknown.
    return made;
}

const arrays = [];
const rows = [];
let sum = 0;
const names = isCompressed ? readdirSync(folder).sort() : ["viewer.html"];
for (const [index, name] of names.entries()) {
    const whole = readFileSync(join(folder, name));
    const bytes = isCompressed ? compressed(whole) : whole;
    sum += bytes.length;
    const lines = [];
    for (let at = 0; at < bytes.length; at += 24) lines.push(`    ${[...bytes.subarray(at, at + 24)].join(",")},`);
    arrays.push(`constexpr std::uint8_t file_${index}[] = {\n${lines.join("\n")}\n};`);
    rows.push(
        isCompressed
            ? `{"${name}", "${types[extname(name)]}", file_${index}, true},`
            : `all = {reinterpret_cast<const char*>(file_${index}), sizeof(file_${index})};`,
    );
}
if (sum > most) throw new Error(`the page has ${sum} bytes; at most ${most} are right`);
const template = readFileSync(join(here, `${basename(source)}.in`), "utf8");
writeFileSync(
    source,
    template.replace("// ARRAYS", () => arrays.join("\n")).replace("// ROWS", () => rows.join("\n        ")),
);
