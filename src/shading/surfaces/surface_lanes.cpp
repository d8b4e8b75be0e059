// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/surfaces/surface_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <bit>

#include "shading/surfaces/surface_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::surface_lanes::HWY_NAMESPACE {

#include "shading/lanes/registers.inl"

#include "shading/geometry/placed.inl"
#include "shading/surfaces/surface.inl"

using embree::Packet;

HWY_INLINE Float2 constant(const V2f& v) { return {v.x, v.y}; }
HWY_INLINE Float3 constant(const Imath::Color3f& v) { return {v.x, v.y, v.z}; }

HWY_INLINE Float3 origin_of(const Packet& packet, std::size_t lane) {
    return load(packet.origin_x, packet.origin_y, packet.origin_z, lane);
}

HWY_INLINE Float3 direction_of(const Packet& packet, std::size_t lane) {
    return load(packet.direction_x, packet.direction_y, packet.direction_z, lane);
}

HWY_INLINE std::size_t first_of(LaneBits bits) {
    return static_cast<std::size_t>(std::countr_zero(bits));
}

void find_groups(const Packet& packet, Groups& groups) {
    const auto nothing = static_cast<std::int32_t>(embree::Hit::nothing);
    alignas(64) Packet::Numbers instances;
    LaneBits rest = 0;
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Int geometry = load(packet.geometry, lane);
        const Int placement = load(packet.placement, lane);
        store(select(placement == nothing, geometry, placement), instances, lane);
        rest |= bits_of(!(geometry == nothing), lane);
    }
    groups.clear();
    while (rest != 0) {
        const std::uint32_t instance = instances[first_of(rest)];
        LaneBits same = 0;
        for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
            same |= bits_of(load(instances, lane) == static_cast<std::int32_t>(instance), lane);
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
    HWY_INLINE Float operator()(const float* values, std::size_t corner,
                                std::size_t component) const {
        return values[corners[corner] * dimensions + component];
    }
};

struct Triangles {
    HWY_INLINE Triangles(const scene::Mesh& mesh, Int triangle) {
        const auto* const all =
            reinterpret_cast<const std::int32_t*>(mesh.triangles.front().data());
        for (std::int32_t k = 0; k < 3; ++k) {
            corners[k] = lanes::GatherIndex(int_tag, all, (triangle * 3 + k).v);
        }
    }

    template <std::size_t dimensions>
    HWY_INLINE Float operator()(const float* values, std::size_t corner,
                                std::size_t component) const {
        const Int index = corners[corner] * static_cast<std::int32_t>(dimensions);
        return lanes::GatherIndex(tag, values + component, index.v);
    }

    Int corners[3];
};

// Calls visit(triangles, where, lane) for the lanes of a group, as many as a register has at a
// time.
template <class Visit>
HWY_INLINE void for_each_register(const Packet& packet, LaneBits bits, const scene::Mesh& mesh,
                                  const Visit& visit) {
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Where where = where_of(bits, lane);
        if (!any(where)) {
            continue;
        }
        const std::uint32_t first = packet.triangle[lane + first_of(bits >> lane)];
        const Int same = static_cast<std::int32_t>(first);
        const Int triangle = select(where, load(packet.triangle, lane), same);
        if (all(triangle == same)) {
            visit(OneTriangle{mesh.triangles[first]}, where, lane);
        } else {
            visit(Triangles(mesh, triangle), where, lane);
        }
    }
}

template <class Corners>
HWY_INLINE Float3 corner_of(const Corners& corners, const std::vector<V3f>& values,
                            std::size_t corner) {
    const float* const from = &values.front().x;
    return {corners.template operator()<3>(from, corner, 0),
            corners.template operator()<3>(from, corner, 1),
            corners.template operator()<3>(from, corner, 2)};
}

