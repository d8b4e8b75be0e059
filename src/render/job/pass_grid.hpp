// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <Imath/ImathVec.h>

#include "balcony/film.hpp"
#include "balcony/rays.hpp"

namespace balcony::render {

/// The places of a pass's samples, one in each pixel of a region. Those that the filter puts beyond
/// the picture are moved to its border, because the camera may see something else or be undefined
/// there; just inside, for cameras that end at the border.
[[nodiscard]] inline rays::Tile pass_grid(const Region& region, const Imath::V2d& offset,
                                          std::size_t width, std::size_t height, double time) {
    constexpr double just_inside = 1e-6;
    const auto limits = [](std::size_t extent) {
        return rays::Tile::Limits{just_inside, static_cast<double>(extent) - just_inside};
    };
    return {static_cast<double>(region.x) + 0.5 + offset.x,
            static_cast<double>(region.y) + 0.5 + offset.y,
            1.0,
            region.width,
            region.height,
            time,
            limits(width),
            limits(height)};
}

}  // namespace balcony::render
