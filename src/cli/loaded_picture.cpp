// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/loaded_picture.hpp"

#include <chrono>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/rays.hpp"
#include "cli/options/fit_options.hpp"
#include "cli/options/scene_argument.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

// When rays meet the scene: while the shutter is open, and at the times that the cameras give them.
scene::TimeInterval times_of_rays(const render::Settings& settings,
                                  const std::optional<camera::Picture>& picture,
                                  RenderReport& outcome) {
    const scene::TimeInterval exposure = settings.shutter.exposure(settings.time);
    if (!picture) {
        return exposure;
    }
    const Result<rays::RayTimes> times = rays::ray_times(*picture, {exposure.begin, exposure.end});
    add(outcome, times.diagnostics);
    return times ? scene::TimeInterval{times->first, times->last} : exposure;
}

}  // namespace

bool read_scene(const std::string& name, const Request& request, Loaded& loaded,
                RenderReport& outcome) {
    if (loaded.scene) {
        return true;
    }
    const auto begin = std::chrono::steady_clock::now();
    auto scene = load_scene(name, request.settings.time, request.added);
    loaded.load_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    add(outcome, scene.diagnostics);
    if (!scene) {
        return false;
    }
    loaded.scene = std::make_shared<const scene::Scene>(std::move(*scene));
    return true;
}

bool load(const std::string& name, const Request& request,
          const std::optional<camera::Picture>& picture, Loaded& loaded, RenderReport& outcome) {
    const render::Settings& settings = request.settings;
    const scene::TimeInterval times = times_of_rays(settings, picture, outcome);
    if (loaded.renderer && times.begin == loaded.times.begin && times.end == loaded.times.end) {
        return true;
    }
    if (!read_scene(name, request, loaded, outcome)) {
        return false;
    }
    auto renderer = render::Renderer::make(
        loaded.scene, {.texture_memory = request.texture_memory, .interval = times});
    add(outcome, renderer.diagnostics);
    loaded.renderer = std::move(renderer.value);
    loaded.times = times;
    return loaded.renderer.has_value();
}

void describe_preparation(RenderReport& report, const Loaded& loaded) {
    const render::Renderer::Preparation& preparation = loaded.renderer->preparation();
    report.facts["load_seconds"] = loaded.load_seconds;
    report.facts["build_seconds"] = preparation.build_seconds;
    report.facts["texture_seconds"] = preparation.texture_seconds;
    report.sentence += fitted_text(loaded.cameras);
    // Most scenes are ready at once.
    constexpr double noticeable = 0.5;
    const double preparing = preparation.build_seconds + preparation.texture_seconds;
    if (loaded.load_seconds + preparing >= noticeable) {
        report.sentence +=
            fmt::format("  scene read in {}, prepared in {}\n", duration_text(loaded.load_seconds),
                        duration_text(preparing));
    }
}

}  // namespace balcony::cli