template <class Corners>
HWY_INLINE Float2 corner_of(const Corners& corners, const std::vector<V2f>& values,
                            std::size_t corner) {
    const float* const from = &values.front().x;
    return {corners.template operator()<2>(from, corner, 0),
            corners.template operator()<2>(from, corner, 1)};
}

// The normal of the triangles in the world, of any length and on any side.
HWY_INLINE Float3 triangle_normal(const Packet& packet, LaneBits bits, const PlacedMesh& mesh,
                                  std::size_t lane) {
    const Float3 normal = load(packet.normal_x, packet.normal_y, packet.normal_z, lane);
    return packet.is_placed(first_of(bits)) ? placed(normal, mesh.normal_from_mesh) : normal;
}

// A normal that is interpolated between those of the corners, of any length: for one triangle, and
// for any, one after another, which takes less time than gathering the corners.
HWY_INLINE Float3 interpolated_normal(const Packet& packet, const OneTriangle& corners,
                                      const std::vector<V3f>& normals, std::size_t lane) {
    return interpolated(load(packet.u, lane), load(packet.v, lane), corner_of(corners, normals, 0),
                        corner_of(corners, normals, 1), corner_of(corners, normals, 2));
}

HWY_INLINE Float3 interpolated_normal(const Packet& packet, LaneBits bits, const scene::Mesh& mesh,
                                      std::size_t lane) {
    LaneVectors normals;
    for (std::size_t i = lane; i < lane + lanes::Lanes(tag); ++i) {
        if ((bits & lane_bit(i)) != 0) {
            const auto& corners = mesh.triangles[packet.triangle[i]];
            normals.set(i, interpolated(packet.u[i], packet.v[i], mesh.normals[corners[0]],
                                        mesh.normals[corners[1]], mesh.normals[corners[2]]));
        }
    }
    return load(normals, lane);
}

HWY_INLINE Float3 smooth_normal(const Packet& packet, LaneBits bits, const PlacedMesh& placed_mesh,
                                Where where, std::size_t lane) {
    const scene::Mesh& mesh = *placed_mesh.mesh;
    const std::uint32_t first = packet.triangle[lane + first_of(bits >> lane)];
    const Where same = load(packet.triangle, lane) == static_cast<std::int32_t>(first);
    return placed(
        any(both(where, !same))
            ? interpolated_normal(packet, bits, mesh, lane)
            : interpolated_normal(packet, OneTriangle{mesh.triangles[first]}, mesh.normals, lane),
        placed_mesh.normal_from_mesh);
}

// A power of two whose product with a value is from 1 to 2, or to 4 for the largest values.
HWY_INLINE Float reciprocal_scale(Float value) {
    const Int exponent =
        smaller(lanes::And(lanes::BitCast(int_tag, value.v), Int(0x7f800000).v), Int(0x7e800000));
    return lanes::BitCast(tag, (Int(0x7f000000) - exponent).v);
}

// The cosine between rays and the normals of triangles. That of a small one is too short to be
// squared.
HWY_INLINE Float flat_cosine(const Float3& normal, const Float3& direction) {
    const Float size = largest({absolute(normal.x), absolute(normal.y), absolute(normal.z)});
    const Float3 scaled = reciprocal_scale(size) * normal;
    return absolute(dot(scaled, direction)) / root(dot(scaled, scaled));
}

// The same with the normals for shading, of interpolated ones of any length. Where these are 0, the
// surface is flat.
HWY_INLINE Float smooth_cosine(const Float3& flat, const Float3& smooth, const Float3& direction) {
    const Where has_normal = has_length(smooth);
    const Float shown = absolute(dot(shading_normal(unit_of(smooth), flat, -direction), direction));
    return all(has_normal) ? shown : select(has_normal, shown, flat_cosine(flat, direction));
}

HWY_INLINE Float2 in_image(const scene::TextureUse& use, const Float2& uv) {
    return uv.x * constant(use.u_axis) + uv.y * constant(use.v_axis);
}

