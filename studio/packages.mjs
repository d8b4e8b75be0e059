// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

import { statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

/** Ends the program if the packages are older than what package-lock.json names. */
export function requirePackages() {
    const here = dirname(fileURLToPath(import.meta.url));
    const files = ["package-lock.json", "node_modules/.package-lock.json"];
    const [named, there] = files.map((file) => statSync(join(here, file)));
    if (named.mtimeMs > there.mtimeMs) {
        console.error("The packages of the page are older than studio/package-lock.json: scripts/studio --setup gets them.");
        process.exit(1);
    }
}
