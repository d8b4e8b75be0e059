// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "balcony/scene.hpp"

namespace balcony::scene {

/// Polygons with more corners are not read: triangulation needs quadratic time at worst.
inline constexpr std::size_t max_polygon_corners = 4096;

/// Divides a polygon of at least three finite corners into triangles, given by the numbers of their
/// corners, with the winding of the polygon. A polygon that is not plane is divided as it appears
/// along its normal. Ear clipping (Meisters 1975); a convex polygon becomes a fan about its first
/// corner. A polygon that intersects itself also gives two triangles fewer than it has corners.
void triangulate(std::span<const V3f> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace balcony::scene
