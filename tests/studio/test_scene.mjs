// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A scene of squares, each with a material or a placement of its own.

import { deflateSync } from "node:zlib";

const crcTable = Array.from({ length: 256 }, (_, n) => {
    for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
    return n >>> 0;
});
const crc = (bytes) => (bytes.reduce((sum, byte) => crcTable[(sum ^ byte) & 255] ^ (sum >>> 8), 0xffffffff) ^ 0xffffffff) >>> 0;

function chunk(name, data) {
    const body = Buffer.concat([Buffer.from(name), data]);
    const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
    length.writeUInt32BE(data.length);
    sum.writeUInt32BE(crc(body));
    return Buffer.concat([length, body, sum]);
}

/** A PNG file of red, green, blue and alpha by a function of column and row. */
function png(width, height, pixel) {
    const head = Buffer.alloc(13);
    head.writeUInt32BE(width, 0);
    head.writeUInt32BE(height, 4);
    head.set([8, 6, 0, 0, 0], 8);
    const rows = [];
    for (let y = 0; y < height; ++y) {
        rows.push(0);
        for (let x = 0; x < width; ++x) rows.push(...pixel(x, y));
    }
    const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]);
    return Buffer.concat([signature, chunk("IHDR", head), chunk("IDAT", deflateSync(Buffer.from(rows))), chunk("IEND", Buffer.alloc(0))]);
}

// No two of its corners and borders are alike, so that one that is turned or mirrored is another one.
const colors = png(4, 3, (x, y) => [60 * x + 20, 110 * y + 10, x === 0 && y === 0 ? 255 : 40, 60 + 45 * ((x + y) % 4)]);
const normals = png(2, 2, (x, y) => [90 + 70 * x, 100 + 60 * y, 230, 255]);

const uri = (type, bytes) => `data:${type};base64,${bytes.toString("base64")}`;

/** The text of a glTF file. The square in a column from the left and a row from the top has its name. */
export function squares(name = "squares") {
    const base = { index: 0 };
    const repeated = (texture, scale = 1, offset = [0, 0]) => ({
        index: texture,
        extensions: { KHR_texture_transform: { scale: [scale, scale], offset, rotation: 0.2 } },
    });
    const plain = (factors, more = {}) => ({ pbrMetallicRoughness: factors, ...more });
    const materials = [
        plain({ baseColorTexture: base }, { name: "repeat" }),
        plain({ baseColorTexture: repeated(1, 2.5, [0.3, 0.1]) }, { name: "clamp" }),
        plain({ baseColorTexture: repeated(2, 2.5, [-0.4, 0.2]) }, { name: "mirror" }),
        plain({ baseColorTexture: repeated(3, 1.5) }, { name: "nearest" }),
        plain({ baseColorTexture: base }, { name: "mask", alphaMode: "MASK", alphaCutoff: 0.55 }),
        plain({ baseColorTexture: base, baseColorFactor: [1, 0.9, 0.8, 0.8] }, { name: "blend", alphaMode: "BLEND" }),
        plain({ baseColorFactor: [0.8, 0.8, 0.8, 1] }, { name: "bumps", normalTexture: { index: 4, scale: 1.4 } }),
        plain({ baseColorFactor: [0.2, 0.5, 0.9, 1] }, { name: "unlit", extensions: { KHR_materials_unlit: {} } }),
        plain({ baseColorFactor: [0.1, 0.1, 0.1, 1] }, { name: "emission", emissiveFactor: [1, 0.6, 0.3], emissiveTexture: base }),
        plain({ baseColorFactor: [0.9, 0.9, 0.9, 1] }, { name: "colours" }),
        plain({ baseColorTexture: { index: 0, texCoord: 1 } }, { name: "second set" }),
        plain({ baseColorTexture: base }, { name: "mirrored" }),
    ];
    const arrays = [
        [5126, "VEC3", [-0.9, -0.9, 0, 0.9, -0.9, 0, 0.9, 0.9, 0, -0.9, 0.9, 0]],
        [5126, "VEC3", [-0.5, -0.5, 1, 0.5, -0.5, 1, 0.5, 0.5, 1, -0.5, 0.5, 1].map((v, i, all) => v / Math.hypot(...all.slice(i - (i % 3), i - (i % 3) + 3)))],
        [5126, "VEC2", [0, 1, 1, 1, 1, 0, 0, 0]],
        [5126, "VEC2", [1, 0, 1, 1, 0, 1, 0, 0]],
        [5126, "VEC4", [1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1]],
        [5123, "SCALAR", [0, 1, 2, 0, 2, 3]],
    ];
    const parts = arrays.map(([type, , numbers]) => Buffer.from((type === 5126 ? Float32Array : Uint16Array).from(numbers).buffer));
    const begins = parts.map((_, i) => parts.slice(0, i).reduce((sum, part) => sum + part.length, 0));
    const attributes = { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2, TEXCOORD_1: 3 };
    const place = (i) => [2 * (i % 4) - 3, 2 - 2 * Math.floor(i / 4), -8 - 0.3 * i];
    return JSON.stringify({
        asset: { version: "2.0" },
        extensionsUsed: ["KHR_texture_transform", "KHR_materials_unlit"],
        scene: 0,
        scenes: [{ nodes: materials.map((_, i) => i) }],
        nodes: materials.map((material, i) => ({
            name: i === 0 ? name : material.name,
            mesh: i,
            translation: place(i),
            rotation: [0, Math.sin(0.1 * (i % 3)), 0, Math.cos(0.1 * (i % 3))],
            scale: material.name === "mirrored" ? [-1, 1, 1] : [1, 1, 1],
        })),
        meshes: materials.map((material, i) => ({
            primitives: [
                {
                    attributes: material.name === "colours" ? { ...attributes, COLOR_0: 4 } : attributes,
                    indices: 5,
                    material: i,
                },
            ],
        })),
        materials,
        textures: [
            { source: 0 },
            { source: 0, sampler: 0 },
            { source: 0, sampler: 1 },
            { source: 0, sampler: 2 },
            { source: 1 },
        ],
        samplers: [
            { wrapS: 33071, wrapT: 33071 },
            { wrapS: 33648, wrapT: 33648 },
            { magFilter: 9728, minFilter: 9728 },
        ],
        images: [{ uri: uri("image/png", colors) }, { uri: uri("image/png", normals) }],
        accessors: arrays.map(([componentType, type, numbers], i) => ({
            bufferView: i,
            componentType,
            type,
            count: numbers.length / { VEC4: 4, VEC3: 3, VEC2: 2, SCALAR: 1 }[type],
            ...(i === 0 ? { min: [-0.9, -0.9, 0], max: [0.9, 0.9, 0] } : {}),
        })),
        bufferViews: parts.map((part, i) => ({ buffer: 0, byteOffset: begins[i], byteLength: part.length })),
        buffers: [{ byteLength: Buffer.concat(parts).length, uri: uri("application/octet-stream", Buffer.concat(parts)) }],
    });
}
