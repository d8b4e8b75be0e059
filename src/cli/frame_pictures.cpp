// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/frame_pictures.hpp"

#include <memory>

#include "balcony/inverse.hpp"
#include "balcony/motion.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/default_camera.hpp"

namespace balcony::cli {

bool has_moving_camera(const RenderOptions& options, const scene::Scene& scene) {
    const bool of_scene = options.camera.empty() || is_of_scene(options.camera);
    return of_scene && scene.motion && !scene.motion->cameras.empty();
}

Result<camera::Picture> picture_at(const RenderOptions& options, const scene::Scene& scene,
                                   const camera::Picture& picture, double time) {
    if (!has_moving_camera(options, scene)) {
        return picture;
    }
    scene::Scene moved;
    moved.name = scene.name;
    moved.axes = scene.axes;
    moved.cameras = scene::cameras_at(scene, time);
    Result<camera::Picture> made = options.camera.empty()
                                       ? picture_of(moved.cameras.front(), moved.axes)
                                       : load_picture(options.camera, options.set, moved);
    if (made) {
        *made = made->with_fit(picture.parts().fit);
        const camera::Camera* const camera = picture.only_camera();
        if (camera != nullptr && camera->parts().turn) {
            *made = made->with_turn(*camera->parts().turn);
        }
    }
    return made;
}

Diagnostics add_frames(const RenderOptions& options, const scene::Scene& scene,
                       const camera::Picture& picture,
                       const std::pair<std::size_t, std::size_t>& size,
                       render::Settings& settings) {
    Diagnostics found;
    const auto inverse_at = [&](double time) -> std::shared_ptr<const rays::ImagePointFinder> {
        const Result<camera::Picture> moved = picture_at(options, scene, picture, time);
        found.insert(found.end(), moved.diagnostics.begin(), moved.diagnostics.end());
        if (!moved) {
            return nullptr;
        }
        const Result<analyse::Locator> locator =
            analyse::Locator::make(*moved, static_cast<double>(size.first),
                                   static_cast<double>(size.second), time, scene.axes);
        found.insert(found.end(), locator.diagnostics.begin(), locator.diagnostics.end());
        return locator ? std::make_shared<const analyse::Locator>(*locator) : nullptr;
    };
    render::FrameSettings& frames = settings.frames;
    frames.previous = inverse_at(settings.time - frames.duration);
    frames.next = inverse_at(settings.time + frames.duration);
    return found;
}

}  // namespace balcony::cli
