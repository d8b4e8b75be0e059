// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inverse of a map projection by its definition, checked against PROJ.

#include "camera/maps/inverse_map.hpp"

namespace balcony::camera::maps {

/// A map with its inverse.
struct Map {
    InverseMapPointer inverse;
    /// The smallest rectangle around the map, or around the part of it within pi of its origin in
    /// the directions in which it is infinite.
    MapExtent extent;
};

/// By how much PROJ's forward function of the inverse may differ from a point of the map, in radii
/// of the sphere: so much was measured at most, at points all over the map.
inline constexpr double largest_map_error = 1e-9;

/// Errors: what PROJ rejects or has no inverse of, and what has no inverse here.
[[nodiscard]] Result<Map> make_map(Definition definition);

}  // namespace balcony::camera::maps
