// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "balcony/lang.hpp"
#include "balcony/picture.hpp"
#include "balcony/render.hpp"
#include "balcony/request.hpp"

namespace balcony::app {

/// Makes cameras of a workspace; none if that fails.
using MakeCameras = std::function<std::vector<camera::Camera>()>;

/// Fits the cameras that a workspace makes from now on to a scene, which the renderer has, or to
/// its object that the placement names. If rays of those that are made start in closed objects,
/// they are fitted to a smaller box in its middle, where they start in the open, if there is one.
/// An unknown object is an error; so is a stop, of Kind::interrupted.
[[nodiscard]] Diagnostics fit_cameras(lang::Workspace& cameras, const Placement& placement,
                                      const scene::Scene& scene, const render::Renderer& renderer,
                                      const MakeCameras& make, const std::stop_token& stop);
/// The cameras of a picture, if there is one.
[[nodiscard]] std::vector<camera::Camera> cameras_of(const Result<camera::Picture>& picture);

/// Warns of a demanded place that decides nothing about cameras with these fitted parameters.
[[nodiscard]] Diagnostics warn_of_unused_place(const Placement& placement,
                                               const std::vector<lang::FittedParameter>& fitted);

/// Errors of usage: a demand without a scene, or two that contradict each other.
[[nodiscard]] Diagnostics check_placement(const Placement& placement, bool has_scene);

}  // namespace balcony::app