void set_footprints(const Packet& packet, LaneBits bits, const PlacedMesh& mesh,
                    const packet_lanes::Differentials& differentials, const scene::TextureUse& use,
                    texture_lanes::Footprints& footprints) {
    footprints = {};
    const std::vector<V3f>& positions = mesh.mesh->positions;
    const std::vector<V2f>& coordinates = mesh.mesh->texture_coordinates[use.coordinates];
    for_each_register(
        packet, bits, *mesh.mesh, [&](const auto& corners, Where where, std::size_t lane) {
            const Float2 offset = constant(use.offset);
            if (coordinates.empty()) {
                store(where, offset, footprints.at, lane);
                return;
            }
            const auto corner = [&](std::size_t i) {
                return placed(corner_of(corners, positions, i), mesh.world_from_mesh);
            };
            const Float3 first = corner(0);
            const Float3 edge_1 = corner(1) - first;
            const Float3 edge_2 = corner(2) - first;
            const Float u = load(packet.u, lane);
            const Float v = load(packet.v, lane);
            const Float3 direction = direction_of(packet, lane);
            const Float3 normal = unit(cross(edge_1, edge_2));
            const Float length =
                dot(point_on(first, u, v, edge_1, edge_2) - origin_of(packet, lane), direction);
            const Float cosine = dot(direction, normal);
            const Float2 first_in_image = corner_of(corners, coordinates, 0);
            const auto edge_in_image = [&](std::size_t i) {
                return in_image(use, corner_of(corners, coordinates, i) - first_in_image);
            };
            const Float2 image_1 = edge_in_image(1);
            const Float2 image_2 = edge_in_image(2);
            const auto store_slope = [&](const LaneVectors& origin_by,
                                         const LaneVectors& direction_by, LanePairs& slopes) {
                const Float3 moved = moved_on_plane(load(origin_by, lane), load(direction_by, lane),
                                                    length, direction, normal, cosine);
                store(where, slope_in_image(in_triangle(moved, edge_1, edge_2), image_1, image_2),
                      slopes, lane);
            };
            store(where, point_on(offset + in_image(use, first_in_image), u, v, image_1, image_2),
                  footprints.at, lane);
            store_slope(differentials.origin_x, differentials.direction_x, footprints.along_x);
            store_slope(differentials.origin_y, differentials.direction_y, footprints.along_y);
        });
    const auto first = static_cast<std::size_t>(std::countr_zero(bits));
    for_each_lane(all_lanes & ~bits, [&](std::size_t lane) {
        for (LanePairs* const values : {&footprints.at, &footprints.along_x, &footprints.along_y}) {
            values->set(lane, values->of(first));
        }
    });
}

// A group of a plain look.
HWY_INLINE void light_group(const Packet& packet, LaneBits bits, const Look& look, Lit& lit,
                            Radiances& radiances) {
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Where where = where_of(bits, lane);
        if (!any(where)) {
            continue;
        }
        const Float3 normal = triangle_normal(packet, bits, look.mesh, lane);
        const Float3 direction = direction_of(packet, lane);
        const Float cosine =
            look.is_smooth
                ? smooth_cosine(normal, smooth_normal(packet, bits, look.mesh, where, lane),
                                direction)
                : flat_cosine(normal, direction);
        if (look.texture != nullptr) {
            store(where, cosine, lit.cosines, lane);
            continue;
        }
        store(where, constant(look.emission) + cosine * constant(look.base_color), radiances.color,
              lane);
        store(where, 1.0F, radiances.alpha, lane);
    }
}

void light(const Packet& packet, std::span<const Look> looks, Lit& lit, Radiances& radiances) {
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        store(Float3{0.0F, 0.0F, 0.0F}, radiances.color, lane);
        store(Float(0.0F), radiances.alpha, lane);
    }
    HWY_NAMESPACE::find_groups(packet, lit.groups);
    for (const Group& group : lit.groups.all()) {
        if (const Look& look = looks[group.instance]; look.is_plain) {
            light_group(packet, group.lanes, look, lit, radiances);
        }
    }
}

