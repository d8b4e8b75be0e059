// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/dataset.hpp"
#include "balcony/film.hpp"
#include "balcony/inverse.hpp"
#include "balcony/render.hpp"

namespace balcony::dataset {

/// Finds what frames show in the frames after them. The inverse of a camera is made once: another
/// pose of the camera is another pose of the points.
class FlowFinder {
public:
    /// For each pixel, from its middle to where the same camera in the next pose shows the point
    /// that its ray meets; of several places, the one with the nearest origin. NaN where the ray
    /// meets nothing, where the next frame does not show the point, and where a surface that is not
    /// transparent hides it, as the distances along the line of sight say.
    [[nodiscard]] Result<std::vector<Imath::V2f>> flow(const Plan& plan, const Frame& frame,
                                                       const render::Film& film,
                                                       const render::Renderer& renderer,
                                                       const std::stop_token& stop);

private:
    std::map<std::size_t, analyse::Locator> locators_;  // By the camera.
};

}  // namespace balcony::dataset
