// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A built-in camera as a start: its text behind that of the file, under a name that the file does not have.

export function taken(text: string, camera: string, name: string, names: string[]): { insert: string; name: string } {
    let free = name;
    for (let number = 2; names.includes(free); ++number) free = `${name}_${number}`;
    const renamed = camera.replace(new RegExp(`^(\\s*(?:camera|picture)\\s+)${name}\\b`, "m"), `$1${free}`);
    const gap = text.trim() === "" ? "" : text.endsWith("\n") ? "\n" : "\n\n";
    return { insert: gap + renamed.trimEnd() + "\n", name: free };
}
