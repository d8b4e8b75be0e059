// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/surfaces/surface_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <bit>

#include "shading/surfaces/surface_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::surface_lanes::HWY_NAMESPACE {

namespace lanes = hwy::HWY_NAMESPACE;

using embree::Packet;

using Tag = lanes::CappedTag<float, Packet::size>;
using IntegerTag = lanes::RebindToSigned<Tag>;
using UnsignedTag = lanes::RebindToUnsigned<Tag>;
using Vector = lanes::Vec<Tag>;
using Integers = lanes::Vec<IntegerTag>;
using Mask = lanes::Mask<Tag>;
constexpr Tag tag;
constexpr IntegerTag integers;
constexpr UnsignedTag numbers;

HWY_INLINE Vector number(float value) { return lanes::Set(tag, value); }
HWY_INLINE Vector sum(Vector a, Vector b) { return lanes::Add(a, b); }
HWY_INLINE Vector difference(Vector a, Vector b) { return lanes::Sub(a, b); }
HWY_INLINE Vector product(Vector a, Vector b) { return lanes::Mul(a, b); }

struct Vector3 {
    Vector x, y, z;
};

HWY_INLINE Vector3 difference(const Vector3& a, const Vector3& b) {
    return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}
HWY_INLINE Vector3 sum(const Vector3& a, const Vector3& b) {
    return {sum(a.x, b.x), sum(a.y, b.y), sum(a.z, b.z)};
}
HWY_INLINE Vector3 product(Vector a, const Vector3& b) {
    return {product(a, b.x), product(a, b.y), product(a, b.z)};
}
HWY_INLINE Vector dot(const Vector3& a, const Vector3& b) {
    return sum(sum(product(a.x, b.x), product(a.y, b.y)), product(a.z, b.z));
}
HWY_INLINE Vector3 cross(const Vector3& a, const Vector3& b) {
    return {difference(product(a.y, b.z), product(a.z, b.y)),
            difference(product(a.z, b.x), product(a.x, b.z)),
            difference(product(a.x, b.y), product(a.y, b.x))};
}
HWY_INLINE Vector3 placed(const Vector3& v, const Imath::M33f& m) {
    const auto component = [&](int j) {
        return sum(sum(product(v.x, number(m[0][j])), product(v.y, number(m[1][j]))),
                   product(v.z, number(m[2][j])));
    };
    return {component(0), component(1), component(2)};
}

HWY_INLINE Vector load(const Packet::Floats& values, std::size_t lane) {
    return lanes::Load(tag, values.data() + lane);
}
HWY_INLINE Vector3 load(const Packet::Floats& x, const Packet::Floats& y, const Packet::Floats& z,
                        std::size_t lane) {
    return {load(x, lane), load(y, lane), load(z, lane)};
}
HWY_INLINE Vector3 load(const packet_lanes::Differentials::Vectors& v, std::size_t lane) {
    return load(v[0], v[1], v[2], lane);
}
HWY_INLINE void store(Mask where, Vector value, Packet::Floats& values, std::size_t lane) {
    lanes::Store(lanes::IfThenElse(where, value, load(values, lane)), tag, values.data() + lane);
}

// The lanes from `lane` on.
HWY_INLINE Mask mask_of(LaneBits bits, std::size_t lane) {
    const std::uint32_t rest = bits >> lane;
    const std::uint8_t bytes[8]{static_cast<std::uint8_t>(rest),
                                static_cast<std::uint8_t>(rest >> 8U)};
    return lanes::LoadMaskBits(tag, bytes);
}

template <class AnyMask, class AnyTag>
HWY_INLINE LaneBits bits_of(AnyTag any, AnyMask mask, std::size_t lane) {
    std::uint8_t bytes[8]{};
    lanes::StoreMaskBits(any, mask, bytes);
    return (std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8U) << lane;
}

void find_groups(const Packet& packet, Groups& groups) {
    alignas(64) Packet::Numbers instances;
    LaneBits rest = 0;
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const auto nothing = lanes::Set(numbers, embree::Hit::nothing);
        const auto geometry = lanes::Load(numbers, packet.geometry.data() + lane);
        const auto placement = lanes::Load(numbers, packet.placement.data() + lane);
        lanes::Store(lanes::IfThenElse(lanes::Eq(placement, nothing), geometry, placement), numbers,
                     instances.data() + lane);
        rest |= bits_of(numbers, lanes::Ne(geometry, nothing), lane);
    }
    groups.clear();
    while (rest != 0) {
        const std::uint32_t instance = instances[static_cast<std::size_t>(std::countr_zero(rest))];
        LaneBits same = 0;
        for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
            same |= bits_of(numbers,
                            lanes::Eq(lanes::Load(numbers, instances.data() + lane),
                                      lanes::Set(numbers, instance)),
                            lane);
        }
        groups.add({instance, same & rest});
        rest &= ~same;
    }
}

