// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/inputs/true_scale.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace balcony::app {

void set_unit(scene::Scene& scene, const std::optional<double>& meters_per_unit) {
    if (meters_per_unit) {
        scene.meters_per_unit = *meters_per_unit;
        scene.has_unit = true;
    }
}

Diagnostic no_scale(std::string_view option, const std::string& name) {
    return error(Kind::usage,
                 fmt::format("{}: '{}' has no scale, as nothing says how large its picture is in "
                             "the scene",
                             option, name),
                 "take rollout, rollout_profile, cylinder, orthographic, street_strip or "
                 "pushbroom, or write the sides of the picture in scene units: aspect (WIDTH, "
                 "HEIGHT)");
}

Result<camera::Picture> at_true_scale(const Request& request, const scene::Scene& scene,
                                      camera::Picture picture) {
    if (!request.mm_per_pixel) {
        return picture;
    }
    const auto sides = picture.sides();
    if (!sides) {
        return no_scale("--mm-per-pixel", picture.name());
    }
    if (!scene.has_unit) {
        return error(
            Kind::usage,
            fmt::format("--mm-per-pixel: '{}' does not say how long its unit is", scene.name),
            "add --unit mm, cm, m, in or ft");
    }
    std::array<std::size_t, 2> size{};
    for (std::size_t i = 0; i < 2; ++i) {
        const double millimeters = 1000.0 * scene.meters_per_unit * (*sides)[i];
        const double pixels = std::round(millimeters / *request.mm_per_pixel);
        if (!(pixels >= 1.0 && pixels <= static_cast<double>(max_side))) {
            return error(Kind::usage,
                         fmt::format("--mm-per-pixel: a side of {:.6g} mm has {:.0f} pixels",
                                     millimeters, pixels),
                         fmt::format("a side has 1 to {} pixels; is --unit right?", max_side));
        }
        size[i] = static_cast<std::size_t>(pixels);
    }
    return picture.with_size(size);
}

}  // namespace balcony::app
