// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The picture of a binary message.

import type { FrameHead } from "./protocol";

const types = { jpeg: "image/jpeg", png: "image/png" };

export async function bitmapOf(head: FrameHead, bytes: Uint8Array): Promise<ImageBitmap> {
    if (head.format !== "rgb") {
        return createImageBitmap(new Blob([bytes as Uint8Array<ArrayBuffer>], { type: types[head.format] }));
    }
    const pixels = new Uint8ClampedArray(4 * head.width * head.height).fill(255);
    for (let i = 0, from = 0; i < pixels.length; i += 4, from += 3) {
        pixels[i] = bytes[from]!;
        pixels[i + 1] = bytes[from + 1]!;
        pixels[i + 2] = bytes[from + 2]!;
    }
    return createImageBitmap(new ImageData(pixels, head.width, head.height));
}
