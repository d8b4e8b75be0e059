// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sand to the horizon, and the sky above it with the sun.

#include <cstddef>
#include <vector>

#include "balcony/scene.hpp"
#include "common/painting.hpp"

namespace balcony::plates::temple {

/// Where the land ends and the sky stands, in metres from the temple.
inline constexpr double horizon = 4000.0;

/// Towards the sun, of length 1.
[[nodiscard]] V3d sun_direction();

/// The height of the sand: even at the temple but for a drift against its steps, dunes farther
/// away.
[[nodiscard]] double sand_height(const V2d& at);

/// The ground up to the horizon, paler with the distance. A tile of its texture coordinates is
/// ripple_tile wide.
[[nodiscard]] scene::Mesh sand();

inline constexpr double ripple_tile = 11.0;
/// The normal map of a tile of wind ripples.
[[nodiscard]] Color sand_ripples(const Sample& sample);

/// The sky from the horizon (bottom) to the zenith (top), once round (right to left as seen from
/// inside): radiance, where 1 is white. The elevation grows with the square of the height.
[[nodiscard]] Color sky_picture(const Sample& sample);
inline constexpr double sky_aspect = 4.0;

/// The dome for that picture, and the disc of the sun in front of it.
[[nodiscard]] scene::Mesh sky_dome();
[[nodiscard]] scene::Mesh sun_disc();

}  // namespace balcony::plates::temple