// The values of a vertex array, for a corner of the triangle that each lane hits. Most packets hit
// one triangle, whose values need not be gathered.
struct OneTriangle {
    const std::array<std::uint32_t, 3>& corners;

    template <std::size_t dimensions>
    HWY_INLINE Vector operator()(const float* values, std::size_t corner,
                                 std::size_t component) const {
        return number(values[corners[corner] * dimensions + component]);
    }
};

struct Triangles {
    Triangles(const scene::Mesh& mesh, Integers triangle) {
        const auto* const all =
            reinterpret_cast<const std::int32_t*>(mesh.triangles.front().data());
        const Integers first = lanes::Mul(triangle, lanes::Set(integers, 3));
        for (int k = 0; k < 3; ++k) {
            corners[k] =
                lanes::GatherIndex(integers, all, lanes::Add(first, lanes::Set(integers, k)));
        }
    }

    template <std::size_t dimensions>
    HWY_INLINE Vector operator()(const float* values, std::size_t corner,
                                 std::size_t component) const {
        const Integers index = lanes::Mul(
            corners[corner], lanes::Set(integers, static_cast<std::int32_t>(dimensions)));
        return lanes::GatherIndex(tag, values + component, index);
    }

    Integers corners[3];
};

// Calls visit(triangles, mask, lane) for the lanes of a group, as many as a register has at a time.
template <class Visit>
HWY_INLINE void for_each_register(const Packet& packet, LaneBits bits, const scene::Mesh& mesh,
                                  const Visit& visit) {
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Mask mask = mask_of(bits, lane);
        if (lanes::AllFalse(tag, mask)) {
            continue;
        }
        const std::uint32_t first =
            packet.triangle[lane + static_cast<std::size_t>(std::countr_zero(bits >> lane))];
        const Integers same = lanes::Set(integers, static_cast<std::int32_t>(first));
        const Integers triangle = lanes::IfThenElse(
            lanes::RebindMask(integers, mask),
            lanes::BitCast(integers, lanes::Load(numbers, packet.triangle.data() + lane)), same);
        if (lanes::AllTrue(integers, lanes::Eq(triangle, same))) {
            visit(OneTriangle{mesh.triangles[first]}, mask, lane);
        } else {
            visit(Triangles(mesh, triangle), mask, lane);
        }
    }
}

template <class Corners>
HWY_INLINE Vector3 corner_of(const Corners& corners, const std::vector<V3f>& values,
                             std::size_t corner) {
    const float* const from = &values.front().x;
    return {corners.template operator()<3>(from, corner, 0),
            corners.template operator()<3>(from, corner, 1),
            corners.template operator()<3>(from, corner, 2)};
}

struct Vector2 {
    Vector u, v;
};

template <class Corners>
HWY_INLINE Vector2 corner_of(const Corners& corners, const std::vector<V2f>& values,
                             std::size_t corner) {
    const float* const from = &values.front().x;
    return {corners.template operator()<2>(from, corner, 0),
            corners.template operator()<2>(from, corner, 1)};
}

// The normal of the triangles in the world, of any length and on any side.
HWY_INLINE Vector3 triangle_normal(const Packet& packet, LaneBits bits, const PlacedMesh& mesh,
                                   std::size_t lane) {
    const Vector3 triangle = load(packet.normal_x, packet.normal_y, packet.normal_z, lane);
    const bool is_placed = packet.is_placed(static_cast<std::size_t>(std::countr_zero(bits)));
    return is_placed ? placed(triangle, mesh.normal_from_mesh) : triangle;
}

// A normal that is interpolated between those of the corners, of any length.
HWY_INLINE Vector3 interpolated(const Packet& packet, const OneTriangle& corners,
                                const std::vector<V3f>& normals, std::size_t lane) {
    const Vector u = load(packet.u, lane);
    const Vector v = load(packet.v, lane);
    const Vector first = difference(difference(number(1.0F), u), v);
    return sum(sum(product(first, corner_of(corners, normals, 0)),
                   product(u, corner_of(corners, normals, 1))),
               product(v, corner_of(corners, normals, 2)));
}

