// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/default_camera.hpp"

#include "balcony/probe.hpp"
#include "balcony/scene_camera.hpp"

namespace balcony::cli {

Result<camera::Picture> default_picture(const scene::Scene& scene) {
    const Result<scene::Camera> view = scene.cameras.empty()
                                           ? render::default_camera(scene)
                                           : Result<scene::Camera>(scene.cameras.front());
    if (!view) {
        return view.diagnostics;
    }
    auto made = data::make_camera(*view, scene.axes);
    return made ? Result<camera::Picture>(std::move(*made), std::move(made.diagnostics))
                : Result<camera::Picture>(std::move(made.diagnostics));
}

}  // namespace balcony::cli
