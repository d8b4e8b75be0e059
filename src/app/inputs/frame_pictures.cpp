// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/inputs/frame_pictures.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "app/words.hpp"
#include "balcony/expr.hpp"
#include "balcony/inputs.hpp"
#include "balcony/inverse.hpp"
#include "balcony/motion.hpp"

namespace balcony::app {

namespace {

bool depends_on_time(const expr::Expr& value) {
    return value.dependence().intersects(expr::Dependence::on(expr::inputs::t));
}

bool depends_on_time(const camera::RayExpressions& ray) {
    const auto& o = ray.origin;
    const auto& d = ray.direction;
    bool found = ray.time.has_value() || depends_on_time(ray.valid);
    for (const expr::Expr& value : {o.x, o.y, o.z, d.x, d.y, d.z}) {
        found = found || depends_on_time(value);
    }
    return found;
}

bool depends_on_time(const std::vector<camera::PictureExpressions::Element>& elements) {
    return std::any_of(elements.begin(), elements.end(), [](const auto& element) {
        return depends_on_time(element.coverage) || depends_on_time(element.group) ||
               (element.ray && depends_on_time(*element.ray));
    });
}

// Whether all rays are the same at all times.
bool is_at_rest(const camera::Picture& picture, const std::pair<std::size_t, std::size_t>& size) {
    expr::Graph graph;
    const camera::PictureExpressions made =
        picture.emit(graph, static_cast<double>(size.first), static_cast<double>(size.second));
    return !depends_on_time(made.elements);
}

}  // namespace

bool has_moving_camera(const Request& request, const scene::Scene& scene) {
    const bool of_scene = request.camera.empty() || is_of_scene(request.camera);
    return of_scene && scene.motion && !scene.motion->cameras.empty();
}

Result<camera::Picture> picture_at(const Request& request, const scene::Scene& scene,
                                   const camera::Picture& picture, double time) {
    if (!has_moving_camera(request, scene)) {
        return picture;
    }
    scene::Scene moved;
    moved.name = scene.name;
    moved.axes = scene.axes;
    moved.cameras = scene::cameras_at(scene, time);
    Result<camera::Picture> made = request.camera.empty()
                                       ? picture_of(moved.cameras.front(), moved.axes)
                                       : load_picture(request.camera, request.set, moved);
    if (made) {
        *made = made->with_fit(picture.parts().fit);
        const camera::Camera* const camera = picture.only_camera();
        if (camera != nullptr && camera->parts().turn) {
            *made = made->with_turn(*camera->parts().turn);
        }
    }
    return made;
}

FrameInverses::Inverse FrameInverses::at(double time, const scene::Scene& scene,
                                         const camera::Picture& picture,
                                         const std::stop_token& stop, Diagnostics& found) {
    const bool rests = !has_moving_camera(request_, scene) && is_at_rest(picture, size_);
    const double key = rests ? 0.0 : time;
    // Rounding separates a time that is reached from both sides.
    constexpr double rounding = 1e-9;
    const auto known = inverses_.lower_bound(key - rounding);
    if (known != inverses_.end() && known->first <= key + rounding) {
        return known->second;
    }
    const Result<camera::Picture> moved = picture_at(request_, scene, picture, time);
    add(found, moved.diagnostics);
    Inverse inverse;
    if (moved) {
        const auto locator =
            analyse::Locator::make(*moved, static_cast<double>(size_.first),
                                   static_cast<double>(size_.second), time, scene.axes, {}, stop);
        add(found, locator.diagnostics);
        inverse = locator ? std::make_shared<const analyse::Locator>(*locator) : nullptr;
        ++made_;
    }
    inverses_.emplace(key, inverse);
    return inverse;
}

Diagnostics FrameInverses::add_to(render::Settings& settings, const scene::Scene& scene,
                                  const camera::Picture& picture, const std::stop_token& stop) {
    Diagnostics found;
    render::FrameSettings& frames = settings.frames;
    frames.previous = at(settings.time - frames.duration, scene, picture, stop, found);
    frames.next = at(settings.time + frames.duration, scene, picture, stop, found);
    // A later frame needs none that is further back than its own time.
    if (inverses_.size() > 1) {
        inverses_.erase(inverses_.begin(),
                        inverses_.lower_bound(settings.time - 0.5 * frames.duration));
    }
    return found;
}

}  // namespace balcony::app