// The same for any triangles, one after another, which takes less time than gathering the corners.
HWY_INLINE Vector3 interpolated(const Packet& packet, LaneBits bits, const scene::Mesh& mesh,
                                std::size_t lane) {
    alignas(64) Packet::Floats x{}, y{}, z{};
    for (std::size_t i = lane; i < lane + lanes::Lanes(tag); ++i) {
        if ((bits >> i & 1U) == 0) {
            continue;
        }
        const auto& corners = mesh.triangles[packet.triangle[i]];
        const V3f& a = mesh.normals[corners[0]];
        const V3f& b = mesh.normals[corners[1]];
        const V3f& c = mesh.normals[corners[2]];
        const float u = packet.u[i];
        const float v = packet.v[i];
        const float first = 1.0F - u - v;
        x[i] = first * a.x + u * b.x + v * c.x;
        y[i] = first * a.y + u * b.y + v * c.y;
        z[i] = first * a.z + u * b.z + v * c.z;
    }
    return load(x, y, z, lane);
}

HWY_INLINE Vector3 smooth_normal(const Packet& packet, LaneBits bits, const PlacedMesh& placed_mesh,
                                 Mask mask, std::size_t lane) {
    const scene::Mesh& mesh = *placed_mesh.mesh;
    const std::uint32_t first =
        packet.triangle[lane + static_cast<std::size_t>(std::countr_zero(bits >> lane))];
    const auto others = lanes::And(
        lanes::RebindMask(numbers, mask),
        lanes::Ne(lanes::Load(numbers, packet.triangle.data() + lane), lanes::Set(numbers, first)));
    return placed(lanes::AllFalse(numbers, others)
                      ? interpolated(packet, OneTriangle{mesh.triangles[first]}, mesh.normals, lane)
                      : interpolated(packet, bits, mesh, lane),
                  placed_mesh.normal_from_mesh);
}

// A power of two whose product with a value is from 1 to 2, or to 4 for the largest values.
HWY_INLINE Vector reciprocal_scale(Vector value) {
    const auto exponent =
        lanes::Min(lanes::And(lanes::BitCast(numbers, value), lanes::Set(numbers, 0x7f800000U)),
                   lanes::Set(numbers, 0x7e800000U));
    return lanes::BitCast(tag, lanes::Sub(lanes::Set(numbers, 0x7f000000U), exponent));
}

// The cosine between rays and the normals of triangles. That of a small one is too short to be
// squared.
HWY_INLINE Vector flat_cosine(const Vector3& normal, const Vector3& direction) {
    const Vector size =
        lanes::Max(lanes::Max(lanes::Abs(normal.x), lanes::Abs(normal.y)), lanes::Abs(normal.z));
    const Vector3 scaled = product(reciprocal_scale(size), normal);
    return lanes::Div(lanes::Abs(dot(scaled, direction)), lanes::Sqrt(dot(scaled, scaled)));
}

// The normal for shading is on the side of the geometric normal that faces the viewer, and just
// above the horizon if it faces away from the viewer. Where it is 0, the surface is flat.
HWY_INLINE Vector smooth_cosine(const Vector3& flat, const Vector3& smooth,
                                const Vector3& direction) {
    const Vector zero = lanes::Zero(tag);
    const Vector one = number(1.0F);
    const Vector min_cosine = number(1e-3F);
    const Vector square = dot(smooth, smooth);
    const Mask has_normal = lanes::Gt(square, zero);
    const Vector length = lanes::Sqrt(lanes::IfThenElse(has_normal, square, one));
    const Vector towards = lanes::Div(dot(smooth, direction), length);
    // Negative where the two normals are on different sides of the triangle as the ray sees it.
    const Vector sides = lanes::Xor(dot(flat, smooth), dot(flat, direction));
    const Vector cosine = lanes::IfNegativeThenElse(sides, lanes::Neg(towards), towards);
    const Mask bends = lanes::AndNot(lanes::Ge(cosine, min_cosine), has_normal);
    Vector shown = cosine;
    if (!lanes::AllFalse(tag, bends)) {
        const Vector missing = difference(min_cosine, cosine);
        const Vector bent_square = sum(one, product(missing, sum(sum(cosine, cosine), missing)));
        shown = lanes::IfThenElse(bends, lanes::Div(min_cosine, lanes::Sqrt(bent_square)), cosine);
    }
    return lanes::AllTrue(tag, has_normal)
               ? shown
               : lanes::IfThenElse(has_normal, shown, flat_cosine(flat, direction));
}

