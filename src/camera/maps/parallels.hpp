// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The maps that reduce to functions of one variable: parallels are straight lines or arcs about one
// centre. They need no formula of their own: PROJ's forward function shows which kind a map is.

#include <optional>
#include <span>
#include <vector>

#include "camera/maps/inverse_map.hpp"
#include "camera/maps/profile.hpp"

namespace balcony::camera::maps {

/// Cylindrical and pseudocylindrical maps: y depends on latitude alone, and x is proportional to
/// longitude, to the east and west up to a limit. Null if the map is none.
[[nodiscard]] InverseMapPointer straight_parallels(const ForwardMap& map, double limit);
/// The same with known functions of latitude, or of another parameter: y and the width of a radian.
[[nodiscard]] InverseMapPointer straight_parallels(const AngleFunctions& functions);

/// The part of an interrupted map between two longitudes, on one side of the equator, with a
/// straight meridian in it.
struct Lobe {
    bool north = true;
    double west = 0.0, east = 0.0, meridian = 0.0;
};
/// Pseudocylindrical maps that are interrupted along meridians; the lobes of each side are sorted
/// from west to east. On the equator, x is that of the map, from west to east without a gap.
[[nodiscard]] InverseMapPointer lobed_parallels(const AngleFunctions& functions,
                                                std::span<const Lobe> lobes, const ForwardMap& map);

/// Conic and pseudoconic maps: the distance from a centre depends on latitude alone, and the angle
/// there is proportional to longitude. Null if the map is none. Tangents may be measured from
/// `middle_latitude`.
[[nodiscard]] InverseMapPointer concentric_parallels(const ForwardMap& map, double middle_latitude);

/// Azimuthal maps: the distance from the centre depends on the angle from it alone, and the
/// directions at the centre are those of the sphere. Null if the map is none.
[[nodiscard]] InverseMapPointer azimuthal(const ForwardMap& map, const SpherePoint& center);

/// Cylindrical maps along another great circle than the equator, at any angle in the map. Null if
/// the map is none.
[[nodiscard]] InverseMapPointer oblique_cylinder(const ForwardMap& map, const SphereAxes& axes);

}  // namespace balcony::camera::maps
