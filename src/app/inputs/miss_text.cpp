// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/inputs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/names.hpp"

namespace balcony::app {

namespace {

std::string point_text(const Imath::V3d& p) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z);
}

MissText text_of(const render::Miss::Attempt& attempt, const camera::Camera& camera) {
    const std::string objects = counted(attempt.objects, "object");
    switch (attempt.change) {
        case render::RayChange::reversed:
            return {fmt::format("in the opposite direction, they would meet {}", objects),
                    camera.parts().toward
                        ? "move the direction object to the other side of the eye"
                        : "it looks from within a room; for an object, take --camera every_side or "
                          "rollout, or look to the other side of the eye object in a file of your "
                          "own: look normal(back), or normal(front) if it is back now"};
        case render::RayChange::other_axes: {
            const bool z_up = camera.parts().axes == Axes::z_up;
            return {
                fmt::format("with 'axes {}', they would meet {}", z_up ? "y_up" : "z_up", objects),
                fmt::format("the camera is written with {} up; declare the axes that its "
                            "numbers are meant in",
                            z_up ? "z" : "y")};
        }
        case render::RayChange::scaled: break;
    }
    return {fmt::format("with lengths {:g} times as large, they would meet {}", attempt.factor,
                        objects),
            fmt::format("the camera and the scene seem to have different units; add move "
                        "scale({:g}) to the camera",
                        attempt.factor)};
}

}  // namespace

bool starts_outside(const render::Miss& miss) {
    return !miss.origins.isEmpty() && !miss.bounds.intersects(miss.origins);
}

MissText miss_text(const render::Miss& miss, const camera::Camera& camera) {
    const auto best =
        std::max_element(miss.attempts.begin(), miss.attempts.end(),
                         [](const auto& a, const auto& b) { return a.objects < b.objects; });
    if (best != miss.attempts.end()) {
        return text_of(*best, camera);
    }
    if (miss.bounds.isEmpty()) {
        return {"the scene has no surface", "add an object to it"};
    }
    const std::string scene = fmt::format("the scene, {} .. {}", point_text(miss.bounds.min),
                                          point_text(miss.bounds.max));
    if (starts_outside(miss)) {
        return {fmt::format("they start outside {}, near {}, and pass it", scene,
                            point_text(0.5 * (miss.origins.min + miss.origins.max))),
                "move the camera, turn it towards the scene, or let the scene place it: --fit, if "
                "its file has a fit statement"};
    }
    return {fmt::format("they start within {}, but no object is in their way", scene),
            "turn the camera, or move it"};
}

}  // namespace balcony::app