HWY_INLINE Vector2 in_image(const scene::TextureUse& use, const Vector2& uv) {
    return {sum(product(uv.u, number(use.u_axis.x)), product(uv.v, number(use.v_axis.x))),
            sum(product(uv.u, number(use.u_axis.y)), product(uv.v, number(use.v_axis.y)))};
}

// The change in the image, of a limited size.
HWY_INLINE Vector2 slope_of(const Vector2& along, const Vector2& edge_1, const Vector2& edge_2) {
    const Vector u = sum(product(along.u, edge_1.u), product(along.v, edge_2.u));
    const Vector v = sum(product(along.u, edge_1.v), product(along.v, edge_2.v));
    const Vector widest = number(MeshPoint::widest_footprint);
    const Vector width = lanes::Max(lanes::Abs(u), lanes::Abs(v));
    const Vector scale =
        lanes::IfThenElse(lanes::Gt(width, widest), lanes::Div(widest, width), number(1.0F));
    const auto finite = lanes::And(lanes::IsFinite(u), lanes::IsFinite(v));
    return {lanes::IfThenElseZero(finite, product(u, scale)),
            lanes::IfThenElseZero(finite, product(v, scale))};
}

void set_footprints(const Packet& packet, LaneBits bits, const PlacedMesh& mesh,
                    const Normals& normals, const packet_lanes::Differentials& differentials,
                    const scene::TextureUse& use, texture_lanes::Footprints& footprints) {
    footprints = {};
    const std::vector<V3f>& positions = mesh.mesh->positions;
    const std::vector<V2f>& coordinates = mesh.mesh->texture_coordinates[use.coordinates];
    for_each_register(
        packet, bits, *mesh.mesh, [&](const auto& corners, Mask mask, std::size_t lane) {
            const auto set = [&](const Vector2& value, Packet::Floats& u, Packet::Floats& v) {
                store(mask, value.u, u, lane);
                store(mask, value.v, v, lane);
            };
            const Vector2 offset{number(use.offset.x), number(use.offset.y)};
            if (coordinates.empty()) {
                set(offset, footprints.at_u, footprints.at_v);
                return;
            }
            const auto in_world = [&](std::size_t corner) {
                return placed(difference(corner_of(corners, positions, corner),
                                         corner_of(corners, positions, 0)),
                              mesh.world_from_mesh);
            };
            const Vector3 edge_1 = in_world(1);
            const Vector3 edge_2 = in_world(2);
            const Vector3 across = cross(edge_1, edge_2);
            const Vector square = dot(across, across);
            const Vector3 to_u = cross(edge_2, across);
            const Vector3 to_v = cross(across, edge_1);
            const Vector3 normal = load(normals.x, normals.y, normals.z, lane);
            const Vector3 direction =
                load(packet.direction_x, packet.direction_y, packet.direction_z, lane);
            const Vector cosine = dot(normal, direction);
            const Vector distance = load(packet.farthest, lane);
            const auto on_triangle = [&](const Vector3& origin, const Vector3& turned) {
                const Vector3 moved = sum(origin, product(distance, turned));
                const Vector3 along =
                    difference(moved, product(lanes::Div(dot(moved, normal), cosine), direction));
                return Vector2{lanes::Div(dot(along, to_u), square),
                               lanes::Div(dot(along, to_v), square)};
            };
            const Vector2 first = corner_of(corners, coordinates, 0);
            const auto edge = [&](std::size_t corner) {
                const Vector2 to = corner_of(corners, coordinates, corner);
                return in_image(use, {difference(to.u, first.u), difference(to.v, first.v)});
            };
            const Vector2 image_1 = edge(1);
            const Vector2 image_2 = edge(2);
            const Vector2 start = in_image(use, first);
            const Vector u = load(packet.u, lane);
            const Vector v = load(packet.v, lane);
            const auto at = [&](Vector begin, Vector origin, Vector along_1, Vector along_2) {
                return sum(sum(sum(origin, begin), product(u, along_1)), product(v, along_2));
            };
            set({at(start.u, offset.u, image_1.u, image_2.u),
                 at(start.v, offset.v, image_1.v, image_2.v)},
                footprints.at_u, footprints.at_v);
            set(slope_of(on_triangle(load(differentials.origin_x, lane),
                                     load(differentials.direction_x, lane)),
                         image_1, image_2),
                footprints.along_x_u, footprints.along_x_v);
            set(slope_of(on_triangle(load(differentials.origin_y, lane),
                                     load(differentials.direction_y, lane)),
                         image_1, image_2),
                footprints.along_y_u, footprints.along_y_v);
        });
}

