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

    /// For a picture of a size in pixels with values for its open parameters, at a time in seconds.
    [[nodiscard]] static Result<PixelMetrics> make(const lang::OpenPicture& opened,
                                                   const std::array<std::size_t, 2>& size,
                                                   double time, const std::stop_token& stop);

    /// At a distance along the ray of a point, in a layer by its number from the back. Nothing if
    /// there is no ray or it does not change with the picture. `inputs` are those of the parameters
    /// in their order.
    [[nodiscard]] std::optional<Metric> at(std::size_t layer, const Imath::V2d& point,
                                           double distance,
                                           std::span<const camera::KnownInput> inputs);

private:
    PixelMetrics(rays::VisibleLayers layers, double time)
        : layers_(std::move(layers)), time_(time) {}

    rays::VisibleLayers layers_;
    double time_;
    rays::Scratch scratch_;
    rays::RayBatch batch_;
};

}  // namespace balcony::live
