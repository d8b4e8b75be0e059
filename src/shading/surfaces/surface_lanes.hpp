// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is computed for the surfaces that the rays of a packet hit, for all of an instance together,
// in the widest registers of the machine. The results are the same on all machines, bit for bit.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <Imath/ImathColor.h>

#include "balcony/scene.hpp"
#include "shading/geometry/ray.hpp"
#include "shading/surfaces/packet_lanes.hpp"
#include "shading/surfaces/surface.hpp"
#include "shading/textures/texture_lanes.hpp"

namespace balcony::render::surface_lanes {

/// The rays of a packet that hit the same instance.
struct Group {
    std::uint32_t instance = 0;
    LaneBits lanes = 0;

    [[nodiscard]] bool has(std::size_t lane) const { return (lanes >> lane & 1U) != 0; }
};

class Groups {
public:
    [[nodiscard]] std::span<const Group> all() const { return {groups_.data(), count_}; }
    void clear() { count_ = 0; }
    void add(const Group& group) { groups_[count_++] = group; }

private:
    std::array<Group, embree::Packet::size> groups_;
    std::size_t count_ = 0;
};

/// Finds the groups of a packet with its hits.
void find_groups(const embree::Packet& packet, Groups& groups);

/// The largest number of triangles and of vertices of a mesh for the following functions.
inline constexpr std::size_t max_mesh_size = std::size_t{1} << 29U;

/// Sets the footprints of a group in the image of a use of a texture, as Surface::transfer(),
/// triangle_footprint() and MeshPoint::texture_footprint() for one, bit for bit. The other lanes
/// have that of its first, so that their look-ups need no texels of their own.
void set_footprints(const embree::Packet& packet, LaneBits lanes, const PlacedMesh& mesh,
                    const packet_lanes::Differentials& differentials, const scene::TextureUse& use,
                    texture_lanes::Footprints& footprints);

/// How an instance looks that is lit from the origins of rays.
struct Look {
    bool is_plain = false;   ///< At rest, and with a plain material; otherwise the rest is unused.
    bool is_smooth = false;  ///< The mesh has normals.
    Imath::Color3f base_color{0.0F};
    Imath::Color3f emission{0.0F};
    const scene::TextureUse* texture = nullptr;  ///< Of the base colour.
    PlacedMesh mesh{};
};

/// The radiances of the rays of a packet.
struct alignas(64) Radiances {
    LaneVectors color;
    LaneFloats alpha{};

    void set(std::size_t lane, const Imath::Color4f& radiance) {
        color.set(lane, {radiance.r, radiance.g, radiance.b});
        alpha[lane] = radiance.a;
    }
};

/// A packet lit from the origins of its rays.
struct alignas(64) Lit {
    /// Of groups with a texture: those between the rays and the normal for shading, as with
    /// Surface::smooth_normal. Defined where the normal of the triangle is not 0.
    LaneFloats cosines;
    Groups groups;
};

/// Finds the groups of a packet and sets the radiances of those that are plain and have no texture;
/// those of lanes without a hit become 0. The looks are those of all instances.
void light(const embree::Packet& packet, std::span<const Look> looks, Lit& lit,
           Radiances& radiances);

/// Sets the radiances of a group with a texture, of these colours: the emission and, by the
/// cosines, the base colour.
void set_radiances(LaneBits lanes, const Look& look, const LaneFloats& cosines,
                   const LaneVectors& texels, Radiances& radiances);

/// The numbers of some lanes of a packet.
struct LaneCounts {
    std::size_t missing = 0;  ///< There is no ray.
    std::size_t shown = 0;    ///< Something is seen: alpha is above 0.
};

/// Writes the radiances of a packet as a square of colours whose rows are `stride` apart; black
/// where one is not finite, which is counted in `broken`. Other counts are of these lanes.
LaneCounts write(const embree::Packet& packet, const Radiances& radiances, LaneBits counted,
                 std::size_t stride, Imath::Color4f* to, std::uint64_t& broken);

}  // namespace balcony::render::surface_lanes
