// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which model of a lens gives the rays of a camera.

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "balcony/dataset.hpp"

namespace balcony::dataset {

/// Rays of a camera at some points of its picture, in axes with z up.
struct SampledRays {
    std::vector<Imath::V2d> points;  ///< In pixels.
    std::vector<V3d> origins;
    std::vector<V3d> directions;
};

/// A point, if all rays start there.
[[nodiscard]] std::optional<V3d> viewpoint_of(const SampledRays& rays);

/// The first model whose numbers give all these rays, which start at one point: each arrives within
/// 1e-6 of a pixel of its point. The numbers are found by least squares and then proved; no model
/// is taken that is only near.
[[nodiscard]] std::optional<Lens> lens_of(const SampledRays& rays);

}  // namespace balcony::dataset
