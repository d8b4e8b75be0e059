// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/default_camera.hpp"

#include "balcony/scene_camera.hpp"

namespace balcony::cli {

Result<camera::Picture> picture_of(const scene::Camera& camera, Axes axes) {
    auto made = data::make_camera(camera, axes);
    return made ? Result<camera::Picture>(std::move(*made), std::move(made.diagnostics))
                : Result<camera::Picture>(std::move(made.diagnostics));
}

Result<camera::Picture> default_picture(const scene::Scene& scene,
                                        const render::Renderer& renderer) {
    if (!scene.cameras.empty()) {
        return picture_of(scene.cameras.front(), scene.axes);
    }
    const Result<scene::Camera> view = renderer.default_camera();
    return view ? picture_of(*view, scene.axes) : Result<camera::Picture>(view.diagnostics);
}

}  // namespace balcony::cli
