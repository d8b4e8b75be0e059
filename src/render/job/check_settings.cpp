// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/check_settings.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/names.hpp"
#include "render/integrators/integrator.hpp"
#include "render/sampling/pass_offset.hpp"

namespace balcony::render {

namespace {

constexpr std::size_t max_samples = std::size_t{1} << 24;
constexpr std::size_t max_threads = 4096;

bool is_finite(const Color3f& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

template <class Info>
Diagnostic unknown(std::string_view kind, const std::string& name, std::span<const Info> known) {
    std::vector<std::string> names;
    for (const Info& info : known) {
        names.emplace_back(info.name);
    }
    return error(
        fmt::format("unknown {} '{}'", kind, name), {},
        did_you_mean(name, names, fmt::format("the {}s are {}", kind, fmt::join(names, ", "))));
}

}  // namespace

Diagnostics check(const Settings& settings) {
    Diagnostics found;
    const auto within = [&](std::size_t value, std::size_t minimum, std::size_t maximum,
                            std::string_view what) {
        if (value < minimum || value > maximum) {
            found.push_back(error(fmt::format("{} {} is out of range", what, value), {},
                                  fmt::format("give a number from {} to {}", minimum, maximum)));
        }
    };
    within(settings.samples, 1, max_samples, "the number of samples");
    within(settings.threads, 0, max_threads, "the number of threads");
    if (!std::isfinite(settings.time) || !is_finite(settings.ambient.value_or(Color3f(0.0F))) ||
        !is_finite(settings.background.value_or(Color3f(0.0F)))) {
        found.push_back(error("time, ambient light and background must be finite numbers"));
    }
    if (!(settings.shutter.duration >= 0.0) || !std::isfinite(settings.shutter.duration)) {
        found.push_back(error("the shutter is open for a time that is not a number of seconds", {},
                              "give a duration of at least 0"));
    }
    const double sun_angle = settings.light.sun_angle.value_or(0.0);
    if (!(sun_angle >= 0.0 && sun_angle <= std::numbers::pi)) {
        found.push_back(
            error("the angle of suns is out of range", {}, "give radians from 0 to pi"));
    }
    if (!(settings.frames.duration > 0.0) || !std::isfinite(settings.frames.duration)) {
        found.push_back(error("the time from frame to frame is not a number of seconds", {},
                              "give a duration above 0, such as 1/24"));
    }
    const IntegratorRow* const integrator = find_integrator(settings.integrator);
    if (integrator == nullptr) {
        found.push_back(unknown("integrator", settings.integrator, integrators()));
    } else if (integrator->check != nullptr) {
        const Diagnostics own = integrator->check(settings);
        found.insert(found.end(), own.begin(), own.end());
    }
    if (!(settings.sampling.noise >= 0.0) || !std::isfinite(settings.sampling.noise)) {
        found.push_back(error("the noise level must be a finite number, 0 or more"));
    }
    if (const double white = settings.sampling.white.value_or(1.0);
        !(white > 0.0) || !std::isfinite(white)) {
        found.push_back(error("the radiance of white must be a finite number above 0"));
    }
    if (find_pixel_filter(settings.sampling.filter) == nullptr) {
        found.push_back(unknown("pixel filter", settings.sampling.filter, pixel_filters()));
    }
    return found;
}

}  // namespace balcony::render
