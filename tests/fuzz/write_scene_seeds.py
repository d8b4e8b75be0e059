#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Usage: write_scene_seeds.py FOLDER

Writes small scenes and images of the formats that are read, for tests/fuzz/scene_fuzzer.cpp to
start from.
"""

import base64
import json
import math
import pathlib
import struct
import sys
import zlib


def floats(*values):
    return struct.pack(f"<{len(values)}f", *values)


def shorts(*values):
    return struct.pack(f"<{len(values)}H", *values)


def png(interlaced=False):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    # Adam7 needs passes of its own; the seed has one pixel then.
    side = 1 if interlaced else 3
    header = struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, interlaced)
    rows = b"".join(b"\0" + bytes(range(9 * y, 9 * y + 3 * side)) for y in range(side))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) +
            chunk(b"IEND", b""))


def bmp():
    pixels = bytes(range(2 * 8))
    return (b"BM" + struct.pack("<IHHI", 54 + len(pixels), 0, 0, 54) +
            struct.pack("<IiiHHIIiiII", 40, 2, 2, 1, 24, 0, len(pixels), 0, 0, 0, 0) + pixels)


def tga():
    return struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, 2, 2, 24, 0) + bytes(range(12))


def hdr():
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n" + bytes(range(100, 116))


def tiff():
    entries = [(256, 2), (257, 2), (258, 8), (259, 1), (262, 1), (273, 8), (277, 1), (278, 2),
               (279, 4)]
    directory = struct.pack("<H", len(entries)) + b"".join(
        struct.pack("<HHII", tag, 4, 1, value) for tag, value in entries) + bytes(4)
    return b"II*\0" + struct.pack("<I", 12) + bytes((10, 20, 30, 40)) + directory


def exr(values):
    """2 x 2 pixels without compression; values has the float of each channel, the second column is 1."""

    def attribute(name, kind, data):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(data)) + data

    box = struct.pack("<4i", 0, 0, 1, 1)
    header = b"\x76\x2f\x31\x01" + struct.pack("<I", 2) + b"".join((
        attribute(b"channels", b"chlist", b"".join(
            name.encode() + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1)
            for name in sorted(values)) + b"\0"),
        attribute(b"compression", b"compression", b"\0"),
        attribute(b"dataWindow", b"box2i", box), attribute(b"displayWindow", b"box2i", box),
        attribute(b"lineOrder", b"lineOrder", b"\0"),
        attribute(b"pixelAspectRatio", b"float", floats(1)),
        attribute(b"screenWindowCenter", b"v2f", floats(0, 0)),
        attribute(b"screenWindowWidth", b"float", floats(1)))) + b"\0"
    row = b"".join(floats(values[name], 1) for name in sorted(values))
    rows = [struct.pack("<iI", y, len(row)) + row for y in range(2)]
    first = len(header) + 2 * 8
    return header + struct.pack("<2Q", first, first + len(rows[0])) + b"".join(rows)


class Scene:
    """A glTF document with its one buffer."""

    def __init__(self):
        self.buffer = b""
        self.views = []
        self.accessors = []

    def view(self, data):
        self.buffer += bytes(-len(self.buffer) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.buffer), "byteLength": len(data)})
        self.buffer += data
        return len(self.views) - 1

    def accessor(self, data, kind, component, count, **more):
        self.accessors.append({"bufferView": self.view(data), "componentType": component,
                               "count": count, "type": kind, **more})
        return len(self.accessors) - 1

    def document(self):
        positions = self.accessor(floats(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0), "VEC3", 5126, 4)
        normals = self.accessor(floats(*4 * (0, 0, 1)), "VEC3", 5126, 4)
        tangents = self.accessor(floats(*4 * (1, 0, 0, -1)), "VEC4", 5126, 4)
        points = self.accessor(shorts(0, 0, 65535, 0, 65535, 65535, 0, 65535), "VEC2", 5123, 4,
                               normalized=True)
        indices = self.accessor(shorts(0, 1, 2, 0, 2, 3), "SCALAR", 5123, 6)
        sparse = {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {
            "count": 2,
            "indices": {"bufferView": self.view(shorts(1, 2)), "componentType": 5123},
            "values": {"bufferView": self.view(floats(1, 0, 0, 0, 1, 0))}}}
        self.accessors.append(sparse)
        image = self.view(png())
        texture = {"index": 0, "extensions": {"KHR_texture_transform": {
            "offset": [0.1, 0], "scale": [0.5, 2], "rotation": 0.5}}}
        return {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 3]}],
            "nodes": [
                {"name": "a", "mesh": 0, "children": [1, 2], "rotation": [0, 0.7071, 0, 0.7071]},
                {"name": "b", "mesh": 1, "scale": [1, -2, 3], "translation": [1, 2, 3]},
                {"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1]},
                {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
            "meshes": [
                {"name": "m", "primitives": [{"indices": indices, "material": 0, "attributes": {
                    "POSITION": positions, "NORMAL": normals, "TEXCOORD_0": points,
                    "TEXCOORD_1": points, "TANGENT": tangents, "COLOR_0": tangents}}]},
                {"primitives": [{"mode": 5, "attributes": {"POSITION": positions}},
                                {"mode": 6, "attributes": {"POSITION": len(self.accessors) - 1}}]}],
            "materials": [{
                "pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 1, 0.5],
                                         "baseColorTexture": texture, "metallicFactor": 0.5},
                "emissiveTexture": {"index": 1}, "emissiveFactor": [1, 0.5, 0],
                "normalTexture": {"index": 1, "texCoord": 1, "scale": -0.5},
                "alphaMode": "MASK", "alphaCutoff": 0.5,
                "extensions": {
                    "KHR_materials_clearcoat": {
                        "clearcoatFactor": 1, "clearcoatTexture": {"index": 0},
                        "clearcoatRoughnessFactor": 0.5},
                    "KHR_materials_emissive_strength": {"emissiveStrength": 8},
                    "KHR_materials_ior": {"ior": 1.3},
                    "KHR_materials_sheen": {
                        "sheenColorFactor": [1, 0.5, 0], "sheenRoughnessTexture": {"index": 1}},
                    "KHR_materials_specular": {
                        "specularFactor": 0.5, "specularColorFactor": [2, 1, 0]},
                    "KHR_materials_transmission": {
                        "transmissionFactor": 0.5, "transmissionTexture": texture},
                    "KHR_materials_unlit": {},
                    "KHR_materials_volume": {
                        "thicknessFactor": 1, "attenuationDistance": 0.5,
                        "attenuationColor": [1, 0.5, 0]}}}],
            "textures": [{"source": 0, "sampler": 0}, {"source": 1}],
            "samplers": [{"wrapS": 33071, "wrapT": 33648}],
            "images": [{"bufferView": image}, {
                "uri": "data:image/png;base64," + base64.b64encode(png(True)).decode()}],
            "accessors": self.accessors, "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.buffer)}],
            "extensions": {"KHR_lights_punctual": {"lights": [
                {"type": "spot", "intensity": 40, "range": 7, "color": [1, 0.5, 0.25],
                 "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.4}}]}}}


def glb(document, buffer):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    buffer += bytes(-len(buffer) % 4)
    body = (struct.pack("<I", len(text)) + b"JSON" + text +
            struct.pack("<I", len(buffer)) + b"BIN\0" + buffer)
    return b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body


OBJ = b"""mtllib m.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vn 0 0 1
o one
usemtl red
f 1/1/1 2/2/1 3/3/1 4/3/1
g two
usemtl blue
s 1
f -4//1 -3//1 -2//1
s off
v 2 2 0 1 0.5 0
f 1 2 3 5 4
f 1 2 \\
4
#mtl
newmtl red
Kd 1 0 0
Ks 0.5 0.5 0.5
Ns 20
illum 3
map_Kd -clamp on -o 0.5 -s 1 1 1 t.png
map_d -imfchan m t.png
norm -bm 0.5 t.png
newmtl blue
Ke 0 0 3
Tf 1 0.5 0
Ni 1.3
illum 7
d 0.5
Pr 0.2
Pm 1
Pc 1
Pcr 0.5
Ps 0.5
map_Pr t.png
bump t.png
"""


PLY_HEADER = """element vertex 4
property float x
property float y
property float z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
element face 2
property list uchar int vertex_indices
element tristrips 1
property list int int vertex_indices
end_header
"""


def ply(order):
    """A PLY file; the order of its bytes is that of struct, or None for text."""
    vertices = [(x, y, 0, 0, 0, 1, 9, 99, 255) for x in (0, 1) for y in (0, 1)]
    rows = [("6f3B", vertex) for vertex in vertices]
    rows += [("B3i", (3, 0, 1, 2)), ("B4i", (4, 0, 1, 3, 2)), ("6i", (5, 0, 1, 2, -1, 3))]
    name = {None: "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}[order]
    body = b"".join(struct.pack(order + kind, *row) if order else
                    " ".join(map(str, row)).encode() + b"\n" for kind, row in rows)
    return f"ply\nformat {name} 1.0\n{PLY_HEADER}".encode() + body


def stl():
    triangle = floats(*3 * (0,), 0, 0, 0, 1, 0, 0, 0, 1, 0) + shorts(0)
    return bytes(80) + struct.pack("<I", 2) + 2 * triangle


STL = b"""solid one
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid one
"""


def main():
    folder = pathlib.Path(sys.argv[1])
    scene = Scene()
    document = scene.document()
    (folder / "scene.glb").write_bytes(glb(document, scene.buffer))
    document["buffers"][0]["uri"] = ("data:application/octet-stream;base64," +
                                     base64.b64encode(scene.buffer).decode())
    (folder / "scene.gltf").write_text(json.dumps(document))
    (folder / "scene.obj").write_bytes(OBJ)
    for name, order in (("text", None), ("little", "<"), ("big", ">")):
        (folder / f"{name}.ply").write_bytes(ply(order))
    (folder / "text.stl").write_bytes(b"stl:" + STL)
    (folder / "binary.stl").write_bytes(b"stl:" + stl())
    for name, image in (("png", png()), ("bmp", bmp()), ("tga", b"tga:" + tga()), ("hdr", hdr()),
                        ("tiff", tiff()), ("exr", exr({"Y": 0.5})), ("nan.exr", exr({"Y": math.nan}))):
        (folder / f"image.{name}").write_bytes(image)


if __name__ == "__main__":
    main()
