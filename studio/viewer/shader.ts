// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The fragment shaders: the light that a sample of the picture sees, sums of samples, and their display.

import { BVHShaderGLSL } from "three-mesh-bvh";
import { materialSize } from "./atlas";
import type { PageData } from "./page_data";
import type { Triangles } from "./triangles";

/** Of the tree of triangles, which the shader's stack holds. */
export const treeDepth = 60;

const precision = `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp isampler2D;
precision highp usampler2D;
precision highp sampler2DArray;
`;

/** A triangle that covers the picture. */
export const vertexShader = `
in vec3 position;
void main() { gl_Position = vec4(position, 1.0); }
`;

// The formulas are those of the renderer's preview: src/render/integrators/preview.cpp, ray_tree.cpp,
// src/shading/surfaces/surface.inl and textures/texture_look_up.inl.
const surfaces = `
uniform BVH triangles;
uniform sampler2D normals;
uniform sampler2D coordinates;
uniform sampler2D colors;
uniform sampler2D materials;
uniform sampler2DArray color_images;
uniform sampler2DArray number_images;

vec4 material_texel(int material, int member) {
    return texelFetch1D(materials, uint(material * ${materialSize} + member));
}

float wrapped(float position, int wrap) {
    if (wrap == 1) return clamp(position, 0.0, 1.0);
    if (wrap == 0) return position - floor(position);
    float in_period = position - 2.0 * floor(0.5 * position);
    return in_period > 1.0 ? 2.0 - in_period : in_period;
}

// Two neighbouring texels, and the weight of the second one.
void texels_around(float position, int count, int wrap, out ivec2 texels, out float weight) {
    float x = wrapped(position, wrap) * float(count) - 0.5;
    int last = count - 1;
    int below = clamp(int(floor(x)), -1, last);
    bool repeats = wrap == 0;
    texels = ivec2(below < 0 ? (repeats ? last : 0) : below, below < last ? below + 1 : (repeats ? 0 : last));
    weight = x - floor(x);
}

vec4 texel(bool is_color, ivec3 at) {
    return is_color ? texelFetch(color_images, at, 0) : texelFetch(number_images, at, 0);
}

// A use of an image, from a member of a material on: its flags, wraps, channel and sheet; its corner and
// size on the sheet; its offset; its axes.
vec4 image_at(int material, int member, vec4 uv, out int channel) {
    vec4 head = material_texel(material, member);
    int flags = int(head.x);
    channel = int(head.z);
    if (flags == 0) return vec4(1.0);
    vec4 place = material_texel(material, member + 1);
    vec2 offset = material_texel(material, member + 2).xy;
    vec4 axes = material_texel(material, member + 3);
    vec2 own = flags >= 8 ? uv.zw : uv.xy;
    vec2 at = offset + own.x * axes.xy + own.y * axes.zw;
    ivec2 x, y;
    vec2 weight;
    texels_around(at.x, int(place.z), int(head.y) & 3, x, weight.x);
    texels_around(at.y, int(place.w), int(head.y) >> 2, y, weight.y);
    if ((flags & 4) == 0) weight = step(0.5, weight);
    bool is_color = (flags & 2) != 0;
    int sheet = int(head.w);
    ivec2 corner = ivec2(place.xy);
    vec4 above = mix(texel(is_color, ivec3(corner + ivec2(x[0], y[0]), sheet)),
                     texel(is_color, ivec3(corner + ivec2(x[1], y[0]), sheet)), weight.x);
    vec4 below = mix(texel(is_color, ivec3(corner + ivec2(x[0], y[1]), sheet)),
                     texel(is_color, ivec3(corner + ivec2(x[1], y[1]), sheet)), weight.x);
    return mix(above, below, weight.y);
}

vec3 bent_to_viewer(vec3 normal, vec3 to_viewer) {
    float cosine = dot(normal, to_viewer);
    return cosine >= 1e-3 ? normal : normalize(normal + (1e-3 - cosine) * to_viewer);
}

float side_to_viewer(vec3 normal, vec3 flat_normal, vec3 to_viewer) {
    float above = dot(flat_normal, normal);
    return (dot(flat_normal, to_viewer) < 0.0 ? -above : above) < 0.0 ? -1.0 : 1.0;
}

#ifdef HAS_COORDINATES
// The normal of the map, whose tangents are those of the texture coordinates.
vec3 mapped_normal(int material, vec4 uv, uvec3 corners, vec3 edge_1, vec3 edge_2, vec3 smooth_normal,
                   vec3 flat_normal, vec3 to_viewer) {
    const int member = 15;
    vec4 head = material_texel(material, member);
    if (int(head.x) == 0) return smooth_normal;
    int channel;
    vec3 texel = image_at(material, member, uv, channel).xyz;
    vec3 inside = 2.0 * texel - 1.0;
    inside.xy *= material_texel(material, 2).y;
    bool second = int(head.x) >= 8;
    vec4 axes = material_texel(material, member + 3);
    vec2 at[3];
    for (int i = 0; i < 3; ++i) {
        vec4 both = texelFetch1D(coordinates, corners[i]);
        vec2 own = second ? both.zw : both.xy;
        at[i] = own.x * axes.xy + own.y * axes.zw;
    }
    vec2 along_1 = at[1] - at[0];
    vec2 along_2 = at[2] - at[0];
    float area = along_1.x * along_2.y - along_1.y * along_2.x;
    vec3 right = (along_2.y * edge_1 - along_1.y * edge_2) / area;
    vec3 down = (along_1.x * edge_2 - along_2.x * edge_1) / area;
    float handedness = dot(cross(smooth_normal, right), down) > 0.0 ? -1.0 : 1.0;
    right = normalize(right - dot(right, smooth_normal) * smooth_normal);
    vec3 up = handedness * cross(smooth_normal, right);
    vec3 mapped = normalize(inside.x * right + inside.y * up + inside.z * smooth_normal);
    // Without coordinates there is no tangent; nothing is mapped then.
    return dot(mapped, mapped) > 0.5 ? mapped : smooth_normal;
}
#endif

// What a ray sees, premultiplied. A material of parts of a surface lets the ray go on.
vec4 seen_by(vec3 origin, vec3 direction) {
    const int most_crossings = 16;
    vec4 seen = vec4(0.0);
    float weight = 1.0;
    for (int crossing = 0; crossing <= most_crossings && weight > 0.0; ++crossing) {
        uvec4 corners = uvec4(0u);
        vec3 facing, shares;
        float side, far;
        if (!bvhIntersectFirstHit(triangles, origin, direction, corners, facing, shares, side, far)) break;
        vec3 a = texelFetch1D(triangles.position, corners.x).xyz;
        vec3 edge_1 = texelFetch1D(triangles.position, corners.y).xyz - a;
        vec3 edge_2 = texelFetch1D(triangles.position, corners.z).xyz - a;
        vec3 point = a + shares.y * edge_1 + shares.z * edge_2;
        vec3 outside = normalize(cross(edge_1, edge_2));
        vec3 to_viewer = -direction;
        vec4 first = texelFetch1D(normals, corners.x);
        int material = int(first.w);
        vec3 sum = shares.x * first.xyz + shares.y * texelFetch1D(normals, corners.y).xyz +
                   shares.z * texelFetch1D(normals, corners.z).xyz;
        vec3 mesh_normal = dot(sum, sum) > 0.0 ? normalize(sum) : outside;
        vec4 uv = vec4(0.0);
        vec3 own_normal = mesh_normal;
#ifdef HAS_COORDINATES
        uv = textureSampleBarycoord(coordinates, shares, corners.xyz);
        own_normal = mapped_normal(material, uv, corners.xyz, edge_1, edge_2, mesh_normal, outside, to_viewer);
#endif
        vec3 normal = bent_to_viewer(side_to_viewer(mesh_normal, outside, to_viewer) * own_normal, to_viewer);

        vec4 base = material_texel(material, 0);
        vec4 emission = material_texel(material, 1);
        vec4 other = material_texel(material, 2);
        int channel;
        vec3 color = base.rgb * image_at(material, 3, uv, channel).rgb;
        vec4 opacities = image_at(material, 7, uv, channel);
        float alpha = emission.a * opacities[channel];
        vec3 emitted = emission.rgb * image_at(material, 11, uv, channel).rgb;
#ifdef HAS_COLORS
        vec4 by_vertex = textureSampleBarycoord(colors, shares, corners.xyz);
        color *= by_vertex.rgb;
        alpha *= by_vertex.a;
#endif
        alpha = clamp(alpha, 0.0, 1.0);
        int mode = int(base.a);
        float opacity = mode == 0 ? 1.0 : mode == 1 ? (alpha >= other.x ? 1.0 : 0.0) : alpha;
        opacity = crossing < most_crossings ? opacity : 1.0;
        vec3 shaded = other.z != 0.0 ? color : emitted + abs(dot(normal, direction)) * color;
        seen += weight * opacity * vec4(shaded, 1.0);
        weight *= 1.0 - opacity;

        // Eight rounding errors of the largest number that the point is computed from, and beyond what a ray
        // still meets behind its origin.
        vec3 largest = max(max(abs(a), abs(a + edge_1)), max(abs(a + edge_2), max(abs(edge_1), abs(edge_2))));
        float offset = max(8.0 * 1.1920929e-7 * max(largest.x, max(largest.y, largest.z)), 2.0 * TRI_INTERSECT_EPSILON);
        origin = point + (dot(direction, outside) >= 0.0 ? offset : -offset) * outside;
    }
    return seen;
}
`;

