// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The shutter: how long a picture is exposed, and how much each moment of it counts.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/motion.hpp"
#include "balcony/names.hpp"

namespace balcony::render {

/// How much the moments of an exposure count.
enum class ShutterShape : std::uint8_t {
    box,        ///< All the same: the shutter opens and closes at once.
    trapezoid,  ///< The shutter opens evenly during the first quarter of the time that it takes, is
                ///< open during half of it, and closes evenly during the last quarter.
};

[[nodiscard]] Names<ShutterShape> shutter_shapes();

/// The shutter of a picture, which is half way through its exposure at the picture's time.
struct Shutter {
    double duration = 0.0;  ///< Seconds from opening to closing, at least 0; 0 is an instant.
    ShutterShape shape = ShutterShape::box;

    /// The exposure of the picture at a time.
    [[nodiscard]] scene::TimeInterval exposure(double time) const;
    /// A moment of that exposure for a number from 0 to 1: evenly distributed numbers give moments
    /// as often as they count.
    [[nodiscard]] double moment(double time, double random) const;
};

}  // namespace balcony::render
