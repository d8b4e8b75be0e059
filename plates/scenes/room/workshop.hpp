// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Short ways to make the materials of the room and to put things into it.

#include <numbers>
#include <string>

#include "common/drawing.hpp"
#include "common/mesh_builder.hpp"
#include "common/scene_builder.hpp"

namespace balcony::plates::room {

inline constexpr double degrees = std::numbers::pi / 180.0;

/// Something that faces -y, turned counterclockwise by degrees and moved.
[[nodiscard]] M44d stand(const V3d& at, double turn);

/// Something flat that faces z with its top along y, set upright before a wall.
[[nodiscard]] M44d hang(const V3d& at, double turn);

// The turn of something with its back at a wall.
inline constexpr double at_wall_plus_y = 0.0;
inline constexpr double at_wall_minus_x = 90.0;
inline constexpr double at_wall_minus_y = 180.0;
inline constexpr double at_wall_plus_x = -90.0;

struct Workshop {
    Workshop(std::string name, const SceneOptions& options) : builder(std::move(name), options) {}

    using MaterialIndex = scene::MaterialIndex;
    MaterialIndex plain(const std::string& name, std::uint32_t color, float roughness);
    MaterialIndex metal(const char* name, std::uint32_t color, float roughness);
    MaterialIndex glowing(const char* name, const scene::Color3f& emission);
    /// A texture that fills a rectangle.
    MaterialIndex painted(const char* name, int width, int height, const Painter& painter,
                          float roughness);
    MaterialIndex drawn(const char* name, int width, int height, const Drawing& drawing);
    /// A texture in scene units, a square tile of which is so large.
    MaterialIndex tiled(const char* name, int pixels, const Painter& painter, double size,
                        float roughness);

    /// One object, a mesh of its own.
    void put(const std::string& name, scene::Mesh mesh, MaterialIndex material,
             const M44d& placed = M44d());
    void put(const std::string& name, const MeshBuilder& built, MaterialIndex material,
             const M44d& placed = M44d());
    /// A picture of plates/pictures with its middle at a place, in a frame.
    void hang_picture(const char* picture, const V3d& middle, double turn, const V2d& size,
                      MaterialIndex moulding);
    /// A moulding about a rectangle that hangs.
    void put_frame(const std::string& name, const V2d& size, double moulding_width,
                   MaterialIndex moulding, const M44d& placed);

    SceneBuilder builder;
};

}  // namespace balcony::plates::room