const sample = `
uniform vec2 target_size;   // Of what is drawn, in pixels.
uniform vec2 picture_size;  // That the formulas are made for, in pixels.
uniform vec2 offset;        // Of the sample, from the middle of a pixel.
uniform float time;
uniform uint number;        // Of the sample; the first one is that of the middle of a lens.
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 display;

// A number from 0 to 1 by pixel, sample and dimension: the hash of PCG, Jarzynski and Olano 2020.
float random(uvec2 pixel, uint dimension) {
    uvec3 v = uvec3(pixel, 2u * number + dimension) * 1664525u + 1013904223u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    return float(v.x >> 8u) / 16777216.0;
}

void main() {
    vec2 at = clamp(gl_FragCoord.xy + offset, vec2(0.0), target_size);
    at = vec2(at.x, target_size.y - at.y) / target_size * picture_size;
    vec2 lens = vec2(0.0);
#ifdef HAS_LENS
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    if (number > 0u) lens = 2.0 * vec2(random(pixel, 0u), random(pixel, 1u)) - 1.0;
#endif
    picture_rays(at.x, at.y, time, lens.x, lens.y);
    for (int i = 0; i < picture_layers; ++i) {
        picture_seen[i] = PictureColor(vec4(0.0), vec4(0.0), 0.0);
        PictureLayer layer = picture_layer[i];
        if (layer.ray < 0.0) {
            picture_seen[i] = PictureColor(vec4(0.0, 0.0, 0.0, 1.0), vec4(0.0), 1.0);
        } else if (layer.ray > 0.0 && layer.share > 0.0) {
            picture_seen[i] = PictureColor(seen_by(layer.origin, layer.direction), vec4(0.0), 1.0);
        }
    }
    PictureColor color = picture_color();
    light = color.light;
    display = color.display;
}
`;

