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
#include "render/embree/accelerator.hpp"
#include "render/shading/packet_lanes.hpp"
#include "render/shading/surface.hpp"
#include "render/textures/texture_lanes.hpp"

namespace balcony::render::surface_lanes {

/// Lane i of a packet is bit i.
using LaneBits = std::uint32_t;

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

/// Sets the normals of a group.
void set_normals(const embree::Packet& packet, LaneBits lanes, const PlacedMesh& mesh,
                 packet_lanes::Normals& normals);

/// Sets the footprints of a group in the image of a use of a texture, as
/// Surface::triangle_footprint() and MeshPoint::texture_footprint() for one, up to rounding errors;
/// those of the other lanes become 0. The normals are those of set_normals().
void set_footprints(const embree::Packet& packet, LaneBits lanes, const PlacedMesh& mesh,
                    const packet_lanes::Normals& normals,
                    const packet_lanes::Differentials& differentials, const scene::TextureUse& use,
                    texture_lanes::Footprints& footprints);

struct alignas(64) Radiances {
    embree::Packet::Floats red, green, blue, alpha;
};

/// Sets the radiances of a group with an opaque material: the emission and, by the cosines, the
/// base colour, which is multiplied with a texture's colours unless they are null.
void set_radiances(LaneBits lanes, const Imath::Color3f& emission, const Imath::Color3f& base_color,
                   const embree::Packet::Floats& cosines, const texture_lanes::Colors* texture,
                   Radiances& radiances);

/// Writes radiances as colours, and 0 where a lane is in none of the groups.
void write(const Radiances& radiances, const Groups& groups,
           std::array<Imath::Color4f, embree::Packet::size>& colors);

}  // namespace balcony::render::surface_lanes
