// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Ray arrays: the rays of a picture in memory, computed by all processors.
//
//     RayGrid::make(picture, settings) ─▶ fill(grid, arrays)

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>

#include <Imath/ImathVec.h>

#include "balcony/ray_maps.hpp"

namespace balcony::bridge {

/// Where the numbers of rays go, ray by ray. The arrays belong to the caller; one that is null is
/// not filled. Where there is no ray, all numbers are 0.
struct RayArrays {
    double* origins = nullptr;      ///< Three numbers for each ray.
    double* directions = nullptr;   ///< Three, of unit length.
    std::uint8_t* valid = nullptr;  ///< 1 where there is a ray.
    double* parameters = nullptr;   ///< Two, (u, v) of the eye object.
    /// Twelve: the derivatives of the origin by picture x and by picture y, then those of the
    /// direction. Only of a grid with footprints.
    double* footprints = nullptr;
    double* times = nullptr;  ///< One. Only of a grid with times.
};

/// The rays of all pixels, row by row from the top left. False if it is stopped.
[[nodiscard]] bool fill(const RayGrid& grid, const RayArrays& arrays,
                        const std::stop_token& stop = {});
/// The rays at points of the picture, in pixels. False if it is stopped.
[[nodiscard]] bool fill(const RayGrid& grid, std::span<const Imath::V2d> points,
                        const RayArrays& arrays, const std::stop_token& stop = {});

}  // namespace balcony::bridge