export function sampleShader(data: PageData, triangles: Triangles): string {
    const defines = [
        triangles.coordinates ? "#define HAS_COORDINATES" : "",
        triangles.colors ? "#define HAS_COLORS" : "",
        data.hasLens ? "#define HAS_LENS" : "",
    ];
    return [
        precision,
        defines.join("\n"),
        `#define TRI_INTERSECT_EPSILON 1e-6\n#define BVH_STACK_DEPTH ${treeDepth + 4}`,
        BVHShaderGLSL.common_functions,
        BVHShaderGLSL.bvh_struct_definitions,
        BVHShaderGLSL.bvh_ray_functions,
        "uniform sampler2D table_numbers;",
        "float picture_number(int at) { return texelFetch1D(table_numbers, uint(at)).x; }",
        data.shader,
        surfaces,
        sample,
    ].join("\n");
}

/** Copies one picture to another, which may add it to what is there. */
export const copyShader = `${precision}
uniform sampler2D light_of;
uniform sampler2D display_of;
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 display;
void main() {
    light = texelFetch(light_of, ivec2(gl_FragCoord.xy), 0);
    display = texelFetch(display_of, ivec2(gl_FragCoord.xy), 0);
}
`;

// Light after exposure and the renderer's neutral view, under display colours, over the background
// (src/film/display).
export const displayShader = `${precision}
uniform sampler2D light_of;
uniform sampler2D display_of;
uniform vec2 screen_size;
uniform vec2 used;         // The part of the pictures that is used, in pixels.
uniform float samples;
uniform float gain;
uniform vec4 background;   // Linear; alpha is 0 if there is none.
out vec4 color;

vec3 neutral(vec3 light) {
    float peak = max(light.r, max(light.g, light.b));
    if (peak <= 0.8) return light;
    float compressed = 1.0 - 0.04 / (peak - 0.6);
    float saturation = 1.0 / (0.15 * (peak - compressed) + 1.0);
    return saturation * (compressed / peak) * light + (1.0 - saturation) * compressed;
}

float srgb(float value) { return value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1.0 / 2.4) - 0.055; }

void main() {
    ivec2 at = min(ivec2(gl_FragCoord.xy / screen_size * used), ivec2(used) - 1);
    vec4 light = texelFetch(light_of, at, 0) / samples;
    vec4 display = texelFetch(display_of, at, 0) / samples;
    vec4 shown = display;
    if (light.a > 0.0) shown += vec4(light.a * neutral(gain / light.a * light.rgb), light.a);
    shown += (1.0 - clamp(shown.a, 0.0, 1.0)) * background;
    float alpha = clamp(shown.a, 0.0, 1.0);
    vec3 straight = alpha > 0.0 ? clamp(shown.rgb / alpha, 0.0, 1.0) : vec3(0.0);
    color = vec4(alpha * vec3(srgb(straight.r), srgb(straight.g), srgb(straight.b)), alpha);
}
`;
