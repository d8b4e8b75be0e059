// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How long the steps from pixel to pixel are in space.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/camera.hpp"
#include "balcony/inspect.hpp"
#include "balcony/rays.hpp"

namespace balcony::live {

/// Belongs to one thread.
class PixelMetrics {
public:
    using Metric = Sight::Hit::Metric;

    /// For a picture of a size in pixels with values for its open parameters.
    [[nodiscard]] static Result<PixelMetrics> make(const lang::OpenPicture& opened,
                                                   const std::array<std::size_t, 2>& size,
                                                   const std::stop_token& stop);

    /// At a distance along the ray of a point at a time in seconds, in a layer by its number from
    /// the back. Nothing if there is no ray or it does not change with the picture. `inputs` are
    /// those of the parameters in their order.
    [[nodiscard]] std::optional<Metric> at(std::size_t layer, const Imath::V2d& point,
                                           double distance, double time,
                                           std::span<const camera::KnownInput> inputs);

private:
    explicit PixelMetrics(rays::VisibleLayers layers) : layers_(std::move(layers)) {}

    rays::VisibleLayers layers_;
    rays::Scratch scratch_;
    rays::RayBatch batch_;
};

}  // namespace balcony::live
