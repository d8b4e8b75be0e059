// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "balcony/lang.hpp"
#include "balcony/probe.hpp"
#include "balcony/request.hpp"
#include "balcony/scene.hpp"

namespace balcony::app {

/// Where a camera stands that is placed in a scene, in axes with z up.
struct Standpoint {
    Imath::V3d position{0.0};
    /// Where it looks; nothing if nothing is said of it.
    std::optional<lang::SceneMeasures::Look> look{};
    double angle = 0.0;  ///< How large what it looks at appears, in radians.
};

/// `extent` is that of the scene or of the object that the camera is fitted to. An unknown camera
/// of the scene is an error.
[[nodiscard]] Result<Standpoint> standpoint(const Placement& placement, const scene::Scene& scene,
                                            const render::SceneExtent& extent);

}  // namespace balcony::app