// A group of a plain look.
HWY_INLINE void light_group(const Packet& packet, LaneBits bits, const Look& look, Lit& lit,
                            Radiances& radiances) {
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Mask mask = mask_of(bits, lane);
        if (lanes::AllFalse(tag, mask)) {
            continue;
        }
        const Vector3 normal = triangle_normal(packet, bits, look.mesh, lane);
        const Vector3 direction =
            load(packet.direction_x, packet.direction_y, packet.direction_z, lane);
        const Vector cosine =
            look.is_smooth
                ? smooth_cosine(normal, smooth_normal(packet, bits, look.mesh, mask, lane),
                                direction)
                : flat_cosine(normal, direction);
        if (look.texture != nullptr) {
            store(mask, cosine, lit.cosines, lane);
            store(mask, normal.x, lit.normals.x, lane);
            store(mask, normal.y, lit.normals.y, lane);
            store(mask, normal.z, lit.normals.z, lane);
            continue;
        }
        const auto set = [&](float emission, float base, Packet::Floats& to) {
            store(mask, sum(number(emission), product(cosine, number(base))), to, lane);
        };
        set(look.emission.x, look.base_color.x, radiances.red);
        set(look.emission.y, look.base_color.y, radiances.green);
        set(look.emission.z, look.base_color.z, radiances.blue);
        store(mask, number(1.0F), radiances.alpha, lane);
    }
}

void light(const Packet& packet, std::span<const Look> looks, Lit& lit, Radiances& radiances) {
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        for (Packet::Floats* values :
             {&radiances.red, &radiances.green, &radiances.blue, &radiances.alpha}) {
            lanes::Store(lanes::Zero(tag), tag, values->data() + lane);
        }
    }
    HWY_NAMESPACE::find_groups(packet, lit.groups);
    for (const Group& group : lit.groups.all()) {
        if (const Look& look = looks[group.instance]; look.is_plain) {
            light_group(packet, group.lanes, look, lit, radiances);
        }
    }
}

void set_radiances(LaneBits bits, const Look& look, const Packet::Floats& cosines,
                   const texture_lanes::Colors& texture, Radiances& radiances) {
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Mask mask = mask_of(bits, lane);
        const Vector cosine = load(cosines, lane);
        const auto set = [&](float emission, float base, const texture_lanes::Floats& texels,
                             Packet::Floats& to) {
            const Vector shown = product(product(cosine, number(base)), load(texels, lane));
            store(mask, sum(number(emission), shown), to, lane);
        };
        set(look.emission.x, look.base_color.x, texture.red, radiances.red);
        set(look.emission.y, look.base_color.y, texture.green, radiances.green);
        set(look.emission.z, look.base_color.z, texture.blue, radiances.blue);
        store(mask, number(1.0F), radiances.alpha, lane);
    }
}

}  // namespace balcony::render::surface_lanes::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::surface_lanes {

HWY_EXPORT(find_groups);
HWY_EXPORT(set_footprints);
HWY_EXPORT(light);
HWY_EXPORT(set_radiances);

void find_groups(const embree::Packet& packet, Groups& groups) {
    HWY_DYNAMIC_DISPATCH(find_groups)(packet, groups);
}

void set_footprints(const embree::Packet& packet, LaneBits lanes, const PlacedMesh& mesh,
                    const Normals& normals, const packet_lanes::Differentials& differentials,
                    const scene::TextureUse& use, texture_lanes::Footprints& footprints) {
    HWY_DYNAMIC_DISPATCH(set_footprints)
    (packet, lanes, mesh, normals, differentials, use, footprints);
}

void light(const embree::Packet& packet, std::span<const Look> looks, Lit& lit,
           Radiances& radiances) {
    HWY_DYNAMIC_DISPATCH(light)(packet, looks, lit, radiances);
}

void set_radiances(LaneBits lanes, const Look& look, const embree::Packet::Floats& cosines,
                   const texture_lanes::Colors& texture, Radiances& radiances) {
    HWY_DYNAMIC_DISPATCH(set_radiances)(lanes, look, cosines, texture, radiances);
}

}  // namespace balcony::render::surface_lanes

#endif
