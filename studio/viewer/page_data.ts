// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a page has: src/page writes it.

import type { Parameter } from "../src/protocol";

/** The use of an image by a material. `texture` is an index; at (u, v) of a set of coordinates, the place in
 *  the image is offset + u * `u` + v * `v`. */
export interface TextureUse {
    texture: number;
    srgb: boolean;
    coordinates: number;
    channel: number;
    offset: [number, number];
    u: [number, number];
    v: [number, number];
}

export interface Material {
    baseColor: [number, number, number];
    baseColorTexture: TextureUse | null;
    alphaMode: "opaque" | "mask" | "blend";
    alpha: number;
    cutoff: number;
    opacityTexture: TextureUse | null;
    emission: [number, number, number];
    emissionTexture: TextureUse | null;
    normalScale: number;
    normalTexture: TextureUse | null;
    unlit: boolean;
}

/** Members of arrays are where they begin in the bytes of the page. */
export interface Mesh {
    vertices: number;
    triangles: number;
    material: number;
    positions: number;
    normals?: number;
    coordinates: (number | null)[];
    colors?: number;
    corners: number;
}

export interface Instance {
    mesh: number;
    /** The images of the axes x, y and z, and the translation. */
    place: number[];
}

export type Wrap = "repeat" | "clamp" | "mirror";

export interface PageImage {
    begin: number;
    size: number;
    type: string;
    wrap: [Wrap, Wrap];
    interpolated: boolean;
}

export interface PageData {
    title: string;
    version: string;
    /** Of the picture in pixels, where the window has room. */
    size: [number, number];
    time: number;
    hasTime: boolean;
    hasLens: boolean;
    /** In stops. */
    exposure: number;
    /** Linear; null if the picture is transparent where there is nothing. */
    background: [number, number, number] | null;
    /** The functions of the picture. */
    shader: string;
    tables: { begin: number; count: number };
    parameters: Parameter[];
    meshes: Mesh[];
    instances: Instance[];
    materials: Material[];
    textures: (PageImage | null)[];
}

const contentOf = (id: string): string => document.getElementById(id)?.textContent ?? "";

export const readData = (): PageData => JSON.parse(contentOf("data")) as PageData;

/** The bytes of the page. A part is decoded at a time, so that no text is held twice as a whole. */
export function readBytes(): ArrayBuffer {
    const text = contentOf("bytes");
    document.getElementById("bytes")?.remove();
    const padding = text.endsWith("==") ? 2 : text.endsWith("=") ? 1 : 0;
    const bytes = new Uint8Array((text.length / 4) * 3 - padding);
    const part = 1 << 20; // A multiple of four letters.
    for (let at = 0; at < text.length; at += part) {
        const letters = atob(text.slice(at, at + part));
        const begin = (at / 4) * 3;
        for (let i = 0; i < letters.length; ++i) bytes[begin + i] = letters.charCodeAt(i);
    }
    return bytes.buffer;
}
