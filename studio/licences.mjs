// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

/**
 * The licences of the packages of a bundle, as a text. The bundle is known from the metafile of esbuild, and
 * the packages are in the folder `modules`. One without a licence is an error.
 */
export function licences(head, metafile, modules) {
    const packages = new Set();
    for (const file of Object.keys(metafile.inputs)) {
        const name = /node_modules\/((?:@[^/]+\/)?[^/]+)\/(?!.*node_modules)/.exec(file)?.[1];
        if (name) packages.add(name);
    }
    const texts = [...packages].sort().map((name) => {
        const at = join(modules, name);
        const { version, license } = JSON.parse(readFileSync(join(at, "package.json"), "utf8"));
        const file = readdirSync(at).find((one) => /^licen[cs]e/i.test(one));
        if (!file) throw new Error(`${name} has no file with its licence`);
        return `${name} ${version}: ${license}\n\n${readFileSync(join(at, file), "utf8").trim()}\n`;
    });
    return [`${head}\n`, ...texts].join(`\n${"-".repeat(80)}\n\n`);
}