void set_radiances(LaneBits bits, const Look& look, const LaneFloats& cosines,
                   const LaneVectors& texels, Radiances& radiances) {
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Where where = where_of(bits, lane);
        const Float3 reflected =
            load(cosines, lane) * constant(look.base_color) * load(texels, lane);
        store(where, constant(look.emission) + reflected, radiances.color, lane);
        store(where, 1.0F, radiances.alpha, lane);
    }
}

LaneCounts write(const Packet& packet, const Radiances& radiances, LaneBits counted,
                 std::size_t stride, Imath::Color4f* to, std::uint64_t& broken) {
    alignas(64) std::array<Imath::Color4f, Packet::size> colors;
    LaneBits visible = 0;
    LaneBits missing = 0;
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Float3 color = load(radiances.color, lane);
        const Float alpha = load(radiances.alpha, lane);
        const Where finite = both(both(is_finite(color.x), is_finite(color.y)),
                                  both(is_finite(color.z), is_finite(alpha)));
        const Float3 shown = or_zero(finite, color);
        const Float shown_alpha = or_zero(finite, alpha);
        lanes::StoreInterleaved4(shown.x.v, shown.y.v, shown.z.v, shown_alpha.v, tag,
                                 &colors[lane].r);
        broken += lanes::CountTrue(tag, (!finite).m);
        visible |= bits_of(shown_alpha > 0.0F, lane);
        missing |= bits_of(Int(lanes::Load(int_tag, packet.valid.data() + lane)) == 0, lane);
    }
    LaneCounts counts;
    counts.shown = static_cast<std::size_t>(std::popcount(visible & counted));
    counts.missing = static_cast<std::size_t>(std::popcount(missing & counted));
    const lanes::CappedTag<float, 4 * Packet::side> row_tag;
    for (std::size_t row = 0; row < Packet::side; ++row) {
        for (std::size_t k = 0; k < 4 * Packet::side; k += lanes::Lanes(row_tag)) {
            lanes::StoreU(lanes::Load(row_tag, &colors[row * Packet::side].r + k), row_tag,
                          &to[row * stride].r + k);
        }
    }
    return counts;
}

}  // namespace balcony::render::surface_lanes::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::surface_lanes {

HWY_EXPORT(find_groups);
HWY_EXPORT(set_footprints);
HWY_EXPORT(light);
HWY_EXPORT(set_radiances);
HWY_EXPORT(write);

void find_groups(const embree::Packet& packet, Groups& groups) {
    HWY_DYNAMIC_DISPATCH(find_groups)(packet, groups);
}

void set_footprints(const embree::Packet& packet, LaneBits lanes, const PlacedMesh& mesh,
                    const packet_lanes::Differentials& differentials, const scene::TextureUse& use,
                    texture_lanes::Footprints& footprints) {
    HWY_DYNAMIC_DISPATCH(set_footprints)(packet, lanes, mesh, differentials, use, footprints);
}

void light(const embree::Packet& packet, std::span<const Look> looks, Lit& lit,
           Radiances& radiances) {
    HWY_DYNAMIC_DISPATCH(light)(packet, looks, lit, radiances);
}

void set_radiances(LaneBits lanes, const Look& look, const LaneFloats& cosines,
                   const LaneVectors& texels, Radiances& radiances) {
    HWY_DYNAMIC_DISPATCH(set_radiances)(lanes, look, cosines, texels, radiances);
}

LaneCounts write(const embree::Packet& packet, const Radiances& radiances, LaneBits counted,
                 std::size_t stride, Imath::Color4f* to, std::uint64_t& broken) {
    return HWY_DYNAMIC_DISPATCH(write)(packet, radiances, counted, stride, to, broken);
}

}  // namespace balcony::render::surface_lanes

#endif
