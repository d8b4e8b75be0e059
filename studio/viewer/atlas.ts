// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The images of a scene in two arrays of sheets: a shader has too few samplers for one each.

import { DataArrayTexture, NearestFilter, NoColorSpace, RGBAFormat, SRGBColorSpace, UnsignedByteType } from "three";
import type { PageData, TextureUse } from "./page_data";

/** Where an image stands in an array, in pixels of a sheet. */
interface Place {
    x: number;
    y: number;
    sheet: number;
    width: number;
    height: number;
}

interface Picture {
    width: number;
    height: number;
    pixels: Uint8Array;
}

export interface Atlas {
    /** Colours, which the texture decodes. */
    colors: DataArrayTexture;
    /** Other numbers. */
    numbers: DataArrayTexture;
    /** Where the image of a use stands; null if there is none. */
    placeOf(use: TextureUse): Place | null;
}

/** Alpha is as it is in both arrays, so that it is taken from that of the colours. */
const isColor = (use: TextureUse): boolean => use.srgb || use.channel === 3;

/** Reads images pixel by pixel, as they are in the file: a canvas would multiply them by alpha. */
class PixelReader {
    private readonly gl = document.createElement("canvas").getContext("webgl2")!;

    async read(file: Blob, most: number): Promise<Picture> {
        const options: ImageBitmapOptions = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
        let image = await createImageBitmap(file, options);
        const scale = most / Math.max(image.width, image.height);
        if (scale < 1) {
            const resizeWidth = Math.max(1, Math.floor(image.width * scale));
            const resizeHeight = Math.max(1, Math.floor(image.height * scale));
            image = await createImageBitmap(image, { ...options, resizeWidth, resizeHeight, resizeQuality: "high" });
        }
        const { width, height } = image;
        const { gl } = this;
        const pixels = new Uint8Array(4 * width * height);
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, image);
        gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        gl.deleteTexture(texture);
        image.close();
        return { width, height, pixels };
    }

    close(): void {
        this.gl.getExtension("WEBGL_lose_context")?.loseContext();
    }
}

/** Pictures in rows from the top of a sheet, the highest ones first. */
function pack(pictures: Map<number, Picture>, color: boolean): [DataArrayTexture, Map<number, Place>] {
    const sides = [...pictures.values()].flatMap(({ width, height }) => [width, height]);
    const side = 2 ** Math.ceil(Math.log2(Math.max(4, ...sides)));
    const places = new Map<number, Place>();
    const order = [...pictures].sort(([, a], [, b]) => b.height - a.height);
    let [x, y, rowHeight, sheet] = [0, 0, 0, 0];
    for (const [index, { width, height }] of order) {
        if (x + width > side) [x, y, rowHeight] = [0, y + rowHeight, 0];
        if (y + height > side) [x, y, rowHeight, sheet] = [0, 0, 0, sheet + 1];
        places.set(index, { x, y, sheet, width, height });
        x += width;
        rowHeight = Math.max(rowHeight, height);
    }
    const pixels = new Uint8Array(4 * side * side * (sheet + 1));
    for (const [index, picture] of pictures) {
        const place = places.get(index)!;
        for (let line = 0; line < picture.height; ++line) {
            const from = 4 * line * picture.width;
            const to = 4 * ((place.sheet * side + place.y + line) * side + place.x);
            pixels.set(picture.pixels.subarray(from, from + 4 * picture.width), to);
        }
    }
    const texture = new DataArrayTexture(pixels, side, side, sheet + 1);
    texture.format = RGBAFormat;
    texture.type = UnsignedByteType;
    texture.colorSpace = color ? SRGBColorSpace : NoColorSpace;
    texture.minFilter = texture.magFilter = NearestFilter;
    texture.needsUpdate = true;
    return [texture, places];
}

const usesOf = (data: PageData): TextureUse[] =>
    data.materials
        .flatMap((material) => [
            material.baseColorTexture,
            material.opacityTexture,
            material.emissionTexture,
            material.normalTexture,
        ])
        .filter((use) => use !== null);

/** `most` is the longest side of an image in pixels. */
export async function makeAtlas(data: PageData, bytes: ArrayBuffer, most: number): Promise<Atlas> {
    const reader = new PixelReader();
    const pictures = await Promise.all(
        data.textures.map((image) =>
            image ? reader.read(new Blob([new Uint8Array(bytes, image.begin, image.size)], { type: image.type }), most) : null,
        ),
    );
    reader.close();
    const wanted = (color: boolean): Map<number, Picture> => {
        const chosen = usesOf(data).filter((use) => isColor(use) === color);
        const indices = [...new Set(chosen.map(({ texture }) => texture))].sort((a, b) => a - b);
        return new Map(indices.flatMap((index) => (pictures[index] ? [[index, pictures[index]!]] : [])));
    };
    const [colors, placesOfColors] = pack(wanted(true), true);
    const [numbers, placesOfNumbers] = pack(wanted(false), false);
    return {
        colors,
        numbers,
        placeOf: (use) => (isColor(use) ? placesOfColors : placesOfNumbers).get(use.texture) ?? null,
    };
}

const wraps = ["repeat", "clamp", "mirror"];

/** How many texels a material has: three, and four for each use of a texture. */
export const materialSize = 19;

/** Materials as numbers for the shader, four a texel, in the order in which it reads them. */
export function materialTable(data: PageData, atlas: Atlas): Float32Array {
    const modes = ["opaque", "mask", "blend"];
    const table: number[] = [];
    const addUse = (use: TextureUse | null) => {
        const place = use ? atlas.placeOf(use) : null;
        if (!use || !place) {
            table.push(...new Array<number>(12).fill(0));
            return;
        }
        const { wrap, interpolated } = data.textures[use.texture]!;
        const flags = 1 + (isColor(use) ? 2 : 0) + (interpolated ? 4 : 0) + 8 * use.coordinates;
        const wrapped = wraps.indexOf(wrap[0]) + 4 * wraps.indexOf(wrap[1]);
        table.push(flags, wrapped, use.channel, place.sheet);
        table.push(place.x, place.y, place.width, place.height);
        table.push(use.offset[0], use.offset[1], 0, 0);
    };
    const addAxes = (use: TextureUse | null) => table.push(...(use ? [...use.u, ...use.v] : [1, 0, 0, 1]));
    for (const material of data.materials) {
        table.push(...material.baseColor, modes.indexOf(material.alphaMode));
        table.push(...material.emission, material.alpha);
        table.push(material.cutoff, material.normalScale, material.unlit ? 1 : 0, 0);
        for (const use of [
            material.baseColorTexture,
            material.opacityTexture,
            material.emissionTexture,
            material.normalTexture,
        ]) {
            addUse(use);
            addAxes(use);
        }
    }
    return new Float32Array(table);
}
