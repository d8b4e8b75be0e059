// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is painted, woven and printed in the room. Painters of rectangles have their top upwards.

#include "common/drawing.hpp"
#include "common/painting.hpp"

namespace balcony::plates::room {

[[nodiscard]] Color oak_boards(const Sample& sample);  ///< A tile of 2 by 2 m, boards along x.
[[nodiscard]] Color wallpaper(const Sample& sample);   ///< A tile of 0.4 by 0.4 m.
[[nodiscard]] Color carpet(const Sample& sample);      ///< With an aspect of 1.4.
[[nodiscard]] Color marble(const Sample& sample);
[[nodiscard]] Color clock_dial(const Sample& sample);  ///< Square; it is five past four.
[[nodiscard]] Color globe_map(const Sample& sample);   ///< Longitude and latitude.

/// What is seen through a window, with the horizon in the middle; 1 is the brightest sky.
[[nodiscard]] Color countryside(const Sample& sample);

/// A poster with the word BALCONY, 0.8 by 1.15.
[[nodiscard]] Drawing paint_poster();
/// A magazine with the word ROOM, 0.22 by 0.3.
[[nodiscard]] Drawing paint_magazine();

}  // namespace balcony::plates::room
