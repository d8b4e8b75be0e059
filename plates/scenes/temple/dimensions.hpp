// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Measures of the temple, in metres. It stands about the z axis on sand at z = 0.

#include <numbers>

namespace balcony::plates::temple {

inline constexpr int column_count = 14;
/// The angle between two columns; column 1 stands on the x axis.
inline constexpr double bay = 2.0 * std::numbers::pi / column_count;
/// The distance of the columns' axes from the z axis.
inline constexpr double radius = 10.0;

inline constexpr double floor_z = 1.05;
inline constexpr double shaft_z = 1.62;    ///< Where the shafts begin, above the bases.
inline constexpr double capital_z = 7.85;  ///< Where the capitals begin.
inline constexpr double impost_z = 8.85;   ///< Where the blocks above the capitals begin.
inline constexpr double spring_z = 9.3;    ///< Where the arches begin.
inline constexpr double ring_z = 11.35;
inline constexpr double top_z = 13.2;

inline constexpr double shaft_low = 0.5;  ///< Radii of the shaft.
inline constexpr double shaft_high = 0.42;
inline constexpr double arch_radius = 1.62;
inline constexpr double wall_inner = 9.5;  ///< Radii of the wall above the arches.
inline constexpr double wall_outer = 10.5;

/// What a tile of marble measures.
inline constexpr double marble_size = 2.6;

}  // namespace balcony::plates::temple
